#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "core/flex/multifrontal.h"

using namespace trivet;
using namespace trivet::flex;

namespace {

// A grid of k x k vertices with random springs, and a second one without a link to it.
struct System {
  BlockMatrix matrix;
  Multifrontal::Coordinates coordinates{2};

  explicit System(int k, int copies = 1) {
    std::mt19937 random(7);
    const auto number = [&] { return random() / 4294967296.0 - 0.5; };
    matrix.reset(copies * k * k);
    for (int c = 0; c < copies; ++c)
      for (int j = 0; j < k; ++j)
        for (int i = 0; i < k; ++i) {
          const int v = (c * k + j) * k + i;
          coordinates[0].push_back(i + c * k), coordinates[1].push_back(j);
          matrix.add(v, v, Mat3::Identity() * 0.1);
          for (const int w : {i + 1 < k ? v + 1 : v, j + 1 < k ? v + k : v}) {
            if (w == v) continue;
            const Vec3 d(number(), number(), number());
            Mat3 spring;
            for (int n = 0; n < 3; ++n) spring.col(n) = d * d[n];
            matrix.add(v, v, spring), matrix.add(w, w, spring);
            matrix.add_both(v, w, -spring);
          }
        }
  }
  Eigen::MatrixXd dense() const {
    const auto n = static_cast<Eigen::Index>(matrix.num_rows());
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (const auto& block : matrix.row(i))
        out.block<3, 3>(3 * i, 3 * block.column) = block.values;
    return out;
  }
};

void expect_solved(const System& system) {
  Multifrontal factors;
  factors.analyse(system.matrix, system.coordinates);
  ASSERT_TRUE(factors.covers(system.matrix));
  ASSERT_TRUE(factors.factor(system.matrix));
  std::vector<Vec3> x;
  for (size_t i = 0; i < system.matrix.num_rows(); ++i) x.emplace_back(1, 0.1 * double(i), -2);
  const std::vector<Vec3> right = x;
  factors.solve(x);
  const Eigen::MatrixXd dense = system.dense();
  Eigen::VectorXd b(dense.rows()), y(dense.rows());
  for (size_t i = 0; i < x.size(); ++i)
    b.segment<3>(3 * Eigen::Index(i)) = right[i], y.segment<3>(3 * Eigen::Index(i)) = x[i];
  EXPECT_LT((dense * y - b).norm(), 1e-10 * b.norm());
}

TEST(Multifrontal, SolvesAsDenseMatrices) {
  for (const int k : {1, 3, 5, 9, 20}) expect_solved(System(k));
}

TEST(Multifrontal, SolvesWhatIsInTwoParts) { expect_solved(System(8, 2)); }

TEST(Multifrontal, SeesWhatIsNotPositiveDefinite) {
  System system(12);
  system.matrix.add(40, 40, Mat3::Identity() * -5);
  Multifrontal factors;
  factors.analyse(system.matrix, system.coordinates);
  EXPECT_FALSE(factors.factor(system.matrix));
}

TEST(Multifrontal, KnowsWhatItsPatternCovers) {
  System system(6);
  Multifrontal factors;
  factors.analyse(system.matrix, system.coordinates);
  system.matrix.add_both(0, 35, Mat3::Identity());
  EXPECT_FALSE(factors.covers(system.matrix));
}

TEST(Multifrontal, GivesTheSameBitsAgain) {
  const System system(20);
  std::vector<Vec3> solutions[2];
  for (auto& x : solutions) {
    Multifrontal factors;
    factors.analyse(system.matrix, system.coordinates);
    ASSERT_TRUE(factors.factor(system.matrix));
    x.assign(400, Vec3(1, 2, 3));
    factors.solve(x);
  }
  EXPECT_TRUE(solutions[0] == solutions[1]);
}

}  // namespace
