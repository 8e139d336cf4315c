// Gradients and second derivatives beside differences of the energy.
#include <gtest/gtest.h>

#include <random>

#include "core/flex/elasticity.h"
#include "core/flex/model.h"
#include "tests/core/flex/stage.h"

namespace trivet::test {
namespace {

constexpr double kStep = 1e-6;  // of coordinates, metres

using EnergyAt = std::function<double(const Points&, Total&)>;

struct Derivatives {
  Points gradient;
  BlockMatrix hessian;

  Derivatives(const EnergyAt& energy, const Points& x) {
    gradient.assign(x.size(), Vec3::Zero());
    hessian.reset(x.size());
    Total total{&gradient, &hessian, Curvature::Exact};
    energy(x, total);
  }
};

// Largest differences, relative to the largest entries.
void expect_true(const EnergyAt& energy, const Points& x, double step, double tolerance) {
  Derivatives here(energy, x);
  double largest = 0, largest_second = 0, error = 0, second_error = 0;
  for (size_t v = 0; v < x.size(); ++v)
    for (int k = 0; k < 3; ++k) {
      Points up = x, down = x;
      up[v][k] += step, down[v][k] -= step;
      Total none;
      const double slope = (energy(up, none) - energy(down, none)) / (2 * step);
      largest = std::max(largest, std::abs(here.gradient[v][k]));
      error = std::max(error, std::abs(slope - here.gradient[v][k]));
      const Derivatives above(energy, up), below(energy, down);
      for (size_t w = 0; w < x.size(); ++w) {
        const Vec3 difference = (above.gradient[w] - below.gradient[w]) / (2 * step);
        const Mat3* block = here.hessian.find(static_cast<int>(w), static_cast<int>(v));
        const Vec3 column = block ? Vec3(block->col(k)) : Vec3(Vec3::Zero());
        largest_second = std::max(largest_second, column.cwiseAbs().maxCoeff());
        second_error = std::max(second_error, (difference - column).cwiseAbs().maxCoeff());
      }
    }
  EXPECT_GT(largest, 0);
  EXPECT_LT(error, tolerance * largest);
  EXPECT_LT(second_error, 10 * tolerance * largest_second);
}

Points shaken(Points x, double by) {
  std::mt19937 random(11);
  for (Vec3& p : x)
    for (int k = 0; k < 3; ++k) p[k] += by * (random() / 2147483648.0 - 1);
  return x;
}

TEST(FlexDerivatives, OfSheets) {
  FlexMaterial material;
  material.bending = 1e-3;
  const DrapeProblem problem = sheet(3, 2, 0.3, 0.2, {0, 0, 1}, material);
  const Body body = body_of(problem);
  expect_true([&](const Points& x, Total& t) { return elastic_energy(body, x, t); },
              shaken(problem.start, 0.02), kStep, 1e-6);
}

TEST(FlexDerivatives, OfCables) {
  FlexMaterial material;
  material.stretch = 100, material.bending = 1e-3;
  const DrapeProblem problem = cable(5, 0.5, {{0, 0, 1}, {0.4, 0, 1}}, material);
  const Body body = body_of(problem);
  expect_true([&](const Points& x, Total& t) { return elastic_energy(body, x, t); },
              shaken(problem.start, 0.02), kStep, 1e-6);
}

TEST(FlexDerivatives, OfMeshes) {
  const DrapeProblem flat = sheet(3, 2, 0.3, 0.2, {0, 0, 1});
  FlexMaterial material;
  material.bending = 1e-2;
  const Body body = make_mesh(flat.start, body_of(flat).faces, material);
  expect_true([&](const Points& x, Total& t) { return elastic_energy(body, x, t); },
              shaken(flat.start, 0.02), kStep, 1e-6);
}

TEST(FlexDerivatives, OfMeshesThatAreCurledAtRest) {
  const DrapeProblem flat = sheet(3, 2, 0.3, 0.2, {0, 0, 1});
  FlexMaterial material;
  material.bending = 1;  // so that it counts beside the membrane
  Points rest;
  rest.reserve(flat.start.size());
  for (const Vec3& p : flat.start)
    rest.emplace_back(std::sin(4 * p.x()) / 4, p.y(), (1 - std::cos(4 * p.x())) / 4);
  const Body body = make_mesh(rest, body_of(flat).faces, material);
  ASSERT_FALSE(body.hinges.empty());
  expect_true([&](const Points& x, Total& t) { return elastic_energy(body, x, t); },
              shaken(rest, 0.02), kStep, 1e-6);
}

bool is_mollified(const ContactPair& pair) { return pair.mollifier.value < 1; }

// All pairs of a body in its layer, contact alone.
void expect_true_contact(const DrapeProblem& problem, const Obstacles& obstacles, double layer,
                         size_t least_pairs, bool own, bool mollified = false) {
  const Body body = body_of(problem);
  Surroundings surroundings(body, obstacles);
  Contact contact(surroundings, {layer, 50});
  std::vector<ContactPair> pairs;
  ASSERT_TRUE(contact.find(problem.start, pairs));
  const auto of_kind = std::count_if(pairs.begin(), pairs.end(),
                                     [&](const ContactPair& p) { return p.pair.is_own() == own; });
  ASSERT_GE(static_cast<size_t>(of_kind), least_pairs);
  ASSERT_EQ(std::any_of(pairs.begin(), pairs.end(), is_mollified), mollified);
  expect_true(
      [&](const Points& x, Total& t) {
        std::vector<ContactPair> now;
        EXPECT_TRUE(contact.find(x, now));
        return Contact::energy(now, t);
      },
      problem.start, 1e-8, 1e-5);
}

TEST(FlexDerivatives, OfContactWithObstacles) {
  Obstacles obstacles;
  add_box(obstacles, {-0.1, -0.07, 0}, {0.05, 0.11, 0.1});
  obstacles.build();
  DrapeProblem problem = sheet(3, 3, 0.3, 0.3, {0.013, 0.007, 0.1032});
  problem.start = shaken(problem.start, 0.003);
  expect_true_contact(problem, obstacles, 0.01, 20, false);
}

// Edges of the sheet along those of the box: within the mollifier.
TEST(FlexDerivatives, OfNearlyParallelEdges) {
  Obstacles obstacles;
  add_box(obstacles, {-0.1, -0.07, 0}, {0.05, 0.11, 0.1});
  obstacles.build();
  DrapeProblem problem = sheet(3, 3, 0.3, 0.3, {0.005, 0.007, 0.1032});
  problem.start = shaken(problem.start, 1e-4);
  expect_true_contact(problem, obstacles, 0.01, 20, false, true);
}

TEST(FlexDerivatives, OfContactWithItself) {
  const Obstacles none = built({});
  DrapeProblem problem = sheet(6, 1, 0.6, 0.1, {0, 0, 1});
  for (Vec3& p : problem.start)  // folded over
    if (p.x() > 0.05) p = Vec3(0.1 - p.x() + 0.013, p.y() + 0.004, p.z() + 0.006);
  problem.start = shaken(problem.start, 0.001);
  expect_true_contact(problem, none, 0.01, 8, true, true);
}

}  // namespace
}  // namespace trivet::test
