#include "ops/rest.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "ops/settle/equilibrium.h"
#include "ops/verify.h"

namespace trivet {
namespace {

Body body_at(const Object& object, const Pose& pose) {
  return {*object.shape, world_from_object(pose, object.up, object.scale)};
}

double size_of(const Object& object) { return object.scale * object.shape->box.diagonal(); }

}  // namespace

std::vector<Link> links_of(const Object& object, const Pose& pose, const Surroundings& others,
                           const std::vector<ContactsWith>& contacts, double clearance) {
  const Body body = body_at(object, pose);
  const double extent = kContactExtent * size_of(object);
  std::vector<Link> links;
  for (const ContactsWith& c : contacts) {
    const bool floor = c.fixed == ContactsWith::kFloor;
    const auto points = merged(c.points, kContactTolerance * clearance);
    Link link;
    if (!floor) link.with = others.ids[c.fixed];
    link.contact = make_contact(points, body, floor ? nullptr : &others.bodies[c.fixed], extent);
    links.push_back(std::move(link));
  }
  return links;
}

Surroundings::Surroundings(const Scene& scene, ObjectId except)
    : Surroundings(scene, std::span<const ObjectId>(&except, 1)) {}

Surroundings::Surroundings(const Scene& scene, std::span<const ObjectId> except)
    : floor(scene.floor) {
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed || std::find(except.begin(), except.end(), id) != except.end()) continue;
    ids.push_back(id);
    bodies.emplace_back(*object.shape, object.world_from_object());
  }
}

void Surroundings::leave_out(std::span<const std::optional<ObjectId>> left_out) {
  for (const std::optional<ObjectId>& out : left_out) {
    if (!out) {
      floor = false;
    } else if (const auto it = std::find(ids.begin(), ids.end(), *out); it != ids.end()) {
      bodies.erase(bodies.begin() + (it - ids.begin()));
      ids.erase(it);
    }
  }
}

Surroundings holders(const Scene& scene, ObjectId id) {
  Surroundings out(scene, id);
  out.leave_out(passed_through(scene, id));
  return out;
}

std::string Surroundings::name(const Scene& scene, Index fixed) const {
  return fixed == ContactsWith::kFloor ? "the floor" : "\"" + scene.at(ids[fixed]).name + "\"";
}

std::vector<ContactsWith> touching(const Object& object, const Pose& pose,
                                   const Surroundings& others, double clearance) {
  return contacts_with(body_at(object, pose), others.bodies, others.floor,
                       kContactTolerance * clearance, kFootSlack * clearance);
}

bool rests_at(const Object& object, const Pose& pose, const Surroundings& others,
              double clearance) {
  SettleProblem problem{object.shape.get(), object.up,    object.scale, pose,
                        others.bodies,      others.floor, clearance,    {}};
  return is_at_rest(problem);
}

RestRating rate_rest(const Object& object, const Pose& pose,
                     const std::vector<ContactsWith>& contacts, double clearance) {
  const auto points = all_points(contacts, kContactTolerance * clearance);
  const Vec3 centre = body_at(object, pose).world_from_object.apply(object.shape->mass.centre);
  const double size = size_of(object);
  return {carrying_margin(points, centre),
          least_friction(points, centre, size, residual_tolerance(size, clearance))};
}

RestRating rate_unheld(const Object& object, const Pose& pose,
                       const std::vector<ContactsWith>& contacts, double clearance) {
  const auto points = all_points(contacts, kContactTolerance * clearance);
  const Vec3 centre = body_at(object, pose).world_from_object.apply(object.shape->mass.centre);
  return {carrying_margin(points, centre), kInfinity};
}

void commit(Scene& scene, ObjectId id, const Pose& pose, ObjectState state,
            const Surroundings& others, const std::vector<ContactsWith>& contacts,
            double clearance) {
  Object& object = scene.at(id);
  const bool unheld = state == ObjectState::Held || state == ObjectState::Unsupported ||
                      state == ObjectState::Invalid;
  const RestRating rating = unheld ? rate_unheld(object, pose, contacts, clearance)
                                   : rate_rest(object, pose, contacts, clearance);
  scene.link(id, links_of(object, pose, others, contacts, clearance));
  // Nothing below can fail.
  object.pose = pose;
  object.placed = true;
  object.state = state;
  object.stability_margin = rating.stability_margin;
  object.least_friction = rating.least_friction;
}

}  // namespace trivet
