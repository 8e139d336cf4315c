#include "trivet/geometry.h"

#include <algorithm>
#include <cmath>

#include "apps/library/internals.h"
#include "core/base/bad_input.h"
#include "core/base/tunables.h"
#include "core/contact/first_contact.h"
#include "core/exact/interpenetration.h"
#include "core/mesh/weld_arrays.h"

namespace trivet::v0 {
namespace {

constexpr double kMaxCoordinate = 1e30;  // as of model files: squares and volumes stay finite

std::shared_ptr<const trivet::Shape> made(const Mesh& mesh) {
  std::vector<trivet::Vec3> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) {
    if (std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > kMaxCoordinate)
      bad_input("vertices: %1 has a coordinate beyond 1e30; accepted: -1e30 to 1e30",
                vertices.size());
    vertices.push_back(inner(v));
  }
  std::vector<Index3> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) triangles.push_back({t.a, t.b, t.c});
  return make_shape(weld(vertices, triangles).mesh);
}

Body body_of(const PlacedShape& placed) {
  if (!(placed.scale > 0) || !std::isfinite(placed.scale))
    bad_input("scale: %1; accepted: above 0", std::to_string(placed.scale));
  return Body(*placed.shape.internal().shape,
              world_from_object(inner(placed.pose), UpAxis::Z, placed.scale));
}

trivet::Vec3 unit(const Vec3& direction, const char* name) {
  const trivet::Vec3 given = inner(direction);
  if (!given.allFinite() || !(given.norm() > 0))
    bad_input("%1: of length 0 or not finite; accepted: any other", std::string(name));
  return given.normalized();
}

// The clearance of a scene of these alone.
double usual_clearance(const Body& moving, const Body* fixed) {
  Aabb box = moving.world_box;
  if (fixed) box.extend(fixed->world_box);
  return kRelativeClearance * std::max(box.diagonal(), box.max_abs_coordinate());
}

FirstContactQuery query_of(const Body& moving, const Body* fixed, double clearance) {
  FirstContactQuery query;
  query.moving = {&moving, 1};
  if (fixed)
    query.fixed = {fixed, 1};
  else
    query.floor = true;
  query.clearance.distance = clearance > 0 ? clearance : usual_clearance(moving, fixed);
  return query;
}

FirstContact outer(const trivet::FirstContact& found, double amount) {
  FirstContact out;
  out.crossing = found.status == trivet::FirstContact::Status::Crossing;
  out.amount = out.crossing ? 0 : amount;
  out.point = v0::outer(found.point);
  out.normal = v0::outer(found.normal);
  out.gap = found.gap;
  return out;
}

std::optional<FirstContact> slide(const PlacedShape& moving, const Body* fixed,
                                  const Translation& motion, double clearance) {
  const Body body = body_of(moving);
  FirstContactQuery query = query_of(body, fixed, clearance);
  trivet::Vec3 direction = unit(motion.direction, "direction");
  if (motion.distance < 0) direction = -direction;
  query.motion = Motion::translation(direction, std::abs(motion.distance));
  const trivet::FirstContact found = trivet::first_contact(query);
  if (found.status == trivet::FirstContact::Status::Free) return std::nullopt;
  return outer(found, found.time);
}

// A quarter turn at a time, as motions are.
std::optional<FirstContact> turn(PlacedShape moving, const Body& fixed, const Turn& motion,
                                 double clearance) {
  trivet::Vec3 axis = unit(motion.axis, "axis");
  if (motion.angle_deg < 0) axis = -axis;
  double done = 0;
  for (double left = std::abs(motion.angle_deg); left > 0; left -= 90) {
    const double step = std::min(left, 90.0);
    const Body body = body_of(moving);
    FirstContactQuery query = query_of(body, &fixed, clearance);
    query.motion = Motion::rotation(inner(motion.centre), axis, turn_time(step));
    const trivet::FirstContact found = trivet::first_contact(query);
    if (found.status != trivet::FirstContact::Status::Free)
      return outer(found, done + (found.time > 0 ? turned_deg(found.time) : 0));
    moving.pose = v0::outer(moved_pose(inner(moving.pose), query.motion, query.motion.limit));
    done += step;
  }
  return std::nullopt;
}

trivet::PlacedShape placed(const PlacedShape& given) {
  return {given.shape.internal().shape.get(), nullptr, body_of(given).world_from_object};
}

}  // namespace

Shape::Shape(const Mesh& mesh)
    : m_internal(std::make_shared<Internal>(guarded([&] { return Internal{made(mesh)}; }))) {}
Shape::Shape(std::shared_ptr<const Internal> internal) : m_internal(std::move(internal)) {}

Mesh Shape::mesh() const {
  const trivet::Mesh& own = m_internal->shape->mesh;
  Mesh out;
  out.vertices.reserve(own.vertices.size());
  for (const trivet::Vec3& v : own.vertices) out.vertices.push_back(outer(v));
  out.triangles.reserve(own.triangles.size());
  for (const Index3& t : own.triangles) out.triangles.push_back({t[0], t[1], t[2]});
  return out;
}

std::size_t Shape::num_triangles() const { return m_internal->shape->mesh.triangles.size(); }
Box Shape::box() const { return outer(m_internal->shape->box); }
double Shape::volume() const { return m_internal->shape->mass.volume; }
double Shape::area() const { return m_internal->shape->mass.area; }
Vec3 Shape::centre_of_mass() const { return outer(m_internal->shape->mass.centre); }

MassRule Shape::mass_rule() const {
  switch (m_internal->shape->mass.rule) {
    case trivet::MassRule::Volume:
      return MassRule::Volume;
    case trivet::MassRule::Surface:
      return MassRule::Surface;
    case trivet::MassRule::Hull:
      break;
  }
  return MassRule::Hull;
}

std::optional<FirstContact> first_contact(const PlacedShape& moving, const PlacedShape& fixed,
                                          const Translation& motion, double clearance) {
  return guarded([&] {
    const Body body = body_of(fixed);
    return slide(moving, &body, motion, clearance);
  });
}

std::optional<FirstContact> first_contact(const PlacedShape& moving, const PlacedShape& fixed,
                                          const Turn& motion, double clearance) {
  return guarded([&] { return turn(moving, body_of(fixed), motion, clearance); });
}

std::optional<FirstContact> first_contact_with_floor(const PlacedShape& moving,
                                                     const Translation& motion, double clearance) {
  return guarded([&] { return slide(moving, nullptr, motion, clearance); });
}

Interpenetration interpenetration(const PlacedShape& a, const PlacedShape& b) {
  return guarded([&] {
    const trivet::PlacedShape first = placed(a), second = placed(b);
    Interpenetration out;
    out.crossing_pairs = count_crossings(first, second);
    if (out.crossing_pairs == 0)
      out.contained_parts =
          count_components_inside(first, second) + count_components_inside(second, first);
    return out;
  });
}

}  // namespace trivet::v0
