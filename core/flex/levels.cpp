#include "core/flex/levels.h"

#include <algorithm>
#include <cmath>

namespace trivet::flex {
namespace {

constexpr int kCoarseCells = 16, kCoarseSegments = 32;  // of the coarsest level, at least
constexpr int kMostLevels = 4;
constexpr double kSoft = 20;        // weights of a strip: tension of the coarsest level
constexpr double kSoftShear = 0.2;  // of that, shear
constexpr double kBendCells = 0.7;  // bending length of coarser levels, at least
constexpr double kCoarseTolerance = 0.02;

bool can_halve(const DrapeProblem& p) {
  // Loads belong to single vertices, which a coarser level may lack.
  if (!p.loads.empty()) return false;
  if (!p.grid) return p.num_segments % 2 == 0 && p.num_segments / 2 >= kCoarseSegments;
  return p.grid->num_u % 2 == 0 && p.grid->num_v % 2 == 0 &&
         std::max(p.grid->num_u, p.grid->num_v) / 2 >= kCoarseCells &&
         std::min(p.grid->num_u, p.grid->num_v) / 2 >= 2;
}

bool keeps_pins(const DrapeProblem& p) {
  // Pins have to lie on vertices that the coarser level keeps.
  for (size_t v = 0; v < p.pinned.size(); ++v) {
    if (!p.pinned[v]) continue;
    const int row = p.grid ? p.grid->num_u + 1 : static_cast<int>(p.pinned.size());
    const int i = static_cast<int>(v) % row, j = static_cast<int>(v) / row;
    if (i % 2 != 0 || j % 2 != 0) return false;
  }
  return true;
}

// A root of order `n` of x in (0, 1], by halving: no libm.
double root(double x, int n) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    double power = 1;
    for (int k = 0; k < n; ++k) power *= middle;
    (power < x ? low : high) = middle;
  }
  return high;
}

void soften(FlexMaterial& m, const Grid& grid, int above, int levels) {
  // A strip of the sheet hangs by its own weight: tension of some weights is stiff enough for a
  // coarse level.
  const double soft = kSoft * m.density * kGravity * std::max(grid.length_u, grid.length_v);
  if (levels < 2 || above == 0 || soft >= m.stretch) return;
  // From level to level the stiffness grows by one factor, up to the material's own.
  const double step = root(soft / m.stretch, levels - 1);
  double factor = 1;
  for (int i = 0; i < above; ++i) factor *= step;
  m.stretch *= factor;
  m.coupling *= factor;
  m.shear = std::max(m.shear * factor, std::min(m.shear, kSoftShear * soft));
}

}  // namespace

int num_levels(const DrapeProblem& problem, const DrapeOptions& options) {
  const int most = options.levels > 0 ? options.levels : kMostLevels;
  DrapeProblem level = problem;
  int levels = 1;
  while (levels < most && can_halve(level) && keeps_pins(level)) {
    level = coarser(level);
    ++levels;
  }
  return levels;
}

DrapeProblem coarser(const DrapeProblem& fine) {
  DrapeProblem out = fine;
  // Every second vertex stays, in each direction, at its place and with its pin.
  out.start.clear();
  out.pinned.clear();
  const auto keep = [&](int v) {
    out.start.push_back(fine.start[v]);
    out.pinned.push_back(fine.pinned[v]);
  };
  if (fine.grid) {
    out.grid->num_u /= 2, out.grid->num_v /= 2;
    for (int j = 0; j <= out.grid->num_v; ++j)
      for (int i = 0; i <= out.grid->num_u; ++i) keep(fine.grid->vertex(2 * i, 2 * j));
  } else {
    out.num_segments /= 2;
    for (int i = 0; i <= out.num_segments; ++i) keep(2 * i);
  }
  return out;
}

// The middle of a cell is that of its diagonal, which goes the one way or the other.
Points refined(const DrapeProblem& coarse, const Points& x) {
  Points out;
  const auto middle = [](const Vec3& a, const Vec3& b) { return Vec3(0.5 * (a + b)); };
  if (!coarse.grid) {
    for (size_t i = 0; i + 1 < x.size(); ++i) {
      out.push_back(x[i]);
      out.push_back(middle(x[i], x[i + 1]));
    }
    out.push_back(x.back());
    return out;
  }
  const Grid& grid = *coarse.grid;
  const auto at = [&](int i, int j) -> const Vec3& { return x[grid.vertex(i, j)]; };
  for (int j = 0; j <= 2 * grid.num_v; ++j)
    for (int i = 0; i <= 2 * grid.num_u; ++i) {
      // Even places are old vertices; odd ones are the middle of an edge, or of the cell's
      // diagonal.
      const int a = i / 2, b = j / 2, c = (i + 1) / 2, d = (j + 1) / 2;
      const bool rises = (a + b) % 2 == 0;
      out.push_back(rises ? middle(at(a, b), at(c, d)) : middle(at(c, b), at(a, d)));
    }
  return out;
}

LevelSettings level_settings(const DrapeProblem& level, const DrapeOptions& options, int above,
                             int levels) {
  // The layer doubles from level to level.
  LevelSettings out{level.material, options.layer, options.minimiser.tolerance};
  for (int i = 0; i < above; ++i) out.layer *= 2;
  if (above == 0) return out;
  out.tolerance = std::max(kCoarseTolerance, 10 * out.tolerance);
  if (!level.grid) return out;
  soften(out.material, *level.grid, above, levels);
  const double cell =
      std::min(level.grid->length_u / level.grid->num_u, level.grid->length_v / level.grid->num_v);
  // A coarse sheet may not bend within a cell: its bending length is most of one.
  const double reach = kBendCells * cell;
  out.material.bending =
      std::max(out.material.bending, level.material.density * kGravity * reach * reach * reach);
  return out;
}

}  // namespace trivet::flex
