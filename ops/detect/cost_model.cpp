#include "ops/detect/cost_model.h"

#include <Eigen/Dense>
#include <cmath>

#include "core/contact/zlist_frame.h"

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
  if (growth == CostGrowth::Root) return {1, std::sqrt(size.triangles), 0};
  return {1, size.triangles, size.pixels};
}

CostModel model_of(const Terms& terms, CostGrowth growth) {
  if (growth == CostGrowth::Root) return {terms[0], 0, terms[1], 0};
  return {terms[0], terms[1], 0, terms[2]};
}

// Least squares with the terms of a bit mask alone; the others are 0.
Terms solve(const Eigen::MatrixXd& rows, const Eigen::VectorXd& values, int mask) {
  Eigen::MatrixXd used = rows;
  for (int k = 0; k < kMostTerms; ++k)
    if (!(mask >> k & 1)) used.col(k).setZero();
  return used.completeOrthogonalDecomposition().solve(values).transpose();
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
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd rows(count, kMostTerms);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(count);
  for (Eigen::Index i = 0; i < count; ++i)
    rows.row(i) = terms_of(samples[i].size, growth) / samples[i].ms;
  const Eigen::RowVector3d scale = rows.colwise().norm().cwiseMax(1e-300);
  rows.array().rowwise() /= scale.array();
  // The best of all subsets whose solution has no negative term: there are only seven.
  Terms best = Terms::Zero();
  double best_error = kInfinity;
  for (int mask = 1; mask < 1 << kMostTerms; ++mask) {
    const Terms terms = solve(rows, ones, mask);
    const double error = (rows * terms.transpose() - ones).norm();
    if (terms.minCoeff() < 0 || error >= best_error) continue;
    best = terms;
    best_error = error;
  }
  return model_of(best.cwiseQuotient(scale), growth);
}

}  // namespace trivet
