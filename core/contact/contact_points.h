// Touching features of two bodies, from their poses alone.
#pragma once

#include "core/contact/body.h"
#include "core/contact/contact.h"

namespace trivet {

/// Every place where the distance of the two surfaces has a local minimum of at most `tolerance`:
/// vertices over faces (either way), crossing edges, and vertices beside edges or other vertices,
/// which are the ends of parallel edges, too. A feature whose surroundings dip through the plane of
/// the contact by more than kConeSlope lies past the end of a face, and is left out. Of flat faces
/// on each other the corners of the hull of their overlap, as far as no point before is there; see
/// flush_faces.h. Where all that finds none, the closest points of the faces are taken.
/// Sorted by features, those of the body that comes first before the other's: seen from the other
/// side, the same points are found to the bit, in the same order. Means nothing for bodies that
/// cross.
/// Cost O(log faces + near pairs of faces, sorted); at most a point per pair of features, and the
/// corners of a convex polygon per pair of flat neighbourhoods.
/// @param slack  metres by which a foot may be outside a face and still count as inside; at most
///   kFootSlope of its height, as the face's normal means less the nearer the surfaces are.
std::vector<ContactPoint> contact_points(const Body& object, const Body& support, double tolerance,
                                         double slack);

/// True if the contacts of a pair are found from `a`: an order by the shapes, then by the poses,
/// whoever asks. Of bodies that are the same in both, neither comes first.
bool comes_first(const Body& a, const Body& b);

/// The same contact seen from the other side.
ContactPoint seen_from_support(ContactPoint p);
Contact seen_from_support(Contact contact);

/// The same with the floor z = 0: vertices.
std::vector<ContactPoint> floor_contact_points(const Body& object, double tolerance);

/// True if the points are nearer to each other than `distance` and have the same normal (to 1e-2).
bool same_place(const ContactPoint& p, const ContactPoint& q, double distance);

/// Points at the same place become one, the one with the smallest gap (then the first).
std::vector<ContactPoint> merged(const std::vector<ContactPoint>& points, double distance);

/// Sums up: type by the principal extents against `extent`, hull in the contact's plane, mean
/// normal, smallest gap, faces. Seen from the other side, the same to the bit.
/// @param support  null for the floor.
Contact make_contact(const std::vector<ContactPoint>& points, const Body& object,
                     const Body* support, double extent);

/// Convex hull in the plane, counter-clockwise; collinear points are left out.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

}  // namespace trivet
