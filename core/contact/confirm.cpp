#include "core/contact/confirm.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/contact/motion_boxes.h"
#include "core/contact/pair_numbers.h"
#include "core/index/box_pairs.h"

namespace trivet {
namespace {

/// Embree may report this many times the pairs that were proposed; more are not worth sorting out.
constexpr size_t kMostReported = 4;

/// The distinct faces of one side.
class Faces {
 public:
  explicit Faces(size_t most) : m_numbers(most) {}

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

}  // namespace

bool confirm_pairs(const FirstContactQuery& query, double horizon, std::vector<FacePair>& pairs) {
  Faces moving(pairs.size()), fixed(pairs.size());
  PairNumbers numbers(pairs.size());
  for (Index i = 0; i < static_cast<Index>(pairs.size()); ++i) {
    const FacePair& p = pairs[i];
    numbers.find_or_add(moving.number(p.moving, p.face_moving), fixed.number(p.fixed, p.face_fixed),
                        i);
  }
  const MotionBoxes along(query, horizon);
  const Boxes a = moving_boxes(along, query.moving, moving);
  Aabb extent;
  for (const Aabb& box : a.boxes) extent.extend(box);
  const Boxes b = fixed_boxes(along, query.fixed, fixed, extent);
  std::optional<std::vector<BoxPair>> reported;
  try {
    reported = overlapping_boxes(a.boxes, b.boxes, kMostReported * pairs.size());
  } catch (const Error&) {  // no memory for Embree: the closed form decides alone
  }
  if (!reported) return false;
  std::vector<char> confirmed(pairs.size());
  for (const BoxPair& p : *reported) {
    const Index pair = numbers.find(a.faces[p.a], b.faces[p.b]);
    if (pair >= 0) confirmed[pair] = 1;
  }
  size_t next = 0;
  std::erase_if(pairs, [&](const FacePair&) { return !confirmed[next++]; });
  return true;
}

}  // namespace trivet
