#include "ops/detect/cost_model.h"

#include <Eigen/LU>
#include <cmath>

#include "core/candidates/zlist_frame.h"

namespace trivet {
namespace {

constexpr int kMostTerms = 3;
using Terms = Eigen::Matrix<double, 1, kMostTerms>;

double num_triangles(std::span<const Body> bodies, const std::vector<Index>& which) {
  double out = 0;
  for (const Index i : which) out += static_cast<double>(bodies[i].shape->mesh.triangles.size());
  return out;
}

Terms terms_of(const QuerySize& size, CostGrowth growth) {
  // BVHs cost about the root of the triangles: they look at a part of the surface alone.
  if (growth == CostGrowth::Root) return {1, std::sqrt(size.triangles), 0};
  return {1, size.triangles, size.pixels};
}

CostModel model_of(const Terms& terms, CostGrowth growth) {
  if (growth == CostGrowth::Root) return {terms[0], 0, terms[1], 0};
  return {terms[0], terms[1], 0, terms[2]};
}

// Sums of a least squares problem A x = 1, whose columns have length 1.
struct Normal {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();  // A^T A
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();    // A^T 1
};

// Solution with the terms of a bit mask alone; the others are 0. Not finite where terms depend on
// each other: fewer of them do as well.
Terms solve(const Normal& normal, int mask) {
  Normal used = normal;
  // A term that is left out has a row of its own: it is zero.
  for (int k = 0; k < kMostTerms; ++k) {
    if (mask >> k & 1) continue;
    used.matrix.row(k).setZero();
    used.matrix.col(k).setZero();
    used.matrix(k, k) = 1;
    used.sums[k] = 0;
  }
  return (used.matrix.inverse() * used.sums).transpose();
}

}  // namespace

QuerySize size_of(const FirstContactQuery& query) {
  const ZListFrame frame = make_zlist_frame(query, query.motion.limit, QuerySize::kPixelsAlong);
  return {query.motion.kind,
          num_triangles(query.moving, frame.moving) + num_triangles(query.fixed, frame.fixed),
          static_cast<double>(frame.width) * frame.height};
}

double CostModel::ms(const QuerySize& size) const {
  return fixed_ms + ms_per_triangle * size.triangles + ms_per_root * std::sqrt(size.triangles) +
         ms_per_pixel * size.pixels;
}

CostModel fit_cost(std::span<const CostSample> samples, CostGrowth growth) {
  // Errors are relative, so that small queries count as much as large ones.
  std::vector<Terms> rows;
  rows.reserve(samples.size());
  Terms squares = Terms::Zero();
  for (const CostSample& sample : samples) {
    rows.emplace_back(terms_of(sample.size, growth) / sample.ms);
    squares += rows.back().cwiseAbs2();
  }
  // Columns of length one keep the normal equations well conditioned.
  const Terms scale = squares.cwiseSqrt().cwiseMax(1e-300);
  Normal normal;
  for (Terms& row : rows) {
    row = row.cwiseQuotient(scale);
    normal.matrix += row.transpose() * row;
    normal.sums += row.transpose();
  }
  // The best of all subsets whose solution has no negative term: there are only seven.
  Terms best = Terms::Zero();
  double best_error = kInfinity;
  for (int mask = 1; mask < 1 << kMostTerms; ++mask) {
    const Terms terms = solve(normal, mask);
    double error = 0;
    for (const Terms& row : rows) error += std::pow(row.dot(terms) - 1, 2);
    if (terms.minCoeff() < 0 || !(error < best_error)) continue;
    best = terms;
    best_error = error;
  }
  return model_of(best.cwiseQuotient(scale), growth);
}

}  // namespace trivet
