// Layers of USD, one per model: triangles, looks with images, convex parts; or parts apart.
#include <algorithm>
#include <charconv>

#include "core/base/hash.h"
#include "core/io/appearance.h"
#include "core/io/simulators/looked_files.h"
#include "core/io/simulators/mujoco_contacts.h"
#include "core/io/simulators/usda_text.h"

namespace trivet {
namespace {

template <class Range, class Append>
std::string array_text(const Range& range, const Append& append) {
  std::string out = "[";
  for (const auto& item : range) {
    if (out.size() > 1) out += ", ";
    append(out, item);
  }
  return out += ']';
}

void append_float(std::string& out, double value) {
  char buffer[32];
  out.append(buffer,
             std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value) + 0.0f).ptr);
}

std::string points_text(const std::vector<Vec3>& points) {
  return array_text(points, [](std::string& out, const Vec3& p) {
    for (int i = 0; i < 3; ++i) out += i == 0 ? "(" : ", ", append_float(out, p[i]);
    out += ')';
  });
}

template <class Range>
std::string integers_text(const Range& range) {
  return array_text(range, [](std::string& out, Index i) { out += std::to_string(i); });
}

/// Opens a mesh prim and writes the common attributes.
void open_mesh(UsdaText& text, const std::string& name, const std::vector<std::string>& metadata,
               const std::vector<Vec3>& points, const std::vector<Index3>& triangles) {
  Aabb box;
  for (const Vec3& p : points) box.extend(p);
  std::vector<Index> corners;
  for (const Index3& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
  text.open("Mesh", name, metadata);
  text.line("float3[] extent = " + points_text({box.lower, box.upper}));
  text.line("int[] faceVertexCounts = " + integers_text(std::vector<Index>(triangles.size(), 3)));
  text.line("int[] faceVertexIndices = " + integers_text(corners));
  text.line("point3f[] points = " + points_text(points));
  text.line("uniform token subdivisionScheme = \"none\"");
}

std::string look_name(size_t index) { return "Material" + std::to_string(index); }

/// A model with the materials of its look, or its own.
class LayerWriter {
 public:
  /// @param moves  a free body has this model.
  LayerWriter(const SimulationModel& model, const std::vector<std::string>& images, bool with_parts,
              bool moves)
      : m_model(model),
        m_images(images),
        m_moves(moves),
        m_with_parts(with_parts && !model.parts.empty()),
        m_groups(model.look ? faces_of_look(*model.look) : faces_by_material(*model.model)),
        m_text(model.name) {}

  std::string text() {
    m_text.open("Xform", m_model.name);
    add_visual();
    m_text.open("Scope", "Looks");
    for (size_t i = 0; i < m_groups.size(); ++i) add_look(i);
    m_text.close();
    if (m_with_parts) add_parts();
    m_text.close();
    return m_text.take();
  }

 private:
  std::string look_path(size_t i) const { return "/" + m_model.name + "/Looks/" + look_name(i); }
  std::string binding(size_t i) const { return "rel material:binding = <" + look_path(i) + ">"; }
  std::string image(size_t i) const {
    return m_model.look ? m_images[static_cast<size_t>(m_groups[i].material)] : "";
  }
  Material material(size_t i) const {
    const Index id = m_groups[i].material;
    return m_model.look ? m_model.look->materials[static_cast<size_t>(id)]
                        : material_or_default(*m_model.model, id);
  }

  void add_visual();
  void add_look(size_t i);
  void add_image(const std::string& material, const std::string& file);
  void add_parts();

  const SimulationModel& m_model;
  const std::vector<std::string>& m_images;
  const bool m_moves;
  const bool m_with_parts;
  std::vector<MaterialFaces> m_groups;
  UsdaText m_text;
};

void LayerWriter::add_look(size_t i) {
  const Material m = material(i);
  m_text.open("Material", look_name(i));
  m_text.line("token outputs:surface.connect = <" + look_path(i) + "/Surface.outputs:surface>");
  m_text.open("Shader", "Surface");
  m_text.line("uniform token info:id = \"UsdPreviewSurface\"");
  if (image(i).empty())
    m_text.line("color3f inputs:diffuseColor = " +
                usda_tuple({m.base_colour[0], m.base_colour[1], m.base_colour[2]}));
  else
    m_text.line("color3f inputs:diffuseColor.connect = <" + look_path(i) + "/Image.outputs:rgb>");
  m_text.line("float inputs:opacity = " + number_text(m.base_colour[3]));
  m_text.line("float inputs:metallic = " + number_text(m.metallic));
  m_text.line("float inputs:roughness = " + number_text(m.roughness));
  m_text.line("token outputs:surface");
  m_text.close();
  if (!image(i).empty()) add_image(look_path(i), image(i));
  m_text.close();
}

void LayerWriter::add_image(const std::string& material, const std::string& file) {
  m_text.open("Shader", "Image");
  m_text.line("uniform token info:id = \"UsdUVTexture\"");
  m_text.line("asset inputs:file = @./" + file + "@");
  m_text.line("token inputs:sourceColorSpace = \"sRGB\"");
  m_text.line("float2 inputs:st.connect = <" + material + "/Coordinates.outputs:result>");
  m_text.line("token inputs:wrapS = \"repeat\"");
  m_text.line("token inputs:wrapT = \"repeat\"");
  m_text.line("float3 outputs:rgb");
  m_text.close();
  m_text.open("Shader", "Coordinates");
  m_text.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
  m_text.line("string inputs:varname = \"st\"");
  m_text.line("float2 outputs:result");
  m_text.close();
}

std::string coordinates_text(const SimulationLook& look) {
  std::vector<Eigen::Vector2f> corners;
  for (const auto& face : look.coordinates) corners.insert(corners.end(), face.begin(), face.end());
  return array_text(corners, [](std::string& out, const Eigen::Vector2f& uv) {
    for (int i = 0; i < 2; ++i) out += i == 0 ? "(" : ", ", append_float(out, uv[i]);
    out += ')';
  });
}

void LayerWriter::add_visual() {
  std::vector<Vec3> points;
  for (const Vec3& p : m_model.model->mesh.vertices)
    points.push_back(m_model.file_from_object.apply(p));
  const std::string metadata =
      m_model.parts.empty() ? usda_apis({"MaterialBindingAPI", "PhysicsCollisionAPI",
                                         "PhysicsMeshCollisionAPI", "NewtonMeshCollisionAPI"})
                            : usda_apis({"MaterialBindingAPI"});
  open_mesh(m_text, "Visual", {metadata}, points, m_model.model->mesh.triangles);
  // PhysX takes triangles of fixed bodies alone, and else the hull of all of them.
  if (m_model.parts.empty())
    m_text.line("uniform token physics:approximation = " +
                usda_quoted(m_moves ? "convexDecomposition" : "none"));
  if (m_model.look)
    m_text.line("texCoord2f[] primvars:st = " + coordinates_text(*m_model.look) +
                " (interpolation = \"faceVarying\")");
  if (m_groups.size() == 1) m_text.line(binding(0));
  if (m_groups.size() > 1)
    m_text.line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
  for (size_t i = 0; m_groups.size() > 1 && i < m_groups.size(); ++i) {
    m_text.open("GeomSubset", "faces" + std::to_string(i), {usda_apis({"MaterialBindingAPI"})});
    m_text.line("uniform token elementType = \"face\"");
    m_text.line("uniform token familyName = \"materialBind\"");
    m_text.line("int[] indices = " + integers_text(m_groups[i].faces));
    m_text.line(binding(i));
    m_text.close();
  }
  m_text.close();
}

/// Newton and MuJoCo ask for words of their own; MuJoCo takes hulls alone.
void add_part(UsdaText& text, const std::string& name, const ConvexPart& part) {
  open_mesh(text, name,
            {usda_apis({"PhysicsCollisionAPI", "PhysicsMeshCollisionAPI", "NewtonMeshCollisionAPI",
                        "MjcCollisionAPI"})},
            part.vertices, part.triangles);
  add_mujoco_contacts(text);
  text.line("uniform token physics:approximation = \"convexHull\"");
  text.line("uniform token purpose = \"guide\"");
  text.close();
}

void LayerWriter::add_parts() {
  m_text.open("Scope", "Collision");
  for (size_t i = 0; i < m_model.parts.size(); ++i)
    add_part(m_text, "part" + std::to_string(i), m_model.parts[i]);
  m_text.close();
}

MeshFile hashed_layer(const std::string& stem, std::string bytes) {
  return {stem + "_" + Hash().add(bytes).text() + ".usda", std::move(bytes)};
}

}  // namespace

