// USD as text, with the schemas UsdGeom and UsdPhysics: a stage of bodies that reference separate
// layers, one per model.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <charconv>
#include <map>

#include "core/base/hash.h"
#include "core/io/appearance.h"
#include "core/io/simulators/simulation_files.h"

namespace trivet {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out += '"';
}

std::string tuple(std::initializer_list<double> values) {
  std::string out = "(";
  out += numbers_text(values, ", ");
  return out += ')';
}
std::string tuple(const Vec3& v) { return tuple({v.x(), v.y(), v.z()}); }
std::string tuple(const Rotation& r) { return tuple({r.w, r.x, r.y, r.z}); }

/// Lines indented by two spaces per open brace.
class UsdaText {
 public:
  explicit UsdaText(const std::string& default_prim) {
    m_text = "#usda 1.0\n(\n  defaultPrim = " + quoted(default_prim) +
             "\n  doc = \"Made by Trivet\"\n  kilogramsPerUnit = 1\n  metersPerUnit = 1\n"
             "  upAxis = \"Z\"\n)\n";
  }

  /// def TYPE "NAME" (metadata) {
  void open(const std::string& type, const std::string& name,
            const std::vector<std::string>& metadata = {}) {
    line("def " + type + (type.empty() ? "" : " ") + quoted(name) + (metadata.empty() ? "" : " ("));
    for (const std::string& entry : metadata) line("  " + entry);
    if (!metadata.empty()) line(")");
    line("{");
    ++m_depth;
  }
  void close() {
    --m_depth;
    line("}");
  }
  void line(const std::string& text) {
    m_text.append(2 * m_depth, ' ');
    m_text += text;
    m_text += '\n';
  }
  std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
  size_t m_depth = 0;
};

std::string apis(std::initializer_list<const char*> names) {
  std::string list;
  for (const char* name : names) list += (list.empty() ? "" : ", ") + quoted(name);
  return "prepend apiSchemas = [" + list + "]";
}

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

/// The image of a base colour, looked up at the mesh's coordinates "st".
void add_texture(UsdaText& text, const std::string& look, const std::string& image,
                 const Material& m) {
  text.open("Shader", "Coordinates");
  text.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
  text.line("string inputs:varname = \"st\"");
  text.line("float2 outputs:result");
  text.close();
  text.open("Shader", "Image");
  text.line("uniform token info:id = \"UsdUVTexture\"");
  text.line("asset inputs:file = @./" + image + "@");
  text.line("float4 inputs:scale = " +
            tuple({m.base_colour[0], m.base_colour[1], m.base_colour[2], m.base_colour[3]}));
  text.line("token inputs:sourceColorSpace = \"sRGB\"");
  text.line("float2 inputs:st.connect = <" + look + "/Coordinates.outputs:result>");
  text.line("token inputs:wrapS = \"repeat\"");
  text.line("token inputs:wrapT = \"repeat\"");
  text.line("float3 outputs:rgb");
  text.close();
}

void add_looks(UsdaText& text, const std::string& root, const Model& model,
               const std::vector<MaterialFaces>& groups, const std::vector<std::string>& images) {
  text.open("Scope", "Looks");
  for (size_t i = 0; i < groups.size(); ++i) {
    const Material m = material_or_default(model, groups[i].material);
    const std::string look = "/" + root + "/Looks/" + look_name(i);
    const std::string image = images.empty() ? "" : images[static_cast<size_t>(groups[i].material)];
    text.open("Material", look_name(i));
    text.line("token outputs:surface.connect = <" + look + "/Surface.outputs:surface>");
    if (!image.empty()) add_texture(text, look, image, m);
    text.open("Shader", "Surface");
    text.line("uniform token info:id = \"UsdPreviewSurface\"");
    if (image.empty())
      text.line("color3f inputs:diffuseColor = " +
                tuple({m.base_colour[0], m.base_colour[1], m.base_colour[2]}));
    else
      text.line("color3f inputs:diffuseColor.connect = <" + look + "/Image.outputs:rgb>");
    text.line("float inputs:opacity = " + number_text(m.base_colour[3]));
    text.line("float inputs:metallic = " + number_text(m.metallic));
    text.line("float inputs:roughness = " + number_text(m.roughness));
    text.line("token outputs:surface");
    text.close();
    text.close();
  }
  text.close();
}

