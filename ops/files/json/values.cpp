#include "ops/files/json/values.h"

#include "core/base/limits.h"
#include "core/io/cad_format.h"
#include "ops/files/layout/layout.h"
#include "ops/free_places/place_region.h"

namespace trivet {

Vec2 read_vec2(const JsonPlace& place) {
  const std::vector<double> p = place.numbers(2);
  return {p[0], p[1]};
}

std::vector<Vec2> read_region(const JsonPlace& place) {
  std::vector<Vec2> out;
  for (const JsonPlace& corner : place.items()) {
    const std::vector<double> p = corner.numbers(2, -kMaxLength, kMaxLength);
    out.push_back({p[0], p[1]});
  }
  if (out.size() == 2) {
    const Vec2 lower = out[0].cwiseMin(out[1]), upper = out[0].cwiseMax(out[1]);
    out = {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}};
  }
  if (!is_convex_region(out))
    place.refuse(
        "2 opposite corners [x, y] of a rectangle, or at least 3 of a convex polygon, "
        "counter-clockwise");
  return out;
}

Vec3 read_vec3(const JsonPlace& place) {
  const std::vector<double> p = place.numbers(3);
  return {p[0], p[1], p[2]};
}

Vec3 read_position(const JsonPlace& place) {
  const std::vector<double> p = place.numbers(3, -kMaxLength, kMaxLength);
  return {p[0], p[1], p[2]};
}

Vec2 read_vector(const JsonPlace& place, const Vec2&) { return read_vec2(place); }
Vec3 read_vector(const JsonPlace& place, const Vec3&) { return read_vec3(place); }

Rotation read_rotation(const JsonPlace& place) {
  const std::vector<double> q = place.numbers(4, -kMaxQuaternionComponent, kMaxQuaternionComponent);
  if (const auto rotation = unit_rotation({q[0], q[1], q[2], q[3]})) return *rotation;
  place.refuse("a quaternion [w, x, y, z] whose length is not zero");
}

void read_to(const JsonPlace& place, const char* key, bool& out) {
  if (const auto found = place.find(key)) out = found->boolean();
}

void read_to(const JsonPlace& place, const char* key, double& out) {
  if (const auto found = place.find(key)) out = found->number();
}

void read_to(const JsonPlace& place, const char* key, double lower, double upper, double& out) {
  if (const auto found = place.find(key)) out = found->number(lower, upper);
}

void read_to(const JsonPlace& place, const char* key, std::optional<Vec3>& out) {
  if (const auto found = place.find(key)) out = read_vec3(*found);
}

void read_to(const JsonPlace& place, const char* key, std::optional<std::string>& out) {
  if (const auto found = place.find(key)) out = found->text();
}

UpAxis read_up(const JsonPlace& place) {
  if (place.value() == "y") return UpAxis::Y;
  if (place.value() == "z") return UpAxis::Z;
  place.refuse("\"y\" or \"z\"");
}

Tessellation read_tessellation(const JsonPlace& place, const std::string& model) {
  Tessellation out;
  read_to(place, "chord", kMinChord, kMaxChord, out.chord);
  read_to(place, "facet_angle_deg", kMinFacetAngleDeg, kMaxFacetAngleDeg, out.facet_angle_deg);
  for (const char* const key : {"chord", "facet_angle_deg"})
    if (const auto found = place.find(key); found && cad_format(model).empty())
      found->fail(
          say("\"%1\" has no curved surfaces; accepted: with models in STEP, IGES or BREP (.step "
              ".stp .iges .igs .brep .brp)",
              model));
  return out;
}

Pose read_pose(const JsonPlace& place) {
  Pose pose;
  pose.translation = read_position(place.at("position"));
  if (const auto rotation = place.find("rotation")) pose.rotation = read_rotation(*rotation);
  return pose;
}

}  // namespace trivet
