// One candidate of first contact, decided: what BVHs, z-lists and brute force share. Private.
#pragma once

#include <span>

#include "core/contact/first_contact.h"

namespace trivet {

/// first_contact() of two triangles.
struct DecidedPair {
  PairContact contact;
  double apart_until;          // proved; of a Free pair whatever the motion's limit
  Vec3 normal = Vec3::Zero();  // unit, of a plane between them at the start; zero: not known
};
DecidedPair decide_pair(const Triangle& moving, const Triangle& fixed, const Motion& motion,
                        const Clearance& clearance, double best);

/// Decides a pair of faces, and keeps it if it is earlier than `best` in the order of
/// (time, moving, fixed, face_moving, face_fixed); so the order of the candidates does not matter.
/// @param a, b  the faces' corners, world, at time 0.
/// @return without its contact.
DecidedPair decide_faces(const FirstContactQuery& query, Index moving, Index fixed,
                         Index face_moving, Index face_fixed, const Triangle& a, const Triangle& b,
                         FirstContact& best);

/// Time until which a plane that stands still, with unit normal n, keeps all moving triangles
/// farther than any pair stops from all fixed ones. 0: not until `horizon`.
double apart_by_plane(std::span<const Triangle> moving, std::span<const Triangle> fixed,
                      const Vec3& n, const Motion& motion, double largest_stop, double horizon);

/// The same for a vertex of a moving body and the floor.
void decide_floor_vertex(const FirstContactQuery& query, Index moving, Index vertex,
                         FirstContact& best);

/// The same for all vertices of a moving body, by its tree or, for a body whose tree need not be
/// built for that, one by one.
void decide_floor(const FirstContactQuery& query, Index moving, FirstContact& best);
void decide_floor_without_tree(const FirstContactQuery& query, Index moving, FirstContact& best);

}  // namespace trivet