void add_coordinates(UsdaText& text, const ModelTextures& textures) {
  std::vector<Eigen::Vector2f> corners;
  for (const auto& face : textures.coordinates)
    corners.insert(corners.end(), face.begin(), face.end());
  text.line("texCoord2f[] primvars:st = " +
            array_text(corners,
                       [](std::string& out, const Eigen::Vector2f& at) {
                         out += '(', append_float(out, at.x());
                         out += ", ", append_float(out, at.y());
                         out += ')';
                       }) +
            " (");
  text.line("  interpolation = \"faceVarying\"");
  text.line(")");
}

void add_visual(UsdaText& text, const SimulationModel& model,
                const std::vector<MaterialFaces>& groups) {
  std::vector<Vec3> points;
  for (const Vec3& p : model.model->mesh.vertices)
    points.push_back(model.link_from_object.apply(p));
  const auto binding = [&](size_t i) {
    return "rel material:binding = </" + model.name + "/Looks/" + look_name(i) + ">";
  };
  const std::string metadata =
      model.parts.empty()
          ? apis({"MaterialBindingAPI", "PhysicsCollisionAPI", "PhysicsMeshCollisionAPI"})
          : apis({"MaterialBindingAPI"});
  open_mesh(text, "Visual", {metadata}, points, model.model->mesh.triangles);
  if (model.parts.empty()) text.line("uniform token physics:approximation = \"none\"");
  if (model.textures) add_coordinates(text, *model.textures);
  if (groups.size() == 1) text.line(binding(0));
  if (groups.size() > 1)
    text.line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
  for (size_t i = 0; groups.size() > 1 && i < groups.size(); ++i) {
    text.open("GeomSubset", "faces" + std::to_string(i), {apis({"MaterialBindingAPI"})});
    text.line("uniform token elementType = \"face\"");
    text.line("uniform token familyName = \"materialBind\"");
    text.line("int[] indices = " + integers_text(groups[i].faces));
    text.line(binding(i));
    text.close();
  }
  text.close();
}

std::string layer_text(const SimulationModel& model, const std::vector<std::string>& images) {
  const std::vector<MaterialFaces> groups = faces_by_material(*model.model);
  UsdaText text(model.name);
  text.open("Xform", model.name);
  add_visual(text, model, groups);
  add_looks(text, model.name, *model.model, groups, images);
  if (!model.parts.empty()) {
    text.open("Scope", "Collision");
    for (size_t i = 0; i < model.parts.size(); ++i) {
      open_mesh(text, "part" + std::to_string(i),
                {apis({"PhysicsCollisionAPI", "PhysicsMeshCollisionAPI"})}, model.parts[i].vertices,
                model.parts[i].triangles);
      text.line("uniform token physics:approximation = \"convexHull\"");
      text.line("uniform token purpose = \"guide\"");
      text.close();
    }
    text.close();
  }
  text.close();
  return text.take();
}

struct PrincipalInertia {
  Vec3 diagonal;
  Rotation axes;
};

PrincipalInertia principal(const Mat3& inertia) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
  Mat3 axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return {solver.eigenvalues(), Rotation::from_matrix(axes)};
}

void add_transform(UsdaText& text, const Pose& pose) {
  text.line("quatd xformOp:orient = " + tuple(pose.rotation));
  text.line("double3 xformOp:translate = " + tuple(pose.translation));
  text.line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]");
}

