#include "core/io/simulators/simulation_files.h"

#include <algorithm>
#include <charconv>

#include "core/base/hash.h"
#include "core/base/printable.h"
#include "core/io/appearance.h"
#include "core/io/simulators/looked_files.h"

namespace trivet {
namespace {

constexpr const char* kMtl = "materials.mtl";  // until the hash is known

/// The faces of one material as a separate model.
std::shared_ptr<const Model> with_faces(const Model& model, const MaterialFaces& group) {
  auto out = std::make_shared<Model>();
  std::vector<Triangle> triangles;
  for (const Index f : group.faces) triangles.push_back(model.mesh.triangle(f));
  out->mesh = weld(triangles);
  out->materials = {material_or_default(model, group.material)};
  return out;
}

std::shared_ptr<const Model> model_of(const ConvexPart& part) {
  auto out = std::make_shared<Model>();
  out->mesh.vertices = part.vertices;
  out->mesh.triangles = part.triangles;
  return out;
}

void replace_first(std::string& text, const std::string& what, const std::string& by) {
  if (const size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

}  // namespace

MeshFiles::MeshFiles(const SimulationScene& scene, bool by_material) {
  const ImageFiles images(scene);
  m_files = images.files();
  for (size_t i = 0; i < scene.models.size(); ++i) {
    const SimulationModel& model = scene.models[i];
    ModelFiles files = model.look ? looked_model(model, images.of_model(i), by_material)
                                  : plain_model(model, by_material);
    add_parts(model, files);
    files.scale = model.scale;
    m_models.push_back(std::move(files));
  }
}

std::string MeshFiles::add_text(const std::string& stem, ObjText text, bool with_materials) {
  replace_first(text.obj, "metres, z up", "z up; metres, times the scale in a scene file");
  std::string name = stem;
  name += "_" + Hash().add(text.obj).add(with_materials ? text.mtl : "").text();
  if (with_materials) {
    replace_first(text.obj, kMtl, name + ".mtl");
    m_files.push_back({name + ".mtl", std::move(text.mtl)});
  } else {
    replace_first(text.obj, std::string("mtllib ") + kMtl + "\n", "");
  }
  m_files.push_back({name + ".obj", std::move(text.obj)});
  return m_files.back().name;
}

std::string MeshFiles::add_obj(const std::string& stem, const std::shared_ptr<const Model>& model,
                               const Affine& file_from_object, bool with_materials) {
  ExportScene scene;
  scene.objects.push_back({stem, model, file_from_object, ""});
  return add_text(stem, obj_text(scene, kMtl), with_materials);
}

ModelFiles MeshFiles::plain_model(const SimulationModel& model, bool by_material) {
  ModelFiles out;
  const std::vector<MaterialFaces> groups = faces_by_material(*model.model);
  const bool needs_whole = !by_material || model.parts.empty() || groups.size() == 1;
  if (needs_whole)
    out.whole = add_obj(model.name, model.model, model.file_from_object, !by_material);
  if (!by_material) return out;
  for (const MaterialFaces& group : groups) {
    const std::string file =
        groups.size() == 1
            ? out.whole
            : add_obj(model.name + "_m" + std::to_string(group.material),
                      with_faces(*model.model, group), model.file_from_object, false);
    out.visuals.push_back({file, material_or_default(*model.model, group.material), ""});
  }
  return out;
}

ModelFiles MeshFiles::looked_model(const SimulationModel& model,
                                   const std::vector<std::string>& images, bool by_material) {
  ModelFiles out;
  const std::vector<MaterialFaces> groups = faces_of_look(*model.look);
  if (!by_material || model.parts.empty())
    out.whole = add_text(model.name, looked_obj(model, groups, images, kMtl), !by_material);
  if (!by_material) return out;
  for (const MaterialFaces& group : groups) {
    const auto material = static_cast<size_t>(group.material);
    const std::string stem = model.name + "_m" + std::to_string(group.material);
    out.visuals.push_back({add_text(stem, looked_obj(model, {group}, images, kMtl), false),
                           model.look->materials[material], images[material]});
  }
  return out;
}

void MeshFiles::add_parts(const SimulationModel& model, ModelFiles& out) {
  for (const ConvexPart& part : model.parts)
    out.parts.push_back(add_obj(model.name + "_c", model_of(part), {}, false));
  if (out.parts.empty()) out.parts.push_back(out.whole);
}

std::string number_text(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value + 0.0).ptr};
}

std::string numbers_text(std::initializer_list<double> values, const char* separator) {
  std::string out;
  for (const double value : values) {
    if (!out.empty()) out += separator;
    out += number_text(value);
  }
  return out;
}

std::string vector_text(const Vec3& v) { return numbers_text({v.x(), v.y(), v.z()}); }

tinyxml2::XMLElement* add_child(
    tinyxml2::XMLNode* parent, const char* tag,
    std::initializer_list<std::pair<const char*, std::string>> attributes) {
  tinyxml2::XMLElement* const child = parent->GetDocument()->NewElement(tag);
  parent->InsertEndChild(child);
  for (const auto& [key, value] : attributes) child->SetAttribute(key, value.c_str());
  return child;
}

tinyxml2::XMLElement* add_text(tinyxml2::XMLNode* parent, const char* tag,
                               const std::string& text) {
  tinyxml2::XMLElement* const child = add_child(parent, tag);
  child->SetText(text.c_str());
  return child;
}

std::string xml_text(const tinyxml2::XMLDocument& document) {
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

namespace {

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }

/// A digit or the like: names do not begin with it.
bool is_ascii_sign(char c) { return static_cast<unsigned char>(c) < 0x80 && !is_letter(c); }

/// XML has no controls, and no U+FFFE and U+FFFF.
bool is_printed(const std::string& character) {
  return printable(character) == character && character != "\xef\xbf\xbe" &&
         character != "\xef\xbf\xbf";
}

std::string valid_name(const std::string& name, NameRule rule) {
  const bool in_xml = rule == NameRule::Xml;
  std::string out;
  for (size_t at = 0; at < name.size();) {
    const char c = name[at];
    const size_t length = std::max<size_t>(utf8_length(name, at), 1);
    const std::string character = name.substr(at, length);
    const bool is_plain = is_letter(c) || ('0' <= c && c <= '9');
    const bool is_of_xml = c == '-' || c == '.' || (length > 1 && is_printed(character));
    out += is_plain || (in_xml && is_of_xml) ? character : "_";
    at += length;
  }
  if (out.empty() || is_ascii_sign(out[0])) out.insert(0, 1, '_');
  return out;
}

}  // namespace

std::vector<std::string> valid_names(const std::vector<std::string>& names, NameRule rule,
                                     std::set<std::string> taken) {
  std::vector<std::string> out(names.size());
  for (size_t i = 0; i < names.size(); ++i)
    if (valid_name(names[i], rule) == names[i] && taken.insert(names[i]).second) out[i] = names[i];
  for (size_t i = 0; i < names.size(); ++i) {
    if (!out[i].empty()) continue;
    const std::string base = valid_name(names[i], rule);
    out[i] = base;
    for (int k = 2; !taken.insert(out[i]).second; ++k) out[i] = base + "_" + std::to_string(k);
  }
  return out;
}

}  // namespace trivet
