#include "core/io/assimp/look.h"

#include <assimp/camera.h>
#include <assimp/light.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/io/assimp/materials.h"
#include "core/io/assimp/primitive.h"

namespace trivet {
namespace {

std::string text_of(const aiString& text) { return text.C_Str(); }

GltfJson matrix_json(const aiMatrix4x4& m) {
  GltfJson out = GltfJson::array();
  for (unsigned c = 0; c < 4; ++c)
    for (unsigned r = 0; r < 4; ++r) out.push_back(m[r][c]);
  return out;
}

bool is_affine(const aiMatrix4x4& m) {
  for (unsigned r = 0; r < 4; ++r)
    for (unsigned c = 0; c < 4; ++c)
      if (!std::isfinite(m[r][c])) return false;
  return m.d1 == 0 && m.d2 == 0 && m.d3 == 0 && m.d4 == 1;
}

class LookMaker {
 public:
  LookMaker(const aiScene& scene, const ImportLimits& limits, Model& model)
      : m_scene(scene), m_model(model), m_materials(scene, limits, model, m_builder) {}

  std::shared_ptr<const Appearance> make() {
    Appearance look;
    const aiNode& root = *m_scene.mRootNode;
    // assimp's own root is skipped unless it carries a transform, meshes or attributes.
    if (root.mTransformation.IsIdentity() && root.mNumMeshes == 0 && !has_attachment(root)) {
      for (unsigned i = 0; i < root.mNumChildren; ++i)
        look.roots.push_back(static_cast<int>(add_node(*root.mChildren[i], 0)));
    } else {
      look.roots.push_back(static_cast<int>(add_node(root, 0)));
    }
    look.document = std::make_shared<const GltfDocument>(m_builder.take(GltfJson::object()));
    return std::make_shared<const Appearance>(std::move(look));
  }

 private:
  bool has_attachment(const aiNode& node) const {
    for (unsigned i = 0; i < m_scene.mNumCameras; ++i)
      if (m_scene.mCameras[i]->mName == node.mName) return true;
    for (unsigned i = 0; i < m_scene.mNumLights; ++i)
      if (m_scene.mLights[i]->mName == node.mName) return true;
    return false;
  }

  size_t add_node(const aiNode& node, int depth) {
    if (depth > kMaxNodeDepth) throw Error(Error::Kind::BadInput, "nodes are nested too deeply");
    GltfJson out = GltfJson::object();
    if (node.mName.length) out["name"] = text_of(node.mName);
    if (!is_affine(node.mTransformation))
      throw Error(Error::Kind::BadInput, "a node's transform is not affine");
    if (!node.mTransformation.IsIdentity()) out["matrix"] = matrix_json(node.mTransformation);
    if (const int mesh = mesh_of(node); mesh >= 0) out["mesh"] = mesh;
    GltfJson children = GltfJson::array();
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      children.push_back(add_node(*node.mChildren[i], depth + 1));
    add_cameras(node, children);
    add_lights(node, children);
    if (!children.empty()) out["children"] = std::move(children);
    return m_builder.add("nodes", std::move(out));
  }

  // Nodes with the same meshes share one glTF mesh.
  int mesh_of(const aiNode& node) {
    const std::vector<unsigned> ids(node.mMeshes, node.mMeshes + node.mNumMeshes);
    const auto [entry, is_new] = m_meshes.try_emplace(ids, -1);
    if (!is_new) return entry->second;
    GltfJson primitives = GltfJson::array();
    for (const unsigned id : ids) {
      const aiMesh& mesh = *m_scene.mMeshes[id];
      if (!has_triangles(mesh)) continue;
      GltfJson primitive = primitive_of_assimp(mesh, m_builder);
      primitive["material"] = m_materials.material(mesh.mMaterialIndex);
      primitives.push_back(std::move(primitive));
    }
    if (primitives.empty()) return -1;
    std::string name = text_of(m_scene.mMeshes[ids.front()]->mName);
    if (name.empty()) name = text_of(node.mName);
    GltfJson mesh = {{"primitives", std::move(primitives)}};
    if (!name.empty()) mesh["name"] = name;
    return entry->second = static_cast<int>(m_builder.add("meshes", std::move(mesh)));
  }

  // glTF looks along -z with +y up; a separate node turns assimp's direction there.
  size_t add_turned(const aiVector3D& position, const aiVector3D& direction, const aiVector3D& up,
                    GltfJson content) {
    const auto unit_or = [](const aiVector3D& v, const Vec3& fallback) {
      const Vec3 given(v.x, v.y, v.z);
      const double length = given.norm();
      return std::isfinite(length) && length > 0 ? Vec3(given / length) : fallback;
    };
    const Vec3 back = -unit_or(direction, -Vec3::UnitZ());
    Vec3 right = unit_or(up, Vec3::UnitY()).cross(back);
    if (right.norm() < 1e-6) right = back.unitOrthogonal();
    right.normalize();
    const Vec3 upward = back.cross(right);
    GltfJson matrix = GltfJson::array();
    for (const Vec3& column : {right, upward, back}) {
      for (int i = 0; i < 3; ++i) matrix.push_back(static_cast<float>(column[i]));
      matrix.push_back(0);
    }
    for (const float p : {position.x, position.y, position.z}) matrix.push_back(finite_or_zero(p));
    matrix.push_back(1);
    content["matrix"] = std::move(matrix);
    return m_builder.add("nodes", std::move(content));
  }

