#include "ops/placement/contacts.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"

namespace trivet {

std::vector<ContactsWith> contacts_with(const Body& body, const Neighbourhood& others,
                                        double tolerance, double slack) {
  std::vector<ContactsWith> out;
  // The floor comes first, as in all lists of partners.
  if (others.floor()) {
    auto points = floor_contact_points(body, tolerance);
    if (!points.empty()) out.push_back({Support::floor(), std::move(points)});
  }
  if (body.world_box.empty()) return out;
  // Wide enough that what contact_points() finds is among the neighbours after rounding.
  const double margin = 1.01 * tolerance + 1e-13 * body.world_box.max_abs_coordinate();
  const Neighbours near = others.near(body.world_box, margin);
  for (size_t i = 0; i < near.ids.size(); ++i) {
    auto points = contact_points(body, near.bodies[i], tolerance, slack);
    if (!points.empty()) out.push_back({near.ids[i], std::move(points)});
  }
  return out;
}

std::vector<ContactsWith> touching(const Body& body, const Neighbourhood& others,
                                   double clearance) {
  return contacts_with(body, others, kContactTolerance * clearance, kFootSlack * clearance);
}

std::vector<ContactPoint> all_points(const std::vector<ContactsWith>& contacts, double distance) {
  std::vector<ContactPoint> all;
  for (const ContactsWith& c : contacts) {
    const std::vector<ContactPoint> points = merged(c.points, distance);
    all.insert(all.end(), points.begin(), points.end());
  }
  return all;
}

std::vector<ObjectContact> object_contacts_of(const Object& object, const Pose& pose,
                                              const Scene& scene,
                                              const std::vector<ContactsWith>& contacts,
                                              double clearance) {
  const Body body = body_of(object, pose);
  const double size = size_of(object);
  std::vector<ObjectContact> object_contacts;
  object_contacts.reserve(contacts.size());
  for (const ContactsWith& c : contacts) {
    // Points of several faces at one place are one point.
    const auto points = merged(c.points, kContactTolerance * clearance);
    if (c.with.is_floor()) {
      object_contacts.push_back(
          {c.with, make_contact(points, body, nullptr, kContactExtent * size)});
      continue;
    }
    const Object& other = scene.at(c.with.object());
    const Body support = body_of(other);
    // The smaller of both objects decides how large a contact has to be to be a line or an area.
    const double smaller = std::min(size, size_of(other));
    object_contacts.push_back(
        {c.with, make_contact(points, body, &support, kContactExtent * smaller)});
  }
  return object_contacts;
}

std::vector<ContactsWith> linked_contacts(const Object& object) {
  std::vector<ContactsWith> out;
  out.reserve(object.contacts.size());
  for (const ObjectContact& entry : object.contacts)
    if (!entry.across_gap) out.push_back({entry.with, entry.contact.points});
  return out;
}

}  // namespace trivet
