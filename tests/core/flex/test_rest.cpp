// Rest is no balance that a breath ends, and has no layers nearer than the thickness.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/flex/contact.h"
#include "core/flex/self_crossings.h"
#include "tests/core/flex/stage.h"

namespace trivet::test {
namespace {

double width(const Points& x, int axis) {
  double low = kInfinity, high = -kInfinity;
  for (const Vec3& p : x) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
  return high - low;
}

// Its plane is one of symmetry, so that no force leads out of it.
TEST(FlexRest, SheetHungFlatByItsCornerFallsIntoFolds) {
  FlexMaterial towel;
  towel.density = 0.4, towel.thickness = 0.002, towel.stretch = 500, towel.shear = 30;
  towel.bending = 5e-5;
  DrapeProblem problem = sheet(12, 12, 0.4, 0.4, Vec3::Zero(), towel);
  const double half = std::sqrt(0.5);
  for (Vec3& p : problem.start) p = Vec3((p.x() - p.y()) * half, 0, 1 + (p.x() + p.y()) * half);
  problem.pinned.back() = true;
  const DrapeResult result = drape(problem, built({}), {});
  ASSERT_EQ(result.ending, Ending::AtRest);
  EXPECT_TRUE(result.certificate.stable);
  EXPECT_GT(width(result.x, 1), 0.02);
  EXPECT_LT(width(result.x, 0), 0.9 * width(problem.start, 0));
}

// Two layers of a folded sheet, on a floor.
DrapeProblem folded(double distance, const FlexMaterial& material) {
  DrapeProblem out = sheet(17, 4, 0.17, 0.04, Vec3::Zero(), material);
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 17; ++i) {
      Vec3& p = out.start[out.grid->vertex(i, j)];
      // The ninth cell stands upright between the layers.
      p = Vec3(0.01 * std::min(i, 17 - i), p.y(), i < 9 ? 0.0015 : 0.0015 + distance);
    }
  return out;
}

TEST(FlexRest, LayersThatBeginTooNearEndBeyondTheThickness) {
  FlexMaterial material;
  material.thickness = 0.002, material.bending = 5e-5;
  Obstacles floor;
  add_box(floor, {-1, -1, -0.05}, {1, 1, 0});
  floor.build();
  DrapeOptions options;
  options.levels = 1;
  const DrapeProblem problem = folded(0.0012, material);
  const DrapeResult result = drape(problem, floor, options);
  ASSERT_EQ(result.ending, Ending::AtRest);
  // A contact without memory finds nothing at its offset or nearer.
  const Body body = body_of(problem);
  Surroundings surroundings(body, floor);
  Contact contact(surroundings, {result.layer, options.pressure});
  std::vector<ContactPair> pairs;
  EXPECT_FALSE(contact.find(problem.start, pairs));
  EXPECT_TRUE(contact.find(result.x, pairs));
  EXPECT_FALSE(self_crossing(result.x, body.faces));
}

}  // namespace
}  // namespace trivet::test
