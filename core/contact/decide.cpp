#include "core/contact/decide.h"

#include <algorithm>
#include <tuple>

namespace trivet {
namespace {

bool earlier(const FirstContact& a, const FirstContact& b) {
  // Ties in time go by the indices, so that the order of the search never shows.
  return std::tie(a.time, a.moving, a.fixed, a.face_moving, a.face_fixed) <
         std::tie(b.time, b.moving, b.fixed, b.face_moving, b.face_fixed);
}

void keep_earlier(const FirstContact& found, FirstContact& best) {
  if (best.status == FirstContact::Status::Free || earlier(found, best)) {
    // The counts of work belong to the query, not to the contact that wins.
    const QueryWork work = best.work;
    best = found;
    best.work = work;
  }
}

}  // namespace

DecidedPair decide_faces(const FirstContactQuery& query, Index moving, Index fixed,
                         Index face_moving, Index face_fixed, const Triangle& a, const Triangle& b,
                         FirstContact& best) {
  // The best time so far is the horizon: a pair that meets later is only proved free until then.
  ++best.work.face_pairs;
  const DecidedPair decided = decide_pair(a, b, query.motion, query.clearance, best.time);
  const PairContact& pair = decided.contact;
  if (pair.status == PairContact::Status::Free) return decided;
  FirstContact found;
  found.status = pair.status == PairContact::Status::Crossing ? FirstContact::Status::Crossing
                                                              : FirstContact::Status::Contact;
  // A stalled pair counts as a contact where its proof ends: early perhaps, never late.
  found.stalled = pair.status == PairContact::Status::Stalled;
  best.work.stalled_pairs += found.stalled;
  found.time = pair.time;
  found.moving = moving;
  found.fixed = fixed;
  found.face_moving = face_moving;
  found.face_fixed = face_fixed;
  found.point = pair.point;
  found.normal = pair.normal;
  found.gap = pair.gap;
  keep_earlier(found, best);
  return decided;
}

void decide_floor_vertex(const FirstContactQuery& query, Index moving, Index vertex,
                         FirstContact& best) {
  ++best.work.face_pairs;
  const Body& body = query.moving[moving];
  const Vec3 p = body.vertex(vertex);
  const double time = first_floor_contact(p, query.motion, query.clearance);
  if (time > query.motion.limit || time > best.time) return;
  FirstContact found;
  found.status = p.z() <= 0 ? FirstContact::Status::Crossing : FirstContact::Status::Contact;
  found.time = time;
  found.moving = moving;
  found.fixed = FirstContact::kFloor;
  found.face_moving = vertex;
  // The contact is on the floor below the vertex; a vertex that is in the floor already has no gap.
  const Vec3 at = moved_point(p, query.motion, time);
  found.point = Vec3(at.x(), at.y(), 0);
  found.gap = std::max(0.0, at.z());
  keep_earlier(found, best);
}

}  // namespace trivet
