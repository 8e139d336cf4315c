#include "core/io/foreign/usd/usda_stage.h"

#include <algorithm>

#include "core/base/bad_input.h"
#include "core/io/foreign/scene.h"
#include "core/io/foreign/usd/usda_stacks.h"

namespace trivet {
namespace {

constexpr size_t kMostUsdaSites = 500'000;  // places of opinions, of a stage
constexpr int kMostVariantRounds = 8;       // variants in variants

/// By strength, the strongest first.
enum class Arc { Local, Inherits, Variant, Reference, Payload };

/// A prim as one layer has it.
struct SpecInLayer {
  const UsdaSpec* spec;
  const UsdaLayer* layer;
};

/// Places of opinions about one prim: those of one stack, and those that these refer to.
struct Site {
  Arc arc = Arc::Local;
  const LayerStack* stack = nullptr;
  std::string path;
  std::vector<SpecInLayer> specs;
  std::shared_ptr<const UsdaMapping> mapping;
  std::vector<Site> below;  // the strongest first
};

void collect_opinions(const Site& site, std::vector<UsdaOpinion>& out) {
  for (const SpecInLayer& at : site.specs) out.push_back({at.spec, site.mapping});
  for (const Site& below : site.below) collect_opinions(below, out);
}

std::vector<std::string> path_parts(const std::string& path) {
  std::vector<std::string> out;
  for (size_t begin = 1; begin < path.size();) {
    const size_t end = std::min(path.find('/', begin), path.size());
    out.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

/// Composes a stage, prim by prim from above.
class UsdaComposer {
 public:
  UsdaComposer(UsdaStage& stage, const std::string& path, const XmlLimits& limits,
               const std::vector<std::string>& roots, std::vector<Sentence>& unread)
      : m_stage(stage),
        m_path(path),
        m_limits(limits),
        m_stacks(stage, path, limits, roots, unread),
        m_unread(unread) {}

  void compose() {
    Site top = root_site(m_stacks.main_stack());
    top.mapping = std::make_shared<UsdaMapping>();
    add_children(top, "", false, m_stage.prims, 0);
  }

 private:
  Site root_site(const LayerStack& stack) const {
    Site out;
    out.stack = &stack;
    for (const UsdaLayer* layer : stack) out.specs.push_back({&layer->root, layer});
    return out;
  }

  void count_site() {
    if (++m_num_sites > kMostUsdaSites)
      bad_file(m_path, "becomes too large by its references; accepted: %1 prims in all layers",
               kMostUsdaSites);
  }

  // Opinions about a child where its parent has some; nothing: there are none.
  std::optional<Site> child_site(const Site& parent, const std::string& name) {
    Site out;
    out.arc = parent.arc, out.stack = parent.stack, out.mapping = parent.mapping;
    out.path = parent.path + "/" + name;
    for (const SpecInLayer& at : parent.specs)
      if (const UsdaSpec* const child = at.spec->child(name))
        out.specs.push_back({child, at.layer});
    for (const Site& below : parent.below)
      if (auto site = child_site(below, name)) out.below.push_back(std::move(*site));
    if (out.specs.empty() && out.below.empty()) return std::nullopt;
    count_site();
    return out;
  }

  // Adds all that the prim itself inherits, refers to or loads, at every site that says so.
  void add_arcs(Site& site, const std::string& prim, int depth) {
    for (Site& below : site.below) add_arcs(below, prim, depth);
    std::vector<Site> direct;
    for (const SpecInLayer& at : site.specs)
      for (const UsdaEntry& entry : at.spec->metadata)
        if (const auto arc = arc_of(entry))
          add_targets(site, *at.layer, entry, *arc, depth, direct);
    // From the last to the first: each comes before those that were there.
    for (auto target = direct.rbegin(); target != direct.rend(); ++target) {
      bind(*target, prim);
      insert(site, std::move(*target));
    }
  }

  static std::optional<Arc> arc_of(const UsdaEntry& entry) {
    if (!entry.has_value || entry.op == "delete" || entry.op == "reorder") return std::nullopt;
    if (entry.name == "inherits") return Arc::Inherits;
    if (entry.name == "references") return Arc::Reference;
    if (entry.name == "payload") return Arc::Payload;
    return std::nullopt;
  }

  // Arcs of the prim itself are stronger than those of the same kind above it.
  static void insert(Site& site, Site target) {
    const auto at = std::find_if(site.below.begin(), site.below.end(),
                                 [&](const Site& other) { return other.arc >= target.arc; });
    site.below.insert(at, std::move(target));
  }

  // Paths of what is referred to become those of the prim.
  static void bind(Site& site, const std::string& prim) {
    site.mapping = std::make_shared<UsdaMapping>(UsdaMapping{site.path, prim});
    for (Site& below : site.below) bind(below, prim);
  }

  void add_targets(const Site& site, const UsdaLayer& layer, const UsdaEntry& entry, Arc arc,
                   int depth, std::vector<Site>& out) {
    const auto& words = entry.value.words;
    for (size_t i = 0; i < words.size(); ++i) {
      const bool is_asset = words[i].first == UsdaValue::Kind::Asset;
      const UsdaLayer* target = site.stack->front();
      if (is_asset && !words[i].second.empty()) target = m_stacks.named(words[i].second, layer);
      std::string path = is_asset ? "" : words[i].second;
      // A path behind an asset is a prim of that.
      if (is_asset && i + 1 < words.size() && words[i + 1].first == UsdaValue::Kind::Path)
        path = words[++i].second;
      if (!target) continue;
      if (path.empty()) path = m_stacks.default_prim(*target);
      const LayerStack& stack = m_stacks.stack_of(*target);
      if (depth >= kMostUsdaArcs || is_circle(site, stack, path)) {
        m_stacks.note(layer, "refers to itself, or too deep");
        continue;
      }
      m_on_the_way.emplace_back(&stack, path);
      if (auto found = path.empty() ? std::nullopt : site_at(stack, path, depth + 1)) {
        found->arc = arc;
        out.push_back(std::move(*found));
      }
      m_on_the_way.pop_back();
    }
  }

  // True if what is referred to holds what refers to it.
  bool is_circle(const Site& site, const LayerStack& stack, const std::string& path) const {
    const auto holds = [&](const LayerStack* of, const std::string& inner) {
      return of == &stack && inner.starts_with(path) &&
             (inner.size() == path.size() || inner[path.size()] == '/');
    };
    return holds(site.stack, site.path) ||
           std::any_of(m_on_the_way.begin(), m_on_the_way.end(),
                       [&](const auto& at) { return holds(at.first, at.second); });
  }

  std::optional<Site> site_at(const LayerStack& stack, const std::string& path, int depth) {
    std::optional<Site> site = root_site(stack);
    for (const std::string& name : path_parts(path)) {
      site = child_site(*site, name);
      if (!site) break;
      expand(*site, site->path, depth);
    }
    if (!site || site->path.empty())
      note_once(m_unread, say("%1: has no prim %2", stack.front()->path, path));
    return site && !site->path.empty() ? std::move(site) : std::nullopt;
  }

  void expand(Site& site, const std::string& prim, int depth) {
    add_arcs(site, prim, depth);
    // Variants are chosen when all that may choose them is known.
    for (int round = 0; round < kMostVariantRounds; ++round) {
      std::map<std::string, std::string> chosen;
      choose(site, chosen);
      if (!add_variants(site, chosen, prim, depth)) return;
    }
  }

  // The strongest selection of each set counts.
  static void choose(const Site& site, std::map<std::string, std::string>& out) {
    for (const SpecInLayer& at : site.specs)
      if (const UsdaEntry* const entry = find_entry(at.spec->metadata, "variants")) {
        const auto& words = entry->value.words;
        for (size_t i = 0; i + 1 < words.size(); i += 2)
          out.emplace(words[i].second, words[i + 1].second);
      }
    for (const Site& below : site.below) choose(below, out);
  }

  // @return true: some were added, which may have sets of their own.
  bool add_variants(Site& site, const std::map<std::string, std::string>& chosen,
                    const std::string& prim, int depth) {
    bool any = false;
    for (Site& below : site.below) any |= add_variants(below, chosen, prim, depth);
    std::vector<SpecInLayer> specs;
    for (const SpecInLayer& at : site.specs)
      for (const UsdaSpec& variant : at.spec->variants)
        if (is_chosen(variant, chosen) && !has_spec(site, variant))
          specs.push_back({&variant, at.layer});
    if (specs.empty()) return any;
    Site out;
    out.arc = Arc::Variant, out.stack = site.stack, out.path = site.path;
    out.mapping = site.mapping, out.specs = std::move(specs);
    count_site();
    add_arcs(out, prim, depth);
    insert(site, std::move(out));
    return true;
  }

  // Variants are named "set=variant".
  static bool is_chosen(const UsdaSpec& variant, const std::map<std::string, std::string>& chosen) {
    const size_t end = variant.name.find('=');
    const auto it = chosen.find(variant.name.substr(0, end));
    return it != chosen.end() && variant.name.compare(end + 1, std::string::npos, it->second) == 0;
  }

  static bool has_spec(const Site& site, const UsdaSpec& spec) {
    return std::any_of(site.below.begin(), site.below.end(), [&](const Site& below) {
      return std::any_of(below.specs.begin(), below.specs.end(),
                         [&](const SpecInLayer& at) { return at.spec == &spec; });
    });
  }

  void name_what_is_not_composed(const UsdaPrim& prim) {
    for (const char* key : {"specializes", "relocates", "clips"})
      if (prim.metadata(key))
        note_once(m_unread, say("%1: %2 are not composed", prim.path, std::string(key)));
  }

  // The names of children, those of the weakest opinions first, as USD orders them.
  static void collect_names(const std::vector<UsdaOpinion>& opinions,
                            std::vector<std::string>& out) {
    std::map<std::string_view, bool> known;
    for (auto it = opinions.rbegin(); it != opinions.rend(); ++it)
      for (const UsdaSpec& child : it->spec->children)
        if (known.emplace(child.name, true).second) out.push_back(child.name);
  }

  void add_children(const Site& parent, const std::string& path, bool in_instance,
                    std::vector<UsdaPrim>& out, int depth) {
    if (depth > m_limits.max_depth) bad_file(m_path, "has prims nested too deeply: %1", path);
    std::vector<UsdaOpinion> opinions;
    collect_opinions(parent, opinions);
    std::vector<std::string> names;
    collect_names(opinions, names);
    for (const std::string& name : names) {
      std::optional<Site> site = child_site(parent, name);
      if (!site) continue;
      std::string child_path = path;
      child_path.append("/").append(name);
      expand(*site, child_path, 0);
      UsdaPrim prim;
      prim.path = child_path, prim.name = name, prim.in_instance = in_instance;
      collect_opinions(*site, prim.opinions);
      prim.is_asset = prim.metadata("references") || prim.metadata("payload");
      if (!is_defined(prim)) continue;
      name_what_is_not_composed(prim);
      const bool instance =
          in_instance || (prim.is_asset && is_true(prim.metadata("instanceable")));
      add_children(*site, child_path, instance, prim.children, depth + 1);
      out.push_back(std::move(prim));
    }
  }

  static bool is_true(const UsdaEntry* entry) {
    return entry && ((!entry->value.words.empty() && entry->value.words[0].second == "true") ||
                     (!entry->value.numbers.empty() && entry->value.numbers[0] != 0));
  }

  // Classes, inactive prims, and those that are only spoken about are not in the scene.
  static bool is_defined(UsdaPrim& prim) {
    std::optional<UsdaSpec::Specifier> specifier;
    for (const UsdaOpinion& opinion : prim.opinions) {
      if (!specifier && opinion.spec->specifier != UsdaSpec::Specifier::Over)
        specifier = opinion.spec->specifier;
      if (prim.type.empty()) prim.type = opinion.spec->type;
    }
    const UsdaEntry* const active = prim.metadata("active");
    return specifier == UsdaSpec::Specifier::Def && (!active || is_true(active));
  }

  UsdaStage& m_stage;
  const std::string& m_path;
  XmlLimits m_limits;
  UsdaStacks m_stacks;
  std::vector<Sentence>& m_unread;
  std::vector<std::pair<const LayerStack*, std::string>> m_on_the_way;  // what is referred to
  size_t m_num_sites = 0;
};

}  // namespace

UsdaStage compose_usda(const std::string& path, const XmlLimits& limits,
                       const std::vector<std::string>& roots, std::vector<Sentence>& unread) {
  UsdaStage out;
  UsdaComposer(out, path, limits, roots, unread).compose();
  return out;
}

}  // namespace trivet
