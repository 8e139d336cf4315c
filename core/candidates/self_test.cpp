#include "core/candidates/self_test.h"

#include <algorithm>
#include <memory>

namespace trivet {
namespace {

constexpr int kNumQueries = 32;
constexpr int kNumFaces = 24;  // of a mesh

/// The same numbers everywhere, in [-1, 1).
class Numbers {
 public:
  double next() {
    // Integers overflow alike on every machine, so that a failing query can be named by its number.
    m_state = m_state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(static_cast<std::int32_t>(m_state >> 32)) * 0x1p-31;
  }
  Vec3 point() {
    const double x = next(), y = next();
    return {x, y, next()};
  }
  Rotation rotation() {
    const Vec3 v = point();
    return Rotation{1.5 + next(), v.x(), v.y(), v.z()}.normalized();
  }

 private:
  std::uint64_t m_state = 1;
};

/// Faces large, small and thin.
std::shared_ptr<const Shape> make_faces(Numbers& numbers) {
  std::vector<Triangle> faces;
  for (int i = 0; i < kNumFaces; ++i) {
    const Vec3 p = numbers.point(), u = numbers.point(), v = numbers.point();
    // Every third face is a sliver and every fourth is small: a finder that loses thin faces or
    // those below a pixel is found out.
    const double wide = i % 3 == 0 ? 1e-3 : 1, size = i % 4 == 0 ? 0.05 : 0.7;
    faces.push_back({p, p + size * u, p + size * (0.5 * u + wide * v)});
  }
  return make_shape(weld(faces));
}

Motion make_motion(int number, const Vec3& place, Numbers& numbers) {
  // Falls aim roughly at the fixed mesh; axes of turns pass near the moving one.
  if (number % 2 == 0)
    return Motion::translation((0.3 * numbers.point() - place.normalized()).normalized(), 4);
  const Vec3 axis = (numbers.point() + 0.1 * Vec3::UnitX()).normalized();
  return Motion::rotation(place + 1.5 * numbers.point(), axis, 1);
}

bool contains(const CandidatePairs& proposal, const FirstContact& truth) {
  return std::any_of(proposal.pairs.begin(), proposal.pairs.end(), [&](const FacePair& p) {
    return p.face_moving == truth.face_moving && p.face_fixed == truth.face_fixed &&
           p.not_before <= truth.time;
  });
}

std::string wrong(const CandidatePairs& proposal, const FirstContact& truth) {
  // The bounds have to enclose the true time even where no contact exists.
  const double time = truth.status == FirstContact::Status::Free ? kInfinity : truth.time;
  if (!proposal.usable) return "no proposal: " + proposal.why;
  if (proposal.upper < time) return "the upper bound is too early";
  if (time == kInfinity) return "";
  if (proposal.lower > time) return "the lower bound is too late";
  return contains(proposal, truth) ? "" : "the first pair is missing";
}

}  // namespace

std::string self_test(CandidateFinder& stage) {
  Numbers numbers;
  // One moving and one fixed mesh are enough: the poses and motions make the queries differ.
  const std::shared_ptr<const Shape> shapes[] = {make_faces(numbers), make_faces(numbers)};
  for (int i = 0; i < kNumQueries; ++i) {
    const Vec3 place = 1.2 * numbers.point() + 1.8 * Vec3::UnitZ();
    const Pose pose{numbers.rotation(), place};
    const Body moving(*shapes[0], world_from_object(pose, UpAxis::Z, 1)),
        fixed(*shapes[1], Affine());
    FirstContactQuery query{{&moving, 1}, {&fixed, 1}, false, {}, {1e-6}};
    // The motion goes in last: its direction depends on where the moving mesh was put.
    query.motion = make_motion(i, place, numbers);
    const std::string what =
        wrong(stage.find_candidates(query, query.motion.limit), first_contact(query));
    if (!what.empty()) return "query " + std::to_string(i) + ": " + what;
  }
  return "";
}

}  // namespace trivet
