#include "raster/path/scene.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/picture/mesh_values.h"
#include "core/picture/normals.h"

namespace trivet {
namespace {

constexpr float kMaxBulge = 0.0025f;  // largest distance of a smooth surface from its triangles
// Glass passes its colour over this share of the mesh's diagonal.
constexpr double kAbsorptionShare = 0.5;
constexpr float kInterfaceLoss = 0.96f;  // of light through one side of glass

bool is_closed(const PictureMesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;  // from the smaller to the larger: +1, back: -1
  for (const Index3& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) {
      const Index a = t[c], b = t[(c + 1) % 3];
      // In a closed mesh each edge is run through as often in both directions.
      a < b ? ++edges[{a, b}] : --edges[{b, a}];
    }
  return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

Transparency transparency_of(const DrawnMesh& mesh, std::size_t material) {
  return mesh.has_details() ? mesh.surface->finishes[material].transparency : Transparency::None;
}

// Transmission, index and absorption of the model; lengths are shares of the mesh's diagonal.
void take_glass(const Glass& given, double diagonal, PathMaterial& out) {
  if (given.share <= 0) return;
  out.index = given.index;
  out.alpha = std::max(out.alpha, given.share);  // stained by its colour
  if (given.absorbed_per_unit)
    out.absorbed = Eigen::Map<const Vec3f>(given.absorbed_per_unit->data()) * float(diagonal);
}

std::vector<PathMaterial> path_materials(const DrawnMesh& mesh, double diagonal) {
  std::vector<PathMaterial> out;
  const Material plain;
  const std::span<const Material> materials =
      mesh.materials.empty() ? std::span(&plain, 1) : mesh.materials;
  bool see_through = false;
  for (const Material& m : materials) {
    PathMaterial material;
    for (int i = 0; i < 3; ++i) material.base[i] = unit_or(m.base_colour[i], 1);
    material.alpha = unit_or(m.base_colour[3], 1);
    material.metallic = unit_or(m.metallic, 0);
    material.roughness = unit_or(m.roughness, 0.6f);
    see_through |= material.alpha < 1;
    out.push_back(material);
  }
  if (see_through) {
    // Closed see-through meshes refract as glass; open ones are thin sheets.
    const Finish finish = is_closed(mesh) ? Finish::Glass : Finish::Thin;
    for (PathMaterial& m : out)
      if (m.alpha < 1) m.finish = finish;
  }
  // Textures that cut out, or fade, make sheets of all that they cover.
  for (std::size_t m = 0; m < out.size(); ++m)
    if (transparency_of(mesh, m) != Transparency::None) out[m].finish = Finish::Thin;
  for (std::size_t m = 0; m < out.size() && mesh.has_details(); ++m)
    if (out[m].finish == Finish::Glass)
      take_glass(mesh.surface->finishes[m].glass, diagonal, out[m]);
  return out;
}

/// Colour of the light through a way of glass that is as long as it is meant to be seen.
Vec3f glass_colour(const PathMaterial& m) {
  const Vec3f left = m.absorbed.isZero()
                         ? Vec3f(Vec3f::Ones() * (1 - m.alpha) + m.base * m.alpha)
                         : Vec3f((-float(kAbsorptionShare) * m.absorbed).array().exp().matrix());
  return left.cwiseMax(0.01f);
}

/// Light passed through one face, on a straight way.
Vec3f passed_by(const PathMaterial& m) {
  if (m.finish == Finish::Thin) return Vec3f::Constant(1 - m.alpha);
  if (m.finish == Finish::Glass) return kInterfaceLoss * glass_colour(m).cwiseSqrt();
  return Vec3f::Zero();
}

}  // namespace

PathScene::PathScene(const PictureScene& scene, const PictureFrame& frame) {
  std::map<const PictureMesh*, std::size_t> known;
  for (const PictureObject& object : scene.objects) {
    // Objects share the mesh that they share in the scene.
    const auto [entry, is_new] = known.emplace(object.mesh, m_meshes.size());
    if (is_new) add_mesh(*object.mesh);
    if (!m_meshes[entry->second].triangles.empty()) add_instance(object, entry->second, frame);
  }
  m_rays.commit();
}

// Light that the finish alone lets through; see passed_at() for what varies over a face.
void PathScene::add_mesh(const PictureMesh& given) {
  const DrawnMesh mesh(given, texture_bytes_left(m_texture_bytes));
  Mesh& out = m_meshes.emplace_back();
  const Aabb box = finite_box(mesh);
  if (!box.empty()) out.centre = box.centre();
  out.diagonal = box.diagonal();
  if (out.diagonal > 0) out.scale = 1 / out.diagonal;
  for (const Vec3& v : mesh.vertices) {
    // Meshes are scaled to about 1, and centred, where float32 has most digits.
    const Vec3 p = (v - out.centre) * out.scale;
    out.vertices.push_back(p.allFinite() ? Vec3f(p.cast<float>()) : Vec3f::Zero());
  }
  out.materials = path_materials(mesh, out.diagonal);
  const auto normals = picture_normals(mesh);
  std::vector<Vec3f> passed;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    // Faces with a vertex that is not finite are left out, from all tables alike.
    const Index3& t = mesh.triangles[f];
    if (!std::all_of(t.begin(), t.end(), [&](Index v) { return mesh.vertices[v].allFinite(); }))
      continue;
    const std::uint32_t m = material_of(mesh, f);
    out.triangles.push_back(t);
    out.normals.push_back(normals[f]);
    out.material.push_back(m);
    // Faces whose transparency varies pass all light here, and are asked at each hit.
    const bool varies = transparency_of(mesh, m) != Transparency::None;
    passed.push_back(varies ? Vec3f(Vec3f::Ones()) : passed_by(out.materials[m]));
    if (mesh.has_details()) out.look_face.push_back(static_cast<std::uint32_t>(f));
  }
  if (mesh.has_details()) {
    out.look = mesh.surface;
    m_texture_bytes += out.look->image_bytes();
  }
  if (!out.triangles.empty())
    out.id = m_rays.add_mesh(out.vertices, out.triangles, passed, passed_at(out));
  // Absorption that the model does not give follows from its colour.
  for (PathMaterial& m : out.materials)
    if (m.finish == Finish::Glass && m.absorbed.isZero())
      m.absorbed = -glass_colour(m).array().log().matrix() / float(kAbsorptionShare);
}

PassedAt PathScene::passed_at(const Mesh& mesh) {
  const auto& look = mesh.look;
  if (!look || std::all_of(look->finishes.begin(), look->finishes.end(),
                           [](const auto& f) { return f.transparency == Transparency::None; }))
    return nullptr;
  return [look, faces = mesh.look_face](std::uint32_t face, float v, float w) {
    const FacePoint at{faces[face], {1 - v - w, v, w}};
    const FaceLook its(*look, at);
    return its.finish().transparency == Transparency::None ? 1.0f : 1 - its.alpha();
  };
}

void PathScene::add_instance(const PictureObject& object, std::size_t mesh,
                             const PictureFrame& frame) {
  const Mesh& its = m_meshes[mesh];
  const Affine& pose = object.world_from_object;
  Instance instance;
  instance.mesh = mesh;
  instance.linear = (pose.linear * (frame.scale / its.scale)).cast<float>();
  // Cofactors carry normals through any linear map; a mirrored one turns them.
  instance.normal = cofactors(pose.linear).cast<float>();
  if (pose.linear.determinant() < 0) instance.normal = -instance.normal;
  instance.scale = std::cbrt(std::abs(instance.linear.determinant()));
  instance.highlight = object.highlight;
  const Vec3f origin = frame.apply(pose.apply(its.centre)).cast<float>();
  m_rays.add_instance(its.id, {Vec3f(instance.linear.col(0)), Vec3f(instance.linear.col(1)),
                               Vec3f(instance.linear.col(2)), origin});
  m_instances.push_back(instance);
}

// Height of the smooth surface above a point of its triangle: towards the planes of the corners'
// normals, as far as the point is below them. @see [Hanika 2021]
float PathScene::bulge(const Instance& instance, const Mesh& mesh, std::uint32_t face,
                       const std::array<float, 3>& weights, float side) {
  const Index3& t = mesh.triangles[face];
  const Vec3f local = weights[0] * mesh.vertices[t[0]] + weights[1] * mesh.vertices[t[1]] +
                      weights[2] * mesh.vertices[t[2]];
  Vec3f lift = Vec3f::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vec3f n = side * mesh.normals[face][k];
    lift -= weights[k] * std::min((local - mesh.vertices[t[k]]).dot(n), 0.0f) * n;
  }
  // The bulge grows like its triangle, up to a bound, past which it falls off: coarse meshes stay
  // near their triangles.
  const float height = instance.scale * lift.norm();
  return height > kMaxBulge ? kMaxBulge * kMaxBulge / height : height;
}

