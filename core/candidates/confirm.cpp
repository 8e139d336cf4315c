#include "core/candidates/confirm.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/contact/motion_boxes.h"
#include "core/contact/pair_numbers.h"
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

/// Indices of pairs, grouped by their moving face.
struct Groups {
  std::vector<Index> begin, pairs;  // begin: one more than there are faces
};

Groups grouped(std::span<const NumberedPair> pairs, size_t num_moving) {
  Groups out;
  out.begin.resize(num_moving + 1);
  out.pairs.resize(pairs.size());
  for (const NumberedPair& p : pairs) ++out.begin[p.moving];
  std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
  for (size_t i = pairs.size(); i-- > 0;)
    out.pairs[--out.begin[pairs[i].moving]] = static_cast<Index>(i);
  return out;
}

/// True if each of `asked` is among `reported`.
std::vector<char> found_among(std::span<const NumberedPair> asked,
                              std::span<const NumberedPair> reported, size_t num_moving,
                              size_t num_fixed) {
  std::vector<char> out(asked.size());
  const Groups questions = grouped(asked, num_moving), answers = grouped(reported, num_moving);
  std::vector<Index> met_by(num_fixed, -1);  // the last moving face that meets the fixed one
  for (Index m = 0; m < static_cast<Index>(num_moving); ++m) {
    for (Index i = answers.begin[m]; i < answers.begin[m + 1]; ++i)
      met_by[reported[answers.pairs[i]].fixed] = m;
    for (Index i = questions.begin[m]; i < questions.begin[m + 1]; ++i)
      out[questions.pairs[i]] = met_by[asked[questions.pairs[i]].fixed] == m;
  }
  return out;
}

}  // namespace

bool confirm_pairs(const FirstContactQuery& query, double horizon, std::vector<FacePair>& pairs) {
  Faces moving, fixed;
  std::vector<NumberedPair> asked;
  asked.reserve(pairs.size());
  for (const FacePair& p : pairs)
    asked.push_back({moving.number(p.moving, p.face_moving), fixed.number(p.fixed, p.face_fixed)});
  const MotionBoxes along(query, horizon);
  const Boxes a = moving_boxes(along, query.moving, moving);
  Aabb extent;
  for (const Aabb& box : a.boxes) extent.extend(box);
  const Boxes b = fixed_boxes(along, query.fixed, fixed, extent);
  std::optional<std::vector<BoxPair>> overlapping;
  try {
    overlapping = overlapping_boxes(a.boxes, b.boxes, kMostReported * pairs.size());
  } catch (const Error&) {  // no memory for Embree: the closed form decides alone
  }
  if (!overlapping) return false;
  std::vector<NumberedPair> reported;
  reported.reserve(overlapping->size());
  for (const BoxPair& p : *overlapping) reported.push_back({a.faces[p.a], b.faces[p.b]});
  const std::vector<char> confirmed =
      found_among(asked, reported, moving.all().size(), fixed.all().size());
  size_t next = 0;
  std::erase_if(pairs, [&](const FacePair&) { return !confirmed[next++]; });
  return true;
}

}  // namespace trivet
