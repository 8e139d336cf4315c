#include "ops/files/json/json_values.h"

#include "core/base/limits.h"
#include "ops/files/layout/layout.h"

namespace trivet {

Vec2 read_vec2(const JsonPlace& place) {
  const std::vector<double> p = place.numbers(2);
  return {p[0], p[1]};
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

}  // namespace trivet
