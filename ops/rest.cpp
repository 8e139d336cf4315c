#include "ops/rest.h"

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

Body body_at(const Object& object, const Pose& pose) {
  return {*object.shape, world_from_object(pose, object.up, object.scale)};
}

double size_of(const Object& object) { return object.scale * object.shape->box.diagonal(); }

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

// Margin and friction of an object that stays where it is.
void rate_rest(Object& object, const std::vector<ContactPoint>& points, double clearance) {
  const Vec3 centre = object.centre_of_mass();
  const double size = size_of(object);
  object.stability_margin = carrying_margin(points, centre);
  object.least_friction = least_friction(points, centre, size, residual_tolerance(size, clearance));
}

}  // namespace

Surroundings::Surroundings(const Scene& scene, ObjectId except) {
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (id == except || !object.placed) continue;
    ids.push_back(id);
    bodies.emplace_back(*object.shape, object.world_from_object());
  }
}

std::string Surroundings::name(const Scene& scene, Index fixed) const {
  return fixed == ContactsWith::kFloor ? "the floor" : "\"" + scene.at(ids[fixed]).name + "\"";
}

std::vector<ContactsWith> touching(const Scene& scene, const Object& object, const Pose& pose,
                                   const Surroundings& others, double clearance) {
  return contacts_with(body_at(object, pose), others.bodies, scene.floor,
                       kContactTolerance * clearance, kFootSlack * clearance);
}

bool rests_at(const Scene& scene, const Object& object, const Pose& pose,
              const Surroundings& others, double clearance) {
  const Body body = body_at(object, pose);
  const double tolerance = kBalanceTolerance * clearance;
  const auto near =
      contacts_with(body, others.bodies, scene.floor, tolerance, kFootSlack * clearance);
  return is_at_rest(all_points(near, tolerance),
                    body.world_from_object.apply(object.shape->mass.centre), size_of(object),
                    clearance);
}

void commit(Scene& scene, ObjectId id, const Pose& pose, ObjectState state,
            const Surroundings& others, const std::vector<ContactsWith>& contacts,
            double clearance) {
  Object& object = scene.at(id);
  object.pose = pose;
  object.placed = true;
  object.state = state;
  rate_rest(object, all_points(contacts, kContactTolerance * clearance), clearance);
  scene.link(id, links_of(object, pose, others, contacts, clearance));
}

}  // namespace trivet
