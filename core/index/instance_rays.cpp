#include "core/index/instance_rays.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/index/embree.h"

namespace trivet {
namespace {

constexpr float kDark = 0.002f;  // what passes less counts as opaque

// Data that Embree keeps pointers to.
struct RayMesh {
  std::vector<float> vertices;  // and 16 bytes that Embree may read
  std::vector<Index3> opaque, see_through;
  std::vector<std::uint32_t> opaque_ids, see_through_ids;  // of the mesh's faces
  std::vector<Vec3f> passed;                               // of the see-through ones
  PassedAt passed_at;
  EmbreePointer<RTCScene> scene;
};

// A packet's query, with what has passed so far.
struct PassQuery : EmbreeRayQuery {
  std::array<Vec3f, kRayLanes>* passed;
};

void pass_face(const RTCFilterFunctionNArguments* arguments) {
  const auto& mesh = *static_cast<const RayMesh*>(arguments->geometryUserPtr);
  auto& passed = *static_cast<const PassQuery*>(arguments->context)->passed;
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (!arguments->valid[i]) continue;
    const unsigned lane = RTCRayN_id(arguments->ray, arguments->N, i);
    const unsigned face = RTCHitN_primID(arguments->hit, arguments->N, i);
    Vec3f& light = passed[lane];
    light = light.cwiseProduct(mesh.passed[face]);
    if (mesh.passed_at)
      light *=
          mesh.passed_at(mesh.see_through_ids[face], RTCHitN_u(arguments->hit, arguments->N, i),
                         RTCHitN_v(arguments->hit, arguments->N, i));
    // The ray goes on while enough light is left.
    if (light.maxCoeff() >= kDark) arguments->valid[i] = 0;
  }
}

EmbreePointer<RTCGeometry> make_triangles(RayMesh& mesh, std::vector<Index3>& faces) {
  EmbreePointer<RTCGeometry> geometry(rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_TRIANGLE));
  if (!geometry) return geometry;
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.vertices.data(), 0, 3 * sizeof(float),
                             mesh.vertices.size() / 3 - 2);
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             faces.data(), 0, sizeof(Index3), faces.size());
  return geometry;
}

void copy_rays(const RayPacket& rays, RTCRay8& out) {
  // Lanes are laid out alike in both: whole arrays are copied.
  const std::size_t bytes = sizeof rays.nearest;
  std::memcpy(out.org_x, rays.origin[0], bytes);
  std::memcpy(out.org_y, rays.origin[1], bytes);
  std::memcpy(out.org_z, rays.origin[2], bytes);
  std::memcpy(out.dir_x, rays.direction[0], bytes);
  std::memcpy(out.dir_y, rays.direction[1], bytes);
  std::memcpy(out.dir_z, rays.direction[2], bytes);
  std::memcpy(out.tnear, rays.nearest, bytes);
  std::memcpy(out.tfar, rays.farthest, bytes);
  for (int i = 0; i < kRayLanes; ++i) {
    out.time[i] = 0, out.mask[i] = ~0u, out.flags[i] = 0;
    out.id[i] = static_cast<unsigned>(i);
  }
}

}  // namespace

struct InstanceRays::State {
  std::vector<std::unique_ptr<RayMesh>> meshes;
  std::vector<std::uint32_t> mesh_of;  // of each instance
  EmbreePointer<RTCScene> scene;
};

InstanceRays::InstanceRays() : m_state(std::make_unique<State>()) {
  m_state->scene.reset(rtcNewScene(embree_device()));
  if (m_state->scene) rtcSetSceneFlags(m_state->scene.get(), RTC_SCENE_FLAG_ROBUST);
  throw_embree_error("start a scene for pictures");
}
InstanceRays::~InstanceRays() = default;