// Changes by textures and colours of corners. The smooth normal of the object's frame is that
// before it faces the ray.
void PathScene::apply_look(const Instance& instance, const FaceLook& look, const Vec3f& smooth,
                           SurfacePoint& out) {
  PathMaterial& material = out.material;
  const Eigen::Vector4f base = look.base_colour();
  material.base = base.head<3>();
  if (look.finish().transparency != Transparency::None) {
    material.alpha = look.kept(base[3]);
    material.finish = material.alpha <= 0   ? Finish::Absent
                      : material.alpha >= 1 ? Finish::Opaque
                                            : Finish::Thin;
  }
  const FaceLook::Polish polish = look.polish();
  material.metallic = polish.metallic, material.roughness = polish.roughness;
  material.emitted = look.emitted();
  if (!look.finish().normal) return;
  const Eigen::Vector4f& tangent = look.tangent();
  const Vec3f off = out.normal;
  Vec3f right = instance.linear * tangent.head<3>();
  Vec3f up = instance.linear * (tangent[3] * smooth.cross(tangent.head<3>()));
  // The tangents are made perpendicular to the smooth normal.
  right = (right - right.dot(off) * off).normalized();
  up = (up - up.dot(off) * off - up.dot(right) * right).normalized();
  const Vec3f mapped = look.mapped_normal();
  // Seen from behind, bumps are dents.
  const float side = out.outside ? 1.0f : -1.0f;
  const Vec3f bent = side * (mapped.x() * right + mapped.y() * up) + mapped.z() * off;
  // A normal that looks away from the face would light what the face hides.
  if (bent.allFinite() && bent.dot(out.face) > 0) out.normal = bent.normalized();
}

