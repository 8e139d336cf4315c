// Contacts of an object with its neighbourhood, and as links of the scene.
#pragma once

#include <vector>

#include "ops/placement/neighbourhood.h"

namespace trivet {

/// Contact points with one partner.
struct ContactsWith {
  Support with;
  std::vector<ContactPoint> points;
};

/// All that `body` touches: the floor first, then in the order of the scene; none is empty.
/// @param tolerance  metres, of gaps. @param slack  see contact_points().
std::vector<ContactsWith> contacts_with(const Body& body, const Neighbourhood& others,
                                        double tolerance, double slack);

/// Contacts within kContactTolerance clearances.
std::vector<ContactsWith> touching(const Body& body, const Neighbourhood& others, double clearance);

/// All points together, those at one place merged.
std::vector<ContactPoint> all_points(const std::vector<ContactsWith>& contacts, double distance);

/// Contacts of an object at `pose` as links.
std::vector<ObjectContact> object_contacts_of(const Object& object, const Pose& pose,
                                              const Scene& scene,
                                              const std::vector<ContactsWith>& contacts,
                                              double clearance);

/// Contacts that the scene's links keep, without those across gaps; those at one place are one.
std::vector<ContactsWith> linked_contacts(const Object& object);

}  // namespace trivet