std::uint32_t InstanceRays::add_mesh(std::span<const Vec3f> vertices,
                                     std::span<const Index3> triangles,
                                     std::span<const Vec3f> passed, PassedAt passed_at) {
  auto mesh = std::make_unique<RayMesh>();
  mesh->passed_at = std::move(passed_at);
  for (const Vec3f& v : vertices)
    mesh->vertices.insert(mesh->vertices.end(), {v.x(), v.y(), v.z()});
  // Six floats behind the last vertex are no vertices: Embree may read past the end.
  mesh->vertices.insert(mesh->vertices.end(), 6, 0.0f);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    // Only see-through faces pay for a callback.
    const bool opaque = passed.empty() || passed[f].maxCoeff() < kDark;
    (opaque ? mesh->opaque : mesh->see_through).push_back(triangles[f]);
    (opaque ? mesh->opaque_ids : mesh->see_through_ids).push_back(static_cast<std::uint32_t>(f));
    if (!opaque) mesh->passed.push_back(passed[f]);
  }
  mesh->scene.reset(rtcNewScene(embree_device()));
  if (mesh->scene) rtcSetSceneFlags(mesh->scene.get(), RTC_SCENE_FLAG_ROBUST);
  // Opaque faces end shadow rays at once; see-through ones ask pass_face() how much is left.
  for (std::vector<Index3>* faces : {&mesh->opaque, &mesh->see_through}) {
    if (faces->empty()) continue;
    const EmbreePointer<RTCGeometry> geometry = make_triangles(*mesh, *faces);
    throw_embree_error("hold a mesh for pictures");
    if (faces == &mesh->see_through) {
      rtcSetGeometryUserData(geometry.get(), mesh.get());
      rtcSetGeometryOccludedFilterFunction(geometry.get(), pass_face);
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(mesh->scene.get(), geometry.get(), faces == &mesh->opaque ? 0 : 1);
  }
  rtcCommitScene(mesh->scene.get());
  throw_embree_error("build a mesh for pictures");
  m_state->meshes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(m_state->meshes.size() - 1);
}

std::uint32_t InstanceRays::add_instance(std::uint32_t mesh, const std::array<Vec3f, 4>& columns) {
  const EmbreePointer<RTCGeometry> geometry(
      rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_INSTANCE));
  throw_embree_error("hold an instance for pictures");
  float matrix[12];
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r) matrix[3 * c + r] = columns[c][r];
  rtcSetGeometryInstancedScene(geometry.get(), m_state->meshes[mesh]->scene.get());
  rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix);
  rtcCommitGeometry(geometry.get());
  const auto id = static_cast<std::uint32_t>(m_state->mesh_of.size());
  rtcAttachGeometryByID(m_state->scene.get(), geometry.get(), id);
  m_state->mesh_of.push_back(mesh);
  return id;
}

void InstanceRays::commit() {
  rtcCommitScene(m_state->scene.get());
  throw_embree_error("build a scene for pictures");
}

HitPacket InstanceRays::first_hits(const RayPacket& rays) const {
  alignas(64) RTCRayHit8 query;
  copy_rays(rays, query.ray);
  for (int i = 0; i < kRayLanes; ++i) query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  alignas(32) std::int32_t valid[kRayLanes];
  std::memcpy(valid, rays.on, sizeof valid);
  EmbreeRayQuery context;
  intersect_packet(m_state->scene.get(), valid, context, query);
  HitPacket out{};
  for (int i = 0; i < kRayLanes; ++i) {
    out.face[i] = kNoFace;
    if (!valid[i] || query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    // The hit names an instance and a face of one of its two geometries.
    out.instance[i] = query.hit.instID[0][i];
    const RayMesh& mesh = *m_state->meshes[m_state->mesh_of[out.instance[i]]];
    const auto& ids = query.hit.geomID[i] == 0 ? mesh.opaque_ids : mesh.see_through_ids;
    out.face[i] = ids[query.hit.primID[i]];
    out.distance[i] = query.ray.tfar[i];
    out.v[i] = query.hit.u[i], out.w[i] = query.hit.v[i];
  }
  return out;
}

std::array<Vec3f, kRayLanes> InstanceRays::passed(const RayPacket& rays) const {
  alignas(64) RTCRay8 query;
  copy_rays(rays, query);
  alignas(32) std::int32_t valid[kRayLanes];
  std::memcpy(valid, rays.on, sizeof valid);
  std::array<Vec3f, kRayLanes> out;
  out.fill(Vec3f::Ones());
  PassQuery context;
  context.passed = &out;
  // A ray that found an opaque face ends with a negative length.
  occlude_packet(m_state->scene.get(), valid, context, query);
  for (int i = 0; i < kRayLanes; ++i)
    if (valid[i] && query.tfar[i] < 0) out[i].setZero();
  return out;
}

}  // namespace trivet
