#include "core/io/threemf/object_reader.h"

#include <algorithm>
#include <set>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/colour.h"
#include "core/io/surface/file_surface.h"
#include "core/io/text/words.h"

namespace trivet::threemf {
namespace {

constexpr std::pair<std::string_view, double> kUnits[] = {
    {"micron", 1e-6}, {"millimeter", 0.001}, {"centimeter", 0.01},
    {"inch", 0.0254}, {"foot", 0.3048},      {"meter", 1}};

// Extensions that change no geometry, or are read.
bool is_known_extension(std::string_view uri) {
  static constexpr std::string_view kKnown[] = {"/production/", "/material/", "/slice/",
                                                "/trianglesets/"};
  return std::any_of(std::begin(kKnown), std::end(kKnown),
                     [&](std::string_view k) { return uri.find(k) != uri.npos; });
}

class PartReader {
 public:
  PartReader(const std::string& file, const std::string& part, bool is_root,
             const ImportLimits& limits, Document& out)
      : m_file(file), m_part(part), m_is_root(is_root), m_limits(limits), m_out(out) {}

  void read(const std::string& xml) {
    read_xml_part(m_file, m_part, xml,
                  {[&](const XmlElement& e) { begin(e); },
                   [&](std::string_view name, size_t) { end(name); }});
    note_count(m_out.notes,
               "triangles whose corners have different colours, of which the first is "
               "taken",
               m_num_mixed);
    note_count(m_out.notes,
               "properties of triangles left out that are neither materials nor colours",
               m_num_unknown_properties);
    note_count(m_out.notes, "items read that are marked as not to be printed", m_num_unprinted);
    for (const std::string& name : m_left_out)
      m_out.notes.push_back(say("left out: %1", Sentence(name.c_str())));
  }

 private:
  [[noreturn]] void fail(const Sentence& reason) const {
    bad_file(m_file, "%1: %2", m_part, reason);
  }

  void begin(const XmlElement& e) {
    const std::string_view name = e.name();
    if (name == "vertex") return add_vertex(e);
    if (name == "triangle") return add_triangle(e);
    if (name == "model") return begin_model(e);
    if (name == "object") return begin_object(e);
    if (name == "component" || name == "item") return add_component(e, name == "item");
    if (name == "basematerials" || name == "colorgroup") return begin_group(e);
    if (name == "base" || name == "color") return add_material(e);
    if (name == "texture2dgroup" || name == "compositematerials" || name == "multiproperties")
      m_left_out.insert(TRIVET_SENTENCE("textures and mixed materials"));
    if (name == "slicestack") m_left_out.insert(TRIVET_SENTENCE("slices"));
    if (name == "beamlattice") m_left_out.insert(TRIVET_SENTENCE("lattices of beams"));
  }

  void end(std::string_view name) {
    if (name == "object") m_object = nullptr;
    if (name == "basematerials" || name == "colorgroup") m_group.clear();
  }

  void begin_model(const XmlElement& e) {
    if (m_is_root) read_unit(e.find("unit"));
    const char* const required = e.find("requiredextensions");
    std::string_view rest = required ? required : "";
    for (std::string_view prefix = next_word(rest); !prefix.empty(); prefix = next_word(rest)) {
      const char* const uri = e.find("xmlns:" + std::string(prefix));
      if (!is_known_extension(uri ? uri : ""))
        fail(say("requires the extension \"%1\"; accepted: production, materials, slices",
                 printable(uri ? uri : std::string(prefix).c_str(), 100)));
    }
  }

  void read_unit(const char* unit) {
    if (!unit) return;
    for (const auto& [name, metres] : kUnits)
      if (equal_words(trimmed(unit), name)) {
        m_out.metres_per_unit = metres;
        return;
      }
    m_out.notes.push_back(
        say("the unit \"%1\" is unknown; millimetres are taken", printable(unit, 40)));
  }

  const char* text(const XmlElement& e, const char* attribute) const {
    const char* const found = e.find(attribute);
    if (!found)
      fail(say("an element \"%1\" without its %2", std::string(e.name()), std::string(attribute)));
    return found;
  }

  double number(const XmlElement& e, const char* attribute) const {
    const std::string_view value = text(e, attribute);
    const auto found = number_from(trimmed(value));
    if (!found) fail(say("\"%1\" is not a number", printable(value, 40)));
    return *found;
  }

  Index index(const XmlElement& e, const char* attribute, size_t count,
              const Sentence& what) const {
    const std::string_view value = text(e, attribute);
    const auto found = integer_from(trimmed(value));
    if (!found || *found < 0 || static_cast<size_t>(*found) >= count)
      fail(say("a reference to %1 %2 of %3", what, printable(value, 40), count));
    return static_cast<Index>(*found);
  }

  void begin_object(const XmlElement& e) {
    const ObjectKey key(m_part, text(e, "id"));
    m_object = &m_out.objects[key];
    if (m_is_root) m_out.order.push_back(key);
    if (const char* const name = e.find("name")) m_object->name = name;
    const char* const type = e.find("type");
    m_object->is_support =
        type && (std::string_view(type) == "support" || std::string_view(type) == "solidsupport");
    const char* const pid = e.find("pid");
    m_object_pid = pid ? pid : "";
    m_object->material = material_of(m_object_pid, e.find("pindex"));
  }