SurfacePoint PathScene::surface(const RayPacket& rays, const HitPacket& hits, int lane,
                                float width) const {
  const Instance& instance = m_instances[hits.instance[lane]];
  const Mesh& mesh = m_meshes[instance.mesh];
  const std::uint32_t face = hits.face[lane];
  const Index3& t = mesh.triangles[face];
  const std::array<float, 3> weights{1 - hits.v[lane] - hits.w[lane], hits.v[lane], hits.w[lane]};
  const Vec3f &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const Vec3f direction(rays.direction[0][lane], rays.direction[1][lane], rays.direction[2][lane]);
  SurfacePoint out;
  out.material = mesh.materials[mesh.material[face]];
  out.material.absorbed /= std::max(instance.scale, 1e-20f);
  out.position = hits.position(rays, lane);
  const Vec3f across = (b - a).cross(c - a), front = instance.normal * across;
  const float length = front.norm();
  const Vec3f unit = length > 0 ? Vec3f(front / length) : Vec3f(-direction.normalized());
  // The face is turned to the ray; `outside` tells whether its front is seen.
  out.outside = unit.dot(direction) <= 0;
  out.face = out.outside ? unit : Vec3f(-unit);
  Vec3f own = Vec3f::Zero();
  // The corners' normals are mixed by the hit's place.
  for (int k = 0; k < 3; ++k) own += weights[k] * mesh.normals[face][k];
  Vec3f smooth = instance.normal * own;
  const float squared = smooth.squaredNorm();
  smooth = squared > 1e-12f ? Vec3f(smooth / std::sqrt(squared)) : out.face;
  out.normal = smooth.dot(out.face) < 0 ? Vec3f(-smooth) : smooth;
  const float side = smooth.dot(out.face) < 0 ? -1.0f : 1.0f;
  // Rays start above the smooth surface, or shadows would show the triangles.
  out.start = out.position + bulge(instance, mesh, face, weights, side) * out.normal;
  if (mesh.look) {
    // Wider where it is met at a slant, by the area that it covers.
    const float slant = std::sqrt(std::max(std::abs(direction.dot(out.face)), 0.05f));
    const float size = instance.scale * std::sqrt(std::max(across.norm(), 1e-30f));
    const FacePoint at{mesh.look_face[face], weights, width / (slant * size)};
    apply_look(instance, FaceLook(*mesh.look, at), own, out);
  }
  if (const auto& h = instance.highlight) {
    const float share = unit_or((*h)[3], 0);
    for (int i = 0; i < 3; ++i)
      out.material.base[i] += share * (unit_or((*h)[i], 0) - out.material.base[i]);
  }
  return out;
}

}  // namespace trivet
