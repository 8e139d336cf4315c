#include "ops/files/json/values.h"

#include "core/base/limits.h"
#include "core/io/cad_format.h"
#include "ops/files/layout/layout.h"
#include "ops/free_places/place_region.h"
#include "ops/operations/append.h"

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
  out = region_of(out);
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

Rotation read_rotation(const JsonPlace& place) {
  const std::vector<double> q = place.numbers(4, -kMaxQuaternionComponent, kMaxQuaternionComponent);
  if (const auto rotation = unit_rotation({q[0], q[1], q[2], q[3]})) return *rotation;
  place.refuse("a quaternion [w, x, y, z] whose length is not zero");
}

UpAxis read_up(const JsonPlace& place) {
  if (place.value() == "y") return UpAxis::Y;
  if (place.value() == "z") return UpAxis::Z;
  place.refuse("\"y\" or \"z\"");
}

Tessellation read_tessellation(const JsonPlace& place, const std::string& model) {
  Tessellation out;
  if (const auto chord = place.find("chord")) out.chord = chord->number(kMinChord, kMaxChord);
  if (const auto angle = place.find("facet_angle_deg"))
    out.facet_angle_deg = angle->number(kMinFacetAngleDeg, kMaxFacetAngleDeg);
  for (const char* const key : {"chord", "facet_angle_deg"})
    if (const auto found = place.find(key); found && cad_format(model).empty())
      found->fail(no_curved_surfaces(model));
  return out;
}

Pose read_pose(const JsonPlace& place) {
  Pose pose;
  pose.translation = read_position(place.at("position"));
  if (const auto rotation = place.find("rotation")) pose.rotation = read_rotation(*rotation);
  return pose;
}

void write_tessellation(const Tessellation& tessellation, nlohmann::ordered_json& json) {
  const Tessellation standard;
  const auto& [chord, angle] = tessellation;
  if (chord != standard.chord) json["chord"] = chord;
  if (angle != standard.facet_angle_deg) json["facet_angle_deg"] = angle;
}

void write_pose(const Pose& pose, nlohmann::ordered_json& json) {
  const Vec3& p = pose.translation;
  const Rotation& r = pose.rotation;
  json["position"] = {p.x(), p.y(), p.z()};
  json["rotation"] = {r.w, r.x, r.y, r.z};
}

}  // namespace trivet
