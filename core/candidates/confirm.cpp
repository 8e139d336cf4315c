#include "core/candidates/confirm.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/candidates/pair_numbers.h"
#include "core/contact/decide.h"
#include "core/contact/motion_boxes.h"
#include "core/index/box_pairs.h"

namespace trivet {
namespace {

/// Embree may report this many times the pairs that were proposed; more are not worth sorting out.
constexpr size_t kMostReported = 4;

/// The distinct faces of one side. Its table grows with them: they are far fewer than long
/// proposals have pairs, and stay in the caches.
class Faces {
 public:
  Index number(Index body, Index face) {
    const auto next = static_cast<Index>(m_faces.size());
    const Index found = m_numbers.find_or_add(body, face, next);
    if (found == next) m_faces.push_back({body, face});
    return found;
  }
  struct Face {
    Index body, face;
  };
  const std::vector<Face>& all() const { return m_faces; }

 private:
  PairNumbers m_numbers;
  std::vector<Face> m_faces;
};

/// A pair of distinct faces, by their numbers.
struct NumberedPair {
  Index moving, fixed;
};

/// Boxes, and whose they are.
struct Boxes {
  std::vector<Aabb> boxes;
  std::vector<Index> faces;
};

Boxes moving_boxes(const MotionBoxes& along, std::span<const Body> bodies, const Faces& faces) {
  Boxes out;
  for (const Faces::Face& f : faces.all()) {
    out.faces.push_back(static_cast<Index>(out.faces.size()));
    out.boxes.push_back(along.moving(bodies[f.body].triangle(f.face)));
  }
  return out;
}

/// Within `extent`; a turn's also one period earlier and later.
Boxes fixed_boxes(const MotionBoxes& along, std::span<const Body> bodies, const Faces& faces,
                  const Aabb& extent) {
  Boxes out;
  const int most = along.period() > 0 ? 1 : 0;
  for (Index i = 0; i < static_cast<Index>(faces.all().size()); ++i) {
    // A turn's third coordinate closes after one period: a box that is cut there has to be met as
    // one of its copies, too.
    const Faces::Face& f = faces.all()[i];
    const Aabb box = along.fixed(bodies[f.body].triangle(f.face));
    for (int turn = -most; turn <= most; ++turn) {
      const Vec3 shift(0, 0, turn * along.period());
      const Aabb shifted{box.lower + shift, box.upper + shift};
      if (!overlaps(shifted, extent)) continue;
      out.faces.push_back(i);
      out.boxes.push_back(shifted);
    }
  }
  return out;
}

/// Proposed pairs by their faces' numbers.
class Proposed {
 public:
  Proposed(std::vector<NumberedPair> pairs, size_t num_moving) : m_pairs(std::move(pairs)) {
    // A counting sort groups the pairs by moving face; within a group they are ordered by the fixed
    // face, so that a search can halve.
    m_begin.resize(num_moving + 1);
    m_order.resize(m_pairs.size());
    for (const NumberedPair& p : m_pairs) ++m_begin[p.moving];
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    for (size_t i = m_pairs.size(); i-- > 0;)
      m_order[--m_begin[m_pairs[i].moving]] = static_cast<Index>(i);
    for (size_t m = 0; m < num_moving; ++m)
      std::sort(at(m_begin[m]), at(m_begin[m + 1]),
                [&](Index a, Index b) { return m_pairs[a].fixed < m_pairs[b].fixed; });
  }

  /// Index of the pair; nothing: it was not proposed.
  std::optional<Index> find(Index moving, Index fixed) const {
    const auto end = m_order.begin() + m_begin[moving + 1];
    const auto found =
        std::lower_bound(m_order.begin() + m_begin[moving], end, fixed,
                         [&](Index i, Index value) { return m_pairs[i].fixed < value; });
    if (found == end || m_pairs[*found].fixed != fixed) return std::nullopt;
    return *found;
  }

 private:
  std::vector<Index>::iterator at(Index place) { return m_order.begin() + place; }

  std::vector<NumberedPair> m_pairs;
  std::vector<Index> m_begin, m_order;  // begin: of each moving face's, one more than there are
};

void decide(const FirstContactQuery& query, const FacePair& p, FirstContact& best) {
  // A pair that cannot be first is not worth its closed form: the best contact grows earlier while
  // Embree still visits.
  if (p.not_before > std::min(best.time, query.motion.limit)) return;
  decide_faces(query, p.moving, p.fixed, p.face_moving, p.face_fixed,
               query.moving[p.moving].triangle(p.face_moving),
               query.fixed[p.fixed].triangle(p.face_fixed), best);
}

}  // namespace

bool decide_by_embree(const FirstContactQuery& query, double horizon, std::vector<FacePair>& pairs,
                      FirstContact& best) {
  // Faces that occur in many pairs get one box each, and pairs are told apart by the faces'
  // numbers.
  Faces moving, fixed;
  std::vector<NumberedPair> numbered;
  numbered.reserve(pairs.size());
  for (const FacePair& p : pairs)
    numbered.push_back(
        {moving.number(p.moving, p.face_moving), fixed.number(p.fixed, p.face_fixed)});
  const Proposed proposed(std::move(numbered), moving.all().size());
  // The boxes reach as far as the horizon alone: pairs whose boxes do not overlap cannot be first.
  const MotionBoxes along(query, horizon);
  const Boxes a = moving_boxes(along, query.moving, moving);
  Aabb extent;
  for (const Aabb& box : a.boxes) extent.extend(box);
  const Boxes b = fixed_boxes(along, query.fixed, fixed, extent);
  // Embree reports in an order of its own, which may change from run to run; the smallest contact
  // wins in any order.
  std::vector<char> visited(pairs.size());
  const auto visit = [&](const BoxPair& met) {
    const auto i = proposed.find(a.faces[met.a], b.faces[met.b]);
    if (!i || std::exchange(visited[*i], true)) return;  // a turn may meet a box twice
    decide(query, pairs[*i], best);
  };
  try {
    if (!visit_overlapping_boxes(a.boxes, b.boxes, kMostReported * pairs.size(), visit))
      return false;
  } catch (const Error&) {  // no memory for Embree: the closed form decides alone
    return false;
  }
  // The caller gets the pairs that were decided, in the order in which they were proposed.
  size_t next = 0;
  std::erase_if(pairs, [&](const FacePair&) { return !visited[next++]; });
  return true;
}

}  // namespace trivet
