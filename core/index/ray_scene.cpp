// Embree sees a mesh of half extent 1 about the origin, and of a ray the piece within kRayReach of
// it, so that its arithmetic loses less than kRayGrowth, however far away ray and mesh are.
#include "core/index/ray_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/outward.h"
#include "core/base/task_order.h"

namespace trivet {
namespace {

constexpr double kRayGrowth = 1e-5;
constexpr double kRayReach = 2;
/// Farther away, double itself loses more than kRayGrowth.
constexpr double kFarthestRay = 1e8;

// Data for the callbacks with which Embree builds.
struct ScaledMesh {
  const Mesh& mesh;
  Vec3 centre;
  double scale;
  TaskOrder order = {};
};

void give_face_box(const RTCBoundsFunctionArguments* arguments) {
  auto& faces = *static_cast<ScaledMesh*>(arguments->geometryUserPtr);
  // Embree calls this on its threads, whose order sanitizers do not see.
  const OrderedStep step(faces.order);
  Aabb box;
  for (const Vec3& p : faces.mesh.triangle(static_cast<Index>(arguments->primID)))
    box.extend((p - faces.centre) * faces.scale);
  RTCBounds& out = *arguments->bounds_o;
  // Boxes grow and are rounded outwards: Embree reads them in float32.
  out.lower_x = float_below(box.lower.x() - kRayGrowth);
  out.lower_y = float_below(box.lower.y() - kRayGrowth);
  out.lower_z = float_below(box.lower.z() - kRayGrowth);
  out.upper_x = float_above(box.upper.x() + kRayGrowth);
  out.upper_y = float_above(box.upper.y() + kRayGrowth);
  out.upper_z = float_above(box.upper.z() + kRayGrowth);
}

// A ray with what its callback needs. Embree's times are lengths from `start`.
struct FaceQuery : EmbreeRayQuery {
  const RayScene::Visit* visit;
  double start, speed;  // a time; length per time

  float length_until(double time) const { return float_above((time - start) * speed + kRayGrowth); }
};

void visit_face(const RTCIntersectFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  const auto& query = *static_cast<const FaceQuery*>(arguments->context);
  // The visit tells until when faces matter; Embree shortens the ray by it.
  const double until = (*query.visit)(static_cast<Index>(arguments->primID));
  float& end = RTCRayN_tfar(RTCRayHitN_RayN(arguments->rayhit, 1), 1, 0);
  end = std::min(end, query.length_until(until));
}

struct RayPiece {
  double start, end;  // times
};

// Piece of the ray within kRayReach of the origin, along each axis.
RayPiece ray_piece(const Vec3& origin, const Vec3& direction, double until) {
  RayPiece out{0, until};
  for (int k = 0; k < 3; ++k) {
    // Along an axis of no motion the ray is within reach all the time, or never.
    if (direction[k] == 0) {
      if (std::abs(origin[k]) > kRayReach) return {0, -1};
      continue;
    }
    const double a = (-kRayReach - origin[k]) / direction[k],
                 b = (kRayReach - origin[k]) / direction[k];
    out.start = std::max(out.start, std::min(a, b));
    out.end = std::min(out.end, std::max(a, b));
  }
  return out;
}

RTCRayHit embree_ray(const Vec3& origin, const Vec3& direction, float length) {
  RTCRayHit out{};
  out.ray.org_x = static_cast<float>(origin.x());
  out.ray.org_y = static_cast<float>(origin.y());
  out.ray.org_z = static_cast<float>(origin.z());
  out.ray.dir_x = static_cast<float>(direction.x());
  out.ray.dir_y = static_cast<float>(direction.y());
  out.ray.dir_z = static_cast<float>(direction.z());
  out.ray.tfar = length;
  out.ray.mask = ~0u;
  out.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return out;
}

}  // namespace

RayScene::RayScene(const Mesh& mesh) : m_num_faces(static_cast<Index>(mesh.triangles.size())) {
  const Aabb box = mesh.box();
  const double half = box.half_extent().maxCoeff();
  m_centre = box.centre();
  // Meshes of extreme sizes are left to brute force.
  if (!(half > 1e-100 && half < 1e100) || m_num_faces == 0) return;
  const RTCDevice device = embree_device();
  ScaledMesh faces{mesh, m_centre, 1 / half};
  m_scene.reset(rtcNewScene(device));
  const EmbreePointer<RTCGeometry> geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  if (m_scene && geometry) {
    rtcSetSceneBuildQuality(m_scene.get(), RTC_BUILD_QUALITY_LOW);
    rtcSetSceneFlags(m_scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(m_num_faces));
    rtcSetGeometryUserData(geometry.get(), &faces);  // read until the scene is committed
    rtcSetGeometryBoundsFunction(geometry.get(), give_face_box, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), visit_face);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(m_scene.get(), geometry.get());
    // Embree's threads read `faces` in between, which sanitizers are told.
    faces.order.give();
    rtcCommitScene(m_scene.get());
    faces.order.take();
  }
  throw_embree_error("build a scene for rays");
  m_scale = faces.scale;
}

void RayScene::visit(const Vec3& origin, const Vec3& direction, double until,
                     const Visit& visit) const {
  const Vec3 from = (origin - m_centre) * m_scale, along = direction * m_scale;
  const double speed = along.norm();
  const bool fits = from.cwiseAbs().maxCoeff() < kFarthestRay && speed > 0 && speed < kInfinity;
  // Beyond what float32 can hold, every face is visited.
  if (m_scale == 0 || !fits) {
    for (Index face = 0; face < m_num_faces; ++face) visit(face);
    return;
  }
  // Embree gets the piece of the ray near the mesh, where float32 has digits to spare.
  const RayPiece piece = ray_piece(from, along, until);
  if (!(piece.start <= piece.end)) return;
  FaceQuery query;
  query.visit = &visit;
  query.start = piece.start;
  query.speed = speed;
  RTCRayHit ray =
      embree_ray(from + piece.start * along, along / speed, query.length_until(piece.end));
  find_hits(m_scene.get(), query, ray);
}

}  // namespace trivet