/// One physical material for each pair of friction and restitution. Of two surfaces PhysX shall
/// take the smaller coefficient of friction, not their mean.
class Surfaces {
 public:
  explicit Surfaces(const SimulationScene& scene) {
    if (scene.floor) add(scene.floor_friction, scene.floor_restitution);
    for (const SimulationBody& body : scene.bodies) add(body.friction, body.restitution);
  }
  std::string binding(double friction, double restitution) const {
    return "rel material:binding:physics = </World/Looks/" + m_names.at({friction, restitution}) +
           ">";
  }
  void write(UsdaText& text) const {
    text.open("Scope", "Looks");
    for (const auto& [surface, name] : m_names) {
      text.open("Material", name, {apis({"PhysicsMaterialAPI", "PhysxMaterialAPI"})});
      text.line("float physics:dynamicFriction = " + number_text(surface.first));
      text.line("float physics:restitution = " + number_text(surface.second));
      text.line("float physics:staticFriction = " + number_text(surface.first));
      text.line("uniform token physxMaterial:frictionCombineMode = \"min\"");
      text.close();
    }
    text.close();
  }

 private:
  void add(double friction, double restitution) {
    m_names.try_emplace({friction, restitution}, "Surface" + std::to_string(m_names.size()));
  }
  std::map<std::pair<double, double>, std::string> m_names;
};

void add_body(UsdaText& text, const SimulationBody& body, const std::string& layer,
              const Surfaces& surfaces, bool has_parts) {
  const std::string reference = "prepend references = @./" + layer + "@";
  // A collider without a rigid body is static.
  text.open("Xform", body.file_name,
            {body.fixed ? apis({"MaterialBindingAPI"})
                        : apis({"PhysicsRigidBodyAPI", "PhysicsMassAPI", "MaterialBindingAPI"}),
             reference, "displayName = " + quoted(body.name)});
  text.line("custom string trivet:name = " + quoted(body.name));
  text.line(surfaces.binding(body.friction, body.restitution));
  if (!body.fixed) {
    const PrincipalInertia inertia = principal(body.inertia);
    text.line("point3f physics:centerOfMass = " + tuple(body.centre));
    text.line("float3 physics:diagonalInertia = " + tuple(inertia.diagonal));
    text.line("float physics:mass = " + number_text(body.mass));
    text.line("quatf physics:principalAxes = " + tuple(inertia.axes));
    text.line("bool physics:startsAsleep = 1");
  }
  add_transform(text, body.world_from_link);
  if (!body.fixed && !has_parts) {  // PhysX takes no triangles of bodies that move
    text.line("over \"Visual\"");
    text.line("{");
    text.line("  uniform token physics:approximation = \"convexDecomposition\"");
    text.line("}");
  }
  text.close();
}

}  // namespace

std::vector<MeshFile> usda_meshes(const SimulationScene& scene) {
  std::vector<MeshFile> out, images;
  for (const SimulationModel& model : scene.models) {
    std::string bytes = layer_text(model, add_textures(model, images));
    out.push_back({model.name + "_" + Hash().add(bytes).text() + ".usda", std::move(bytes)});
  }
  out.insert(out.end(), images.begin(), images.end());
  return out;
}

std::string usda_text(const SimulationScene& scene, const std::vector<std::string>& layers,
                      const std::string& folder) {
  const Surfaces surfaces(scene);
  UsdaText text("World");
  text.open("Xform", "World");
  text.open("PhysicsScene", "PhysicsScene");
  text.line("vector3f physics:gravityDirection = (0, 0, -1)");
  text.line("float physics:gravityMagnitude = " + number_text(scene.gravity));
  text.close();
  surfaces.write(text);
  if (scene.floor) {
    text.open("Plane", "floor", {apis({"PhysicsCollisionAPI", "MaterialBindingAPI"})});
    text.line("uniform token axis = \"Z\"");
    text.line("uniform token purpose = \"guide\"");
    text.line(surfaces.binding(scene.floor_friction, scene.floor_restitution));
    text.close();
  }
  for (const SimulationBody& body : scene.bodies)
    add_body(text, body, folder + layers[body.model], surfaces,
             !scene.models[body.model].parts.empty());
  text.close();
  return text.take();
}

}  // namespace trivet
