#include "core/contact/first_contact.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <tuple>
#include <utility>

#include "core/contact/floor_traversal.h"
#include "core/contact/pair_traversal.h"

namespace trivet {
namespace {

/// Parts of a motion in which contacts are looked for, the nearest first: boxes that are proved
/// apart for a short part would not be for the whole. What may come later waits.
constexpr double kFirstPart = 1.0 / 256;
constexpr double kNextPart = 4;
constexpr double kLeastPart = 16;  // clearances that something moves in the first part

/// All moving against all fixed bodies and the floor.
class Search {
 public:
  explicit Search(const FirstContactQuery& query)
      : m_query(query), m_planes(query.planes ? *query.planes : m_own_planes.emplace()) {
    for (Index m = 0; m < static_cast<Index>(query.moving.size()); ++m) {
      if (!query.moving[m].shape->has_faces()) continue;
      if (query.floor) m_floors.emplace_back(query, m, m_best);
      for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f)
        if (query.fixed[f].shape->has_faces()) add_pair(m, f);
    }
    // Pairs that may touch first are searched first: what they find bounds the others.
    std::sort(m_order.begin(), m_order.end(), [&](Index a, Index b) {
      return std::make_tuple(m_pairs[a].apart_until(), a) <
             std::make_tuple(m_pairs[b].apart_until(), b);
    });
  }

  FirstContact run() {
    const double limit = m_query.motion.limit;
    // The motion is searched in growing parts; a contact in one part ends the search.
    for (double until = first_part();; until *= kNextPart) {
      until = std::min(until, limit);
      for (FloorTraversal& floor : m_floors) floor.search(until);
      for (const Index pair : m_order) {
        // All later pairs in the order are apart for longer still.
        if (m_pairs[pair].apart_until() > std::min(until, m_best.time)) break;
        m_pairs[pair].search(until);
      }
      if (!(until < limit) || m_best.time <= until) return m_best;
    }
  }

 private:
  void add_pair(Index moving, Index fixed) {
    PairTraversal pair(m_query, moving, fixed, m_memory, m_planes, m_best);
    if (pair.apart_until() > m_query.motion.limit) return;
    m_order.push_back(static_cast<Index>(m_pairs.size()));
    m_pairs.push_back(std::move(pair));
  }

  // End of the first part: kFirstPart of the motion, longer where nothing moves kLeastPart
  // clearances in it.
  double first_part() const {
    // A point's speed in terms of s is at most twice its distance from the axis; a translation's is
    // one.
    const Motion& motion = m_query.motion;
    double speed = 1;
    if (motion.kind == Motion::Kind::Rotation) {
      speed = 0;
      for (const Body& body : m_query.moving)
        if (body.shape->has_faces()) {
          const Aabb& box = body.world_box;
          speed = std::max(
              speed, 2 * ((box.centre() - motion.centre).cwiseAbs() + box.half_extent()).norm());
        }
    }
    // A part in which nothing moves farther than the clearance could not tell pairs apart.
    double part = kFirstPart * motion.limit;
    while (part < motion.limit && part * speed < kLeastPart * m_query.clearance.distance)
      part = std::max(part * kNextPart, 1e-300);
    return part;
  }

  const FirstContactQuery& m_query;
  FirstContact m_best;
  std::vector<FloorTraversal> m_floors;
  std::optional<SeparatingPlanes> m_own_planes;  // later parts of the motion meet faces again
  SeparatingPlanes& m_planes;
  TraversalMemory& m_memory = memory_of_thread<TraversalMemory>();
  std::vector<PairTraversal> m_pairs;
  std::vector<Index> m_order;  // nearest first
};

}  // namespace

FirstContact first_contact(const FirstContactQuery& query) {
  assert(query.motion.limit >= 0);
  // box_until() holds for a quarter turn at most.
  assert(query.motion.kind == Motion::Kind::Translation || query.motion.limit <= 1);
  return Search(query).run();
}

FirstContact first_contact_brute_force(const FirstContactQuery& query) {
  // Every pair of faces is asked by the same decision as in the search, with no box and no order:
  // what tests compare the search with.
  FirstContact best;
  for (Index m = 0; m < static_cast<Index>(query.moving.size()); ++m) {
    const Mesh& mesh = query.moving[m].shape->mesh;
    if (query.floor)
      for (Index v = 0; v < static_cast<Index>(mesh.vertices.size()); ++v)
        decide_floor_vertex(query, m, v, best);
    for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f)
      for (Index i = 0; i < static_cast<Index>(mesh.triangles.size()); ++i)
        for (Index j = 0; j < static_cast<Index>(query.fixed[f].shape->mesh.triangles.size()); ++j)
          decide_faces(query, m, f, i, j, query.moving[m].triangle(i), query.fixed[f].triangle(j),
                       best);
  }
  return best;
}

}  // namespace trivet
