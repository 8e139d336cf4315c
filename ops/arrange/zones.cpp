#include "ops/arrange/zones.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "core/model/exported_floats.h"
#include "ops/placement/verify.h"

namespace trivet {
namespace {

bool is_in(const World& world, const Object& zone, const Pose& pose, const Object& other) {
  const Body a = body_of(zone, pose), b = body_of(other);
  // The exact test tells whether the surfaces cross or one holds the other.
  if (!overlaps(a.world_box, b.world_box, 0)) return false;
  const Vec3 origin = export_origin(world.scene().box());
  return !verify_pair(in_world(zone, pose, origin), in_world(other, other.pose, origin), false, 1)
              .clear();
}

// Carries it, and so may be in its zones.
bool carries(const Object& owner, ObjectId other) {
  return std::any_of(owner.contacts.begin(), owner.contacts.end(), [&](const ObjectContact& c) {
    return c.with == Support(other) && holds_up(c);
  });
}

Mesh box_mesh(const Vec3& lower, const Vec3& upper) {
  const auto corner = [&](int i) {
    return Vec3(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                i & 4 ? upper.z() : lower.z());
  };
  constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  // Each side is two triangles that look outwards.
  std::vector<Triangle> triangles;
  triangles.reserve(12);
  for (const auto& side : kSides)
    for (const int second : {1, 2})
      triangles.push_back({corner(side[0]), corner(side[second]), corner(side[second + 1])});
  return weld(triangles);
}

}  // namespace

Object object_of(const Zone& zone) {
  // A zone is a little smaller than was asked for, so that what just touches it is outside.
  const Vec3 slack = Vec3::Constant(kZoneSlack);
  Object out;
  out.name = zone.name;
  out.shape = make_shape(box_mesh(zone.lower + slack, zone.upper - slack));
  out.up = UpAxis::Z;
  return out;
}

std::vector<Body> zones_of(const World& world, const std::string& object, const Pose& pose) {
  std::vector<Body> out;
  const std::vector<Zone>& zones = world.arrangement().zones;
  for (size_t z = 0; z < zones.size(); ++z)
    if (zones[z].object == object) out.push_back(body_of(world.zone(z), pose));
  return out;
}

std::optional<Sentence> taken_zone(const World& world, const ThingModel& thing) {
  const std::vector<Zone>& zones = world.arrangement().zones;
  const Object& object = world.object(thing);
  const auto said = [](const std::string& name, const Zone& zone) {
    return say("%1 is in the %2", quoted(name), zone.text());
  };
  for (size_t z = 0; z < zones.size(); ++z) {
    if (!world.stands(zones[z].object)) continue;
    const Object& owner = world.scene().at(*world.scene().find(zones[z].object));
    // The thing may be in a zone of another one, and others in its own.
    if (owner.name != object.name) {
      if (!carries(owner, thing.id) && is_in(world, world.zone(z), owner.pose, object))
        return said(object.name, zones[z]);
      continue;
    }
    for (const ObjectId id : world.standing())
      if (id != thing.id && !carries(owner, id) &&
          is_in(world, world.zone(z), owner.pose, world.scene().at(id)))
        return said(world.scene().at(id).name, zones[z]);
  }
  return std::nullopt;
}

}  // namespace trivet
