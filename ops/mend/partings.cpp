#include "ops/mend/partings.h"

#include <algorithm>
#include <cmath>

#include "ops/arrange/angles.h"
#include "ops/arrange/convex_region.h"

namespace trivet {
namespace {

constexpr int kMostSweeps = 4000, kPlainSweeps = 100;
constexpr double kStill = 1e-8;       // metres: smaller changes end it
constexpr double kOverRelaxed = 1.9;  // makes long rows converge in some sweeps a pair
constexpr double kCompliance = 1e-7;  // bounds multipliers of partings that cannot be met

/// Each parting as a push on its two.
template <class Way>
class Relaxation {
 public:
  Relaxation(const std::vector<PartingAlong<Way>>& partings, size_t num)
      : m_partings(partings), m_pushes(partings.size(), 0), m_shifts(num, Way::Zero()) {}

  std::vector<Way> run() {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep)
      if (sweep_once(kOverRelaxed) < kStill) return std::move(m_shifts);
    // Partings that contradict each other overshoot by then.
    for (int sweep = 0; sweep < kPlainSweeps; ++sweep) sweep_once(1);
    return std::move(m_shifts);
  }

 private:
  double sweep_once(double relaxed) {
    double most = 0;
    for (size_t c = 0; c < m_partings.size(); ++c) {
      const PartingAlong<Way>& p = m_partings[c];
      const Way between = p.b ? Way(m_shifts[p.a] - m_shifts[*p.b]) : m_shifts[p.a];
      const double lacks = p.least - p.way.dot(between) - kCompliance * m_pushes[c];
      // A push never pulls: what is farther apart than it must be stays there.
      const double wanted = m_pushes[c] + relaxed * lacks / ((p.b ? 2 : 1) + kCompliance);
      const double change = std::max(0.0, wanted) - m_pushes[c];
      m_pushes[c] += change;
      m_shifts[p.a] += change * p.way;
      if (p.b) m_shifts[*p.b] -= change * p.way;
      most = std::max(most, std::abs(change));
    }
    return most;
  }

  const std::vector<PartingAlong<Way>>& m_partings;
  std::vector<double> m_pushes;  // multipliers, metres
  std::vector<Way> m_shifts;
};

// `a` along the outward normals of `b`.
void try_normals(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double sign,
                 WayApart& best) {
  for (size_t i = 0; i < b.size(); ++i) {
    const Vec2 edge = b[(i + 1) % b.size()] - b[i];
    if (edge.norm() == 0) continue;
    const Vec2 out = -quarter_turned(Vec2(edge.normalized()));
    const double metres = extent(b, out) + extent(a, -out);
    if (metres < best.metres) best = {sign * out, metres};
  }
}

}  // namespace

template <class Way>
std::vector<Way> least_shifts(const std::vector<PartingAlong<Way>>& partings, size_t num) {
  return Relaxation<Way>(partings, num).run();
}
template std::vector<Vec2> least_shifts(const std::vector<Parting>&, size_t);
template std::vector<Vec3> least_shifts(const std::vector<Parting3>&, size_t);

WayApart way_apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  WayApart out{Vec2::Zero(), kInfinity};
  try_normals(a, b, 1, out);
  try_normals(b, a, -1, out);
  return out;
}

}  // namespace trivet