  void add_vertex(const XmlElement& e) {
    if (!m_object) return;
    if (m_object->vertices.size() > 3 * static_cast<size_t>(m_limits.max_triangles))
      fail("too many vertices");
    m_object->vertices.emplace_back(number(e, "x"), number(e, "y"), number(e, "z"));
  }

  void add_triangle(const XmlElement& e) {
    if (!m_object) return;
    const size_t count = m_object->vertices.size();
    Triangle3 t;
    const char* const names[] = {"v1", "v2", "v3"};
    for (int k = 0; k < 3; ++k) t.vertices[k] = index(e, names[k], count, "vertex");
    const char *const p1 = e.find("p1"), *const p2 = e.find("p2"), *const p3 = e.find("p3");
    m_num_mixed += p1 && ((p2 && std::string_view(p1) != p2) || (p3 && std::string_view(p1) != p3));
    if (p1) {
      const char* const pid = e.find("pid");
      t.material = material_of(pid ? pid : m_object_pid, p1);
    }
    m_object->triangles.push_back(t);
  }

  void add_component(const XmlElement& e, bool item) {
    if (item ? !m_is_root : !m_object) return;
    Component out;
    const char* const path = e.find("path");
    std::string part = path ? path : m_part;
    while (part.starts_with('/')) part.erase(0, 1);
    out.object = {part, text(e, "objectid")};
    if (const char* const transform = e.find("transform"))
      out.parent_from_object = transform_from(transform);
    const char* const printed = item ? e.find("printable") : nullptr;
    m_num_unprinted +=
        printed && (equal_words(trimmed(printed), "0") || equal_words(trimmed(printed), "false"));
    (item ? m_out.items : m_object->components).push_back(out);
  }

  // The transform acts on row vectors: the last three numbers move.
  Affine transform_from(const std::string& given) const {
    std::string_view rest = given;
    std::array<double, 12> m{};
    for (double& value : m) {
      const auto found = number_from(next_word(rest));
      if (!found) fail(say("a transform that is not 12 numbers: \"%1\"", printable(given, 80)));
      value = *found;
    }
    if (!next_word(rest).empty())
      fail(say("a transform that is not 12 numbers: \"%1\"", printable(given, 80)));
    Affine out;
    for (size_t r = 0; r < 3; ++r) {
      for (size_t c = 0; c < 3; ++c)
        out.linear(static_cast<int>(r), static_cast<int>(c)) = m[3 * c + r];
      out.translation[static_cast<int>(r)] = m[9 + r];
    }
    return out;
  }

  void begin_group(const XmlElement& e) {
    m_group = text(e, "id");
    m_groups.emplace(m_group, std::vector<Index>());
  }

  void add_material(const XmlElement& e) {
    if (m_group.empty()) return;
    FileMaterial material;
    if (const char* const name = e.find("name")) material.surface.name = name;
    const char* const colour = e.find(e.name() == "base" ? "displaycolor" : "color");
    if (colour) read_colour(colour, material.surface);
    m_groups[m_group].push_back(static_cast<Index>(m_out.materials.size()));
    m_out.materials.push_back(std::move(material));
  }

  // "#RRGGBB" or "#RRGGBBAA", sRGB.
  static void read_colour(std::string_view text, Material& out) {
    if (text.size() != 7 && text.size() != 9) return;
    for (size_t i = 0; 2 * i + 2 < text.size(); ++i) {
      unsigned value = 0;
      const std::string_view digits = text.substr(1 + 2 * i, 2);
      std::from_chars(digits.data(), digits.data() + 2, value, 16);
      const float part = static_cast<float>(value) / 255.0f;
      out.base_colour[i] = i < 3 ? linear_from_srgb(part) : part;
    }
  }

  // -1: none, or of a kind that is not read.
  Index material_of(const std::string& group, const char* id) {
    if (group.empty() || !id) return -1;
    const auto found = m_groups.find(group);
    const auto number = integer_from(id);
    const bool valid = found != m_groups.end() && number && *number >= 0 &&
                       static_cast<size_t>(*number) < found->second.size();
    m_num_unknown_properties += !valid;
    return valid ? found->second[static_cast<size_t>(*number)] : -1;
  }

  const std::string m_file, m_part;
  const bool m_is_root;
  const ImportLimits& m_limits;
  Document& m_out;
  MeshObject* m_object = nullptr;
  std::string m_group, m_object_pid;
  std::map<std::string, std::vector<Index>> m_groups;  // of this part: ids of materials
  std::set<std::string> m_left_out;
  std::int64_t m_num_mixed = 0, m_num_unknown_properties = 0, m_num_unprinted = 0;
};

}  // namespace

void read_model_part(const std::string& file, const std::string& part, const std::string& xml,
                     bool is_root, const ImportLimits& limits, Document& document) {
  PartReader(file, part, is_root, limits, document).read(xml);
}

void read_xml_part(const std::string& file, const std::string& part, std::string_view xml,
                   const XmlHandlers& handlers) {
  if (const auto fault = read_xml(xml, handlers))
    bad_file(file, "%1, line %2: %3", part, fault->line, fault->why);
}

}  // namespace trivet::threemf
