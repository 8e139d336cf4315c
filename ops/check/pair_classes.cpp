#include "ops/check/pair_classes.h"

#include <map>
#include <set>

#include "core/scene/friction.h"
#include "ops/base/refusal.h"

namespace trivet {
namespace {

using NamePair = std::pair<std::string, std::string>;

NamePair in_order(const std::string& a, const std::string& b) {
  return a < b ? NamePair(a, b) : NamePair(b, a);
}

// Objects of one kind are alike: one of each, and how many there are.
struct AlikeObjects {
  const Object* one;
  size_t count;
};
std::vector<AlikeObjects> alike_objects(const Scene& scene) {
  std::map<std::pair<PairKind, bool>, AlikeObjects> found;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    auto& [one, count] = found[{object.pair_kind, object.fixed}];
    one = &object, ++count;
  }
  std::vector<AlikeObjects> out;
  out.reserve(found.size());
  for (const auto& [key, alike] : found) out.push_back(alike);
  return out;
}

size_t num_judged(const Scene& scene) {
  const std::vector<AlikeObjects> all = alike_objects(scene);
  size_t out = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    const AlikeObjects& a = all[i];
    if (scene.floor && !a.one->fixed && !may_pass_floor(scene, *a.one)) out += a.count;
    for (size_t j = i; j < all.size(); ++j) {
      const AlikeObjects& b = all[j];
      if ((a.one->fixed && b.one->fixed) || may_pass(scene, *a.one, *b.one)) continue;
      out += i == j ? a.count * (a.count - 1) / 2 : a.count * b.count;
    }
  }
  return out;
}

bool is_fixed_or_floor(const Scene& scene, const std::string& name) {
  const auto id = scene.find(name);
  return !id || scene.at(*id).fixed;
}

class PairSorter {
 public:
  PairSorter(const Scene& scene, const SceneCheck& check) : m_scene(scene) {
    for (const auto& f : check.touching) m_flush[in_order(f.a, f.b)] = -f.depth;
    for (const auto* findings : {&check.crossings, &check.contained, &check.float32_crossings})
      for (const auto& f : *findings)
        if (counts(f.a, f.b) && !m_flush.count(in_order(f.a, f.b)))
          m_through.insert(in_order(f.a, f.b));
  }

  PairClasses sorted() {
    PairClasses out;
    for (const ObjectId id : m_scene.ids())
      for (const ObjectContact& c : m_scene.at(id).contacts)
        if (!c.across_gap)
          add(m_scene.at(id).name, named(m_scene, c.with).name, c.contact.gap, out);
    for (const auto& [pair, gap] : m_flush) add(pair.first, pair.second, gap, out);
    out.num_through = m_through.size();
    const size_t judged = num_judged(m_scene), near = out.num_through + out.touching.size();
    out.num_apart = judged > near ? judged - near : 0;
    return out;
  }

 private:
  bool counts(const std::string& a, const std::string& b) const {
    return !is_fixed_or_floor(m_scene, a) || !is_fixed_or_floor(m_scene, b);
  }

  void add(const std::string& a, const std::string& b, double gap, PairClasses& out) {
    const NamePair pair = in_order(a, b);
    if (!counts(a, b) || m_through.count(pair) || !m_seen.insert(pair).second) return;
    const auto flush = m_flush.find(pair);
    out.touching.push_back({a, b, flush == m_flush.end() ? gap : flush->second});
  }

  const Scene& m_scene;
  std::map<NamePair, double> m_flush;
  std::set<NamePair> m_through, m_seen;
};

}  // namespace

PairClasses pair_classes(const Scene& scene, const SceneCheck& check) {
  return PairSorter(scene, check).sorted();
}

}  // namespace trivet
