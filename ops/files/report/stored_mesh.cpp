#include "ops/files/report/stored_mesh.h"

#include <algorithm>
#include <type_traits>

#include "core/base/error.h"
#include "core/io/mesh_model.h"
#include "core/mesh/weld_arrays.h"
#include "ops/files/report/array_text.h"

namespace trivet {
namespace {

using Corners = std::array<Eigen::Vector3f, 3>;
static_assert(sizeof(Vec3) == 24 && sizeof(Index3) == 12 && sizeof(Corners) == 36);

OrderedJson material_json(const Material& material) {
  return {{"name", material.name},
          {"base_colour", material.base_colour},
          {"metallic", material.metallic},
          {"roughness", material.roughness}};
}

Material read_mesh_material(const JsonPlace& place) {
  place.expect_object({"name", "base_colour", "metallic", "roughness"}, {});
  Material material;
  const JsonPlace name = place.at("name");
  if (!name.value().is_string()) name.refuse("text");
  material.name = name.value().get<std::string>();
  const std::vector<double> colour = place.at("base_colour").numbers(4, -1e30, 1e30);
  for (size_t i = 0; i < 4; ++i) material.base_colour[i] = static_cast<float>(colour[i]);
  material.metallic = static_cast<float>(place.at("metallic").number(-1e30, 1e30));
  material.roughness = static_cast<float>(place.at("roughness").number(-1e30, 1e30));
  return material;
}

void read_look(const JsonPlace& place, Model& model) {
  const size_t num_faces = model.mesh.triangles.size();
  model.materials.clear();
  for (const JsonPlace& item : place.at("materials").items())
    model.materials.push_back(read_mesh_material(item));
  if (model.materials.empty()) place.at("materials").refuse("one material at least");
  if (const auto ids = place.find("face_material")) {
    model.face_material = items_of<Index>(*ids);
    const auto last = static_cast<Index>(model.materials.size()) - 1;
    const auto [least, most] =
        std::minmax_element(model.face_material.begin(), model.face_material.end());
    if (model.face_material.size() != num_faces || *least < 0 || *most > last)
      ids->fail("is not the material of each triangle");
  }
  if (const auto normals = place.find("corner_normals")) {
    model.corner_normals = items_of<Corners>(*normals);
    if (model.corner_normals.size() != num_faces) normals->fail("has not 9 numbers per triangle");
  }
}

}  // namespace

OrderedJson stored_mesh_json(const Model& model, bool whole) {
  OrderedJson json = {{"vertices", text_of(model.mesh.vertices)},
                      {"triangles", text_of(model.mesh.triangles)}};
  if (!whole) return json;
  json["materials"] = OrderedJson::array();
  for (const Material& material : model.materials)
    json["materials"].push_back(material_json(material));
  const auto& ids = model.face_material;
  if (std::any_of(ids.begin(), ids.end(), [](Index id) { return id != 0; }))
    json["face_material"] = text_of(ids);
  if (!model.corner_normals.empty()) json["corner_normals"] = text_of(model.corner_normals);
  return json;
}

Model read_stored_mesh(const JsonPlace& place) {
  place.expect_object({"vertices", "triangles"}, {"materials", "face_material", "corner_normals"});
  Mesh mesh;
  mesh.vertices = items_of<Vec3>(place.at("vertices"));
  mesh.triangles = items_of<Index3>(place.at("triangles"));
  try {
    weld(mesh.vertices, mesh.triangles);  // looks at every number
    Model model = model_of_mesh(std::move(mesh));
    if (place.find("materials")) read_look(place, model);
    return model;
  } catch (const Error& e) {
    if (std::string(e.what()).rfind(place.where(), 0) == 0) throw;
    place.fail(e.sentence());
  }
}

}  // namespace trivet
