// Open meshes that bend: flat and curled at rest.
#include <gtest/gtest.h>

#include "core/flex/elasticity.h"
#include "tests/core/flex/stage.h"

namespace trivet::test {
namespace {

// A strip of a cylinder about an axis along y: it leaves x = 0 level and rises.
// @param curl  1/m; 0: flat.
DrapeProblem curled(int cells, double length, double width, double curl,
                    const FlexMaterial& material) {
  const double l = length / cells;
  const int across = std::max(2, static_cast<int>(std::lround(width / l)));
  const DrapeProblem flat = sheet(cells, across, length, width, Vec3::Zero(), material);
  DrapeProblem out;
  out.material = material;
  out.faces = body_of(flat).faces;
  for (const Vec3& p : flat.start) {
    const double s = p.x() + length / 2, angle = curl * s;
    out.start.push_back(curl == 0
                            ? Vec3(s, p.y(), 0)
                            : Vec3(std::sin(angle) / curl, p.y(), (1 - std::cos(angle)) / curl));
  }
  out.pinned.assign(out.start.size(), false);
  return out;
}

// Without its weight.
double elastic_part(const Body& body, const Points& x, Points* forces = nullptr) {
  Points gradient(x.size(), Vec3::Zero());
  Total total{&gradient, nullptr, Curvature::Exact};
  double energy = elastic_energy(body, x, total);
  for (size_t v = 0; v < x.size(); ++v) {
    energy -= body.mass[v] * kGravity * x[v].z();
    gradient[v].z() -= body.mass[v] * kGravity;
  }
  if (forces) *forces = gradient;
  return energy;
}

FlexMaterial paper() {
  FlexMaterial out;
  out.density = 0.08, out.thickness = 1e-4, out.stretch = 3e5, out.coupling = 9e4, out.shear = 1e5;
  out.bending = 2.5e-4, out.friction = 0.3;
  return out;
}

TEST(FlexMeshes, HaveNoForcesInTheirRestShapeHoweverCurled) {
  for (const double curl : {0.0, 5.0, -20.0, 50.0}) {
    const DrapeProblem problem = curled(24, 0.06, 0.02, curl, paper());
    Points forces;
    EXPECT_NEAR(elastic_part(body_of(problem), problem.start, &forces), 0, 1e-12);
    for (const Vec3& f : forces) EXPECT_LT(f.norm(), 1e-9) << curl;
  }
}

// B curl^2 / 2 per area, from either shape to the other.
TEST(FlexMeshes, TakeTheEnergyOfAPlateToBeBent) {
  const double curl = 10, length = 0.1, width = 0.05;
  const DrapeProblem flat = curled(40, length, width, 0, paper());
  const DrapeProblem bent = curled(40, length, width, curl, paper());
  const double exact = paper().bending * curl * curl / 2 * length * width;
  // Its faces are those of the chords: their lengths differ by the squared angle.
  const double up = elastic_part(body_of(flat), bent.start);
  const double down = elastic_part(body_of(bent), flat.start);
  EXPECT_NEAR(up, exact, 0.05 * exact);
  EXPECT_NEAR(down, exact, 0.05 * exact);
}

// An elastica that is curled at rest, clamped at an angle at one end, by small steps and halving:
// B (angle' - curl) is the moment of the weight beyond. @return its free end.
Vec2 curled_elastica(double length, double curl, double clamped_angle, double weight_over_bending) {
  const int n = 2000;
  const double h = length / n;
  Vec2 end;
  const auto free_moment = [&](double start) {
    double angle = clamped_angle, slope = start;
    end = Vec2::Zero();
    const auto bend = [&](double s, double a) {
      return weight_over_bending * (length - s) * std::cos(a);
    };
    for (int i = 0; i < n; ++i) {
      const double s = i * h, middle = angle + h / 2 * slope;
      const double before = angle;
      const double half = slope + h / 2 * bend(s, angle);
      angle += h * half;
      slope += h * bend(s + h / 2, middle);
      end += h * Vec2(std::cos((before + angle) / 2), std::sin((before + angle) / 2));
    }
    return slope - curl;
  };
  double low = curl - 1000, high = curl + 1000;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (free_moment(middle) > 0 ? high : low) = middle;
  }
  return end;
}

Vec2 free_end_of_mesh(int cells, double length, double curl, const FlexMaterial& material) {
  DrapeProblem problem = curled(cells, length, length / 4, curl, material);
  for (Vec3& p : problem.start) p.z() += 1;
  for (size_t v = 0; v < problem.start.size(); ++v)
    problem.pinned[v] = problem.start[v].x() < 1.2 * length / cells;
  DrapeOptions options;
  options.layer = 1e-6;
  const DrapeResult result = drape(problem, built({}), options);
  EXPECT_EQ(result.ending, Ending::AtRest);
  EXPECT_TRUE(result.certificate.stable);
  const int middle = static_cast<int>(result.x.size()) / (cells + 1) / 2;
  const Vec3& end = result.x[(middle + 1) * (cells + 1) - 1];
  return {end.x(), end.z() - 1};
}

// Its first cell is clamped: the tangent is known in the middle of it.
Vec2 free_end(int cells, double length, double curl, const FlexMaterial& m) {
  const double half = length / cells / 2;
  const Vec2 clamp = half * Vec2(std::cos(curl * half), std::sin(curl * half));
  return clamp +
         curled_elastica(length - half, curl, curl * half, m.density * kGravity / m.bending);
}

// Two bending lengths: the strip sags to 41.49 degrees if it is flat at rest [Peirce 1930].
TEST(FlexMeshes, SagAsElasticasThatAreFlatOrCurledAtRest) {
  FlexMaterial m = paper();
  m.twist = 1, m.coupling = 0;
  const double length = 2 * std::cbrt(m.bending / (m.density * kGravity));
  for (const double curl : {0.0, 1.5 / length, -1 / length}) {
    const double coarse =
        (free_end_of_mesh(12, length, curl, m) - free_end(12, length, curl, m)).norm();
    const double fine =
        (free_end_of_mesh(24, length, curl, m) - free_end(24, length, curl, m)).norm();
    EXPECT_LT(fine, 0.005 * length) << curl;
    EXPECT_LT(fine, 0.6 * coarse) << curl;
  }
}

// Half a pipe of paper on the floor: each half is an elastica that the floor clamps at the middle.
TEST(FlexMeshes, CurledPaperRestsOnOneLine) {
  const double radius = 0.015;
  const FlexMaterial m = paper();
  // Its middle is lowest, where an odd number of cells has a level one, and its ends are up.
  DrapeProblem problem = curled(25, M_PI * radius, 0.03, 1 / radius, m);
  for (Vec3& p : problem.start) p = Vec3(p.z() - radius, p.y(), radius - p.x() + 6e-4);
  Obstacles room;
  add_box(room, {-1, -1, -0.1}, {1, 1, 0}, 0.5);
  room.build();
  const DrapeResult result = drape(problem, room, {});
  ASSERT_EQ(result.ending, Ending::AtRest);
  EXPECT_TRUE(result.certificate.stable);
  const Vec2 end =
      curled_elastica(M_PI / 2 * radius, 1 / radius, 0, m.density * kGravity / m.bending);
  EXPECT_GT(end.x(), 1.003 * radius);  // its weight opens it
  double lowest = kInfinity, highest = 0, left = 0, right = 0;
  for (const Vec3& p : result.x) {
    lowest = std::min(lowest, p.z()), highest = std::max(highest, p.z());
    left = std::min(left, p.x()), right = std::max(right, p.x());
    if (p.z() < m.thickness + result.layer) {
      EXPECT_LT(std::abs(p.x()), 0.2 * radius);
    }
  }
  EXPECT_NEAR((right - left) / 2, end.x(), 0.01 * radius);
  EXPECT_NEAR(highest - lowest, end.y(), 0.02 * radius);
}

}  // namespace
}  // namespace trivet::test