  void add_cameras(const aiNode& node, GltfJson& children) {
    for (unsigned i = 0; i < m_scene.mNumCameras; ++i) {
      const aiCamera& camera = *m_scene.mCameras[i];
      if (camera.mName != node.mName) continue;
      const double near = camera.mClipPlaneNear > 0 ? camera.mClipPlaneNear : 0.01;
      const double aspect = camera.mAspect > 0 ? camera.mAspect : 1.0;
      const double half = std::isfinite(camera.mHorizontalFOV) && camera.mHorizontalFOV > 0
                              ? std::min<double>(camera.mHorizontalFOV, 3.0) / 2
                              : 0.4;
      GltfJson perspective = {{"yfov", 2 * std::atan(std::tan(half) / aspect)}, {"znear", near}};
      if (camera.mAspect > 0) perspective["aspectRatio"] = aspect;
      if (camera.mClipPlaneFar > near) perspective["zfar"] = camera.mClipPlaneFar;
      const std::string name = text_of(camera.mName);
      const size_t id = m_builder.add(
          "cameras",
          {{"name", name}, {"type", "perspective"}, {"perspective", std::move(perspective)}});
      children.push_back(add_turned(camera.mPosition, camera.mLookAt, camera.mUp,
                                    {{"name", name}, {"camera", id}}));
    }
  }

  void add_lights(const aiNode& node, GltfJson& children) {
    for (unsigned i = 0; i < m_scene.mNumLights; ++i) {
      const aiLight& light = *m_scene.mLights[i];
      if (light.mName != node.mName) continue;
      GltfJson json = light_json(light);
      if (json.is_null()) {
        m_model.notes.push_back("left out: ambient and area lights");
        continue;
      }
      GltfJson content = {{"name", text_of(light.mName)}};
      content["extensions"]["KHR_lights_punctual"]["light"] = m_builder.add_light(std::move(json));
      children.push_back(
          add_turned(light.mPosition, light.mDirection, light.mUp, std::move(content)));
    }
  }

  // Formats disagree on units of light: the colour carries the strength, unconverted.
  static GltfJson light_json(const aiLight& light) {
    const char* const type = light.mType == aiLightSource_DIRECTIONAL ? "directional"
                             : light.mType == aiLightSource_POINT     ? "point"
                             : light.mType == aiLightSource_SPOT      ? "spot"
                                                                      : nullptr;
    if (!type) return {};
    const aiColor3D& c = light.mColorDiffuse;
    const float strength =
        std::max({finite_or_zero(c.r), finite_or_zero(c.g), finite_or_zero(c.b), 0.0f});
    GltfJson colour = GltfJson::array();
    for (const float part : {c.r, c.g, c.b})
      colour.push_back(strength > 0 ? std::max(0.0f, finite_or_zero(part)) / strength : 0.0f);
    GltfJson out = {{"name", text_of(light.mName)},
                    {"type", type},
                    {"color", std::move(colour)},
                    {"intensity", strength}};
    if (light.mType == aiLightSource_SPOT) {
      const double half_pi = std::numbers::pi / 2;
      const double outer =
          std::clamp<double>(finite_or_zero(light.mAngleOuterCone) / 2, 0.01, half_pi);
      const double inner =
          std::clamp<double>(finite_or_zero(light.mAngleInnerCone) / 2, 0.0, outer * 0.999);
      out["spot"] = {{"innerConeAngle", inner}, {"outerConeAngle", outer}};
    }
    return out;
  }

  const aiScene& m_scene;
  Model& m_model;
  GltfBuilder m_builder;
  MaterialConverter m_materials;
  std::map<std::vector<unsigned>, int> m_meshes;
};

int num_mesh_nodes(const aiNode& node, bool& transformed, int depth) {
  if (depth > kMaxNodeDepth) return 0;
  transformed |= !node.mTransformation.IsIdentity();
  int count = node.mNumMeshes > 0;
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    count += num_mesh_nodes(*node.mChildren[i], transformed, depth + 1);
  return count;
}

bool has_look(const aiScene& scene) {
  bool more = scene.mNumCameras > 0 || scene.mNumLights > 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i)
    more |= scene.mMeshes[i]->HasTextureCoords(0) || scene.mMeshes[i]->HasVertexColors(0);
  return num_mesh_nodes(*scene.mRootNode, more, 0) > 1 || more;
}

}  // namespace

std::shared_ptr<const Appearance> appearance_of_assimp(const aiScene& scene,
                                                       const ImportLimits& limits, Model& model) {
  if (!has_look(scene)) return nullptr;
  try {
    return LookMaker(scene, limits, model).make();
  } catch (const Error& e) {
    model.notes.push_back(say("hierarchy and textures left out: %1", e.what()));
    return nullptr;
  }
}

}  // namespace trivet