void add_mujoco_contacts(UsdaText& text) {
  const auto list = [](std::string values) {
    for (size_t at = 0; (at = values.find(' ', at)) != std::string::npos; at += 2)
      values.replace(at, 1, ", ");
    return "[" + values + "]";
  };
  text.line("uniform int mjc:condim = " + std::to_string(kMujocoCondim));
  text.line("uniform double[] mjc:solimp = " + list(kMujocoSolimp + std::string(" 0.5 2")));
  text.line("uniform double[] mjc:solref = " + list(kMujocoSolref));
}

UsdaLayers usda_layers(const SimulationScene& scene, bool parts_apart) {
  const ImageFiles images(scene);
  UsdaLayers out;
  const auto add = [&](const std::string& stem, std::string bytes) {
    out.files.push_back(hashed_layer(stem, std::move(bytes)));
    return out.files.back().name;
  };
  for (size_t i = 0; i < scene.models.size(); ++i) {
    const SimulationModel& model = scene.models[i];
    UsdaLayers::OfModel layers;
    const bool moves =
        std::any_of(scene.bodies.begin(), scene.bodies.end(),
                    [&](const SimulationBody& body) { return body.model == i && !body.fixed; });
    layers.file =
        add(model.name, LayerWriter(model, images.of_model(i), !parts_apart, moves).text());
    for (size_t k = 0; parts_apart && k < model.parts.size(); ++k) {
      UsdaText text("part");
      add_part(text, "part", model.parts[k]);
      layers.parts.push_back(add(model.name + "_c", text.take()));
    }
    out.of_model.push_back(std::move(layers));
  }
  return out;
}

}  // namespace trivet
