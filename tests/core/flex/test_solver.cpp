#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "core/flex/dense_front.h"
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

// Symmetric and positive definite, by columns; garbage above the diagonal.
std::vector<double> definite(int size) {
  std::mt19937 random(size);
  std::vector<double> out(static_cast<size_t>(size) * size);
  for (double& value : out) value = random() / 4294967296.0 - 0.5;
  for (int i = 0; i < size; ++i) out[static_cast<size_t>(i) * (size + 1)] = size;
  return out;
}

std::vector<double> lower_of(const std::vector<double>& a, int size) {
  std::vector<double> out;
  for (int j = 0; j < size; ++j)
    for (int i = j; i < size; ++i) out.push_back(a[static_cast<size_t>(j) * size + i]);
  return out;
}

// A loop for each column, in the order of the sums.
std::vector<double> factored_slowly(std::vector<double> a, int size, int num_own) {
  const auto at = [&](int i, int j) -> double& { return a[static_cast<size_t>(j) * size + i]; };
  for (int first = 0; first < num_own; first += kPanel) {
    const int end = std::min(num_own, first + kPanel);
    for (int j = first; j < end; ++j) {
      for (int k = first; k < j; ++k)
        for (int i = j; i < size; ++i) at(i, j) -= at(j, k) * at(i, k);
      at(j, j) = std::sqrt(at(j, j));
      const double inverse = 1 / at(j, j);
      for (int i = j + 1; i < size; ++i) at(i, j) *= inverse;
    }
    for (int j = end; j < size; ++j)
      for (int i = j; i < size; ++i) {
        double sum = 0;
        for (int k = first; k < end; ++k) sum += at(j, k) * at(i, k);
        at(i, j) -= sum;
      }
  }
  return lower_of(a, size);
}

TEST(DenseFront, HasTheSameBitsInRegistersOfEveryWidth) {
  EXPECT_GE(usable_kernels().size(), 1u);
  const std::pair<int, int> sizes[] = {{1, 1},   {3, 3},    {7, 2},     {16, 16},  {17, 5},
                                       {50, 49}, {96, 96},  {97, 48},   {131, 60}, {203, 203},
                                       {450, 9}, {501, 99}, {640, 480}, {333, 150}};
  for (const auto& [size, num_own] : sizes) {
    const std::vector<double> a = definite(size);
    const std::vector<double> expected = factored_slowly(a, size, num_own);
    for (const DenseKernels* const kernels : usable_kernels()) {
      std::vector<double> b = a;
      ASSERT_TRUE(factor_front(b.data(), size, num_own, *kernels));
      EXPECT_EQ(lower_of(b, size), expected) << size << ", " << kernels->rows << " rows";
    }
  }
}

TEST(DenseFront, SeesWhatIsNotPositiveDefinite) {
  for (const DenseKernels* const kernels : usable_kernels())
    for (const int bad : {0, 30, 70}) {
      std::vector<double> a = definite(90);
      a[static_cast<size_t>(bad) * 91] = -100;
      EXPECT_FALSE(factor_front(a.data(), 90, 80, *kernels)) << bad;
    }
}

TEST(DenseFront, SolvesWithTheSameBitsInRegistersOfEveryWidth) {
  for (const int size : {1, 7, 8, 17, 100, 203}) {
    const int num_own = (size + 2) / 3;
    std::vector<double> a = definite(size), first;
    ASSERT_TRUE(factor_front(a.data(), size, num_own));
    for (const DenseKernels* const kernels : usable_kernels()) {
      std::vector<double> x(size);
      for (int i = 0; i < size; ++i) x[i] = 1 + 0.3 * i;
      solve_forward(a.data(), size, num_own, x.data(), *kernels);
      solve_backward(a.data(), size, num_own, x.data(), *kernels);
      if (first.empty()) first = x;
      EXPECT_EQ(x, first) << size << ", " << kernels->rows << " rows";
    }
  }
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
