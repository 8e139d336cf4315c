#include "core/io/simulators/simulation_files.h"

#include <algorithm>
#include <charconv>

#include "core/base/hash.h"
#include "core/io/appearance.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

constexpr const char* kMtl = "materials.mtl";  // until the hash is known

// Corners of textures of some faces.
std::vector<std::array<Eigen::Vector2f, 3>> with_faces(const ModelTextures* textures,
                                                       const std::vector<Index>& faces) {
  std::vector<std::array<Eigen::Vector2f, 3>> out;
  for (const Index f : faces)
    if (textures) out.push_back(textures->coordinates[static_cast<size_t>(f)]);
  return out;
}

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

std::vector<std::string> add_textures(const SimulationModel& model, std::vector<MeshFile>& files) {
  if (!model.textures) return {};
  std::vector<std::string> names, out;
  for (const std::string& image : model.textures->images) {
    names.push_back(model.name + "_t" + std::to_string(names.size()) + "_" +
                    Hash().add(image).text() + ".png");
    files.push_back({names.back(), image});
  }
  for (const int image : model.textures->image_of_material)
    out.push_back(image < 0 ? "" : names[static_cast<size_t>(image)]);
  return out;
}

// Triangles for a file, and what they show.
struct MeshFiles::Shown {
  std::shared_ptr<const Model> model;
  ObjTextures textures;
};

MeshFiles::MeshFiles(const SimulationScene& scene, bool by_material) {
  for (const SimulationModel& model : scene.models) add_model(model, by_material);
}

std::string MeshFiles::add_obj(const std::string& stem, const Shown& shown,
                               const Affine& link_from_object, bool with_materials) {
  ExportScene scene;
  scene.objects.push_back({stem, shown.model, link_from_object, ""});
  ObjText text = obj_text(scene, kMtl, {shown.textures});
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

void MeshFiles::add_model(const SimulationModel& model, bool by_material) {
  ModelFiles out;
  const ModelTextures* const textures = model.textures.get();
  const std::vector<std::string> images = add_textures(model, m_files);
  const std::vector<MaterialFaces> groups = faces_by_material(*model.model);
  const bool needs_whole = !by_material || model.parts.empty() || groups.size() == 1;
  Shown whole{model.model, {{}, images}};
  if (textures) whole.textures.coordinates = textures->coordinates;
  if (needs_whole) out.whole = add_obj(model.name, whole, model.link_from_object, !by_material);
  const auto file_of = [&](const MaterialFaces& group) {
    if (groups.size() == 1) return out.whole;
    const auto coordinates = with_faces(textures, group.faces);
    return add_obj(model.name + "_m" + std::to_string(group.material),
                   {with_faces(*model.model, group), {coordinates, {}}}, model.link_from_object,
                   false);
  };
  for (size_t i = 0; by_material && i < groups.size(); ++i) {
    const auto material = static_cast<size_t>(groups[i].material);
    out.visuals.push_back({file_of(groups[i]),
                           material_or_default(*model.model, groups[i].material),
                           images.empty() ? "" : images[material]});
  }
  for (const ConvexPart& part : model.parts)
    out.parts.push_back(add_obj(model.name + "_c" + std::to_string(out.parts.size()),
                                {model_of(part), {}}, {}, false));
  if (out.parts.empty()) out.parts.push_back(out.whole);
  m_models.push_back(std::move(out));
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

std::string valid_name(const std::string& name, bool dashes) {
  std::string out;
  for (const char c : name) {
    const bool keep = is_letter(c) || ('0' <= c && c <= '9') || (dashes && (c == '-' || c == '.'));
    out += keep ? c : '_';
  }
  if (out.empty() || !is_letter(out[0])) out.insert(0, 1, '_');
  return out;
}

}  // namespace

std::vector<std::string> valid_names(const std::vector<std::string>& names, bool dashes,
                                     std::set<std::string> taken) {
  std::vector<std::string> out(names.size());
  for (size_t i = 0; i < names.size(); ++i)
    if (valid_name(names[i], dashes) == names[i] && taken.insert(names[i]).second)
      out[i] = names[i];
  for (size_t i = 0; i < names.size(); ++i) {
    if (!out[i].empty()) continue;
    const std::string base = valid_name(names[i], dashes);
    out[i] = base;
    for (int k = 2; !taken.insert(out[i]).second; ++k) out[i] = base + "_" + std::to_string(k);
  }
  return out;
}

}  // namespace trivet
