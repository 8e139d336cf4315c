// Circles, facings and mirror images where they have to be; several solutions that differ.
#include "core/scene/fingerprint.h"
#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/solutions.h"

namespace trivet::test {
namespace {

Pattern& add_pattern(Stage& stage, Pattern::Kind kind, const std::string& on, int count) {
  Pattern pattern;
  pattern.kind = kind;
  pattern.on = on;
  for (int i = 0; i < count; ++i) pattern.things.push_back("cube_" + std::to_string(i));
  stage.arrangement.patterns.push_back(pattern);
  return stage.arrangement.patterns.back();
}

Stage table_stage(int cubes, double edge = 0.1) {
  Stage stage;
  stage.fix("table", box_between(Vec3(-0.6, -0.5, 0), Vec3(0.6, 0.5, 0.7)), Vec3(1, 0, 1e-5));
  for (int i = 0; i < cubes; ++i) stage.add_cube("cube_" + std::to_string(i), edge);
  return stage;
}

// Discs of a sixteenth of a metre, their widest at vertices on the axis.
ArrangeResult run_discs(Stage& stage, double board) {
  stage.fix("board", box_between(Vec3(-0.5 * board, -0.1, 0), Vec3(0.5 * board, 0.1, 0.05)),
            Vec3(0, 0, 1e-5));
  for (int i = 0; i < 5; ++i)
    stage.add("cube_" + std::to_string(i), cylinder(0.0625, 0.03125, 32), {"", {}, {0}});
  add_pattern(stage, Pattern::Kind::Row, "board", 5).gap = 1.0 / 256;
  return stage.run();
}

TEST(Puzzle, DiscsInARowFitExactly) {
  Stage stage;
  expect_true(stage, run_discs(stage, 5 * 0.125 + 4.0 / 256));
}

TEST(Puzzle, DiscsInARowATenthOfAMillimetreTooLongDoNot) {
  Stage stage;
  const ArrangeResult result = run_discs(stage, 5 * 0.125 + 4.0 / 256 - 1e-4);
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NEAR(result.conflict->missing.value(), 1e-4, 1e-7);
}

TEST(Circle, StandsAroundTheMiddleWithFrontsToIt) {
  Stage stage = table_stage(6);
  add_pattern(stage, Pattern::Kind::Circle, "table", 6).radius = 0.3;
  expect_true(stage, stage.run());
  const double s = std::sqrt(3.0) / 2;
  const Vec2 expected[] = {{1, 0}, {0.5, s}, {-0.5, s}, {-1, 0}, {-0.5, -s}, {0.5, -s}};
  for (int i = 0; i < 6; ++i) {
    const Object& cube = stage.at("cube_" + std::to_string(i));
    const Vec2 at = cube.pose.translation.head<2>(), out = expected[i];
    EXPECT_NEAR((at - Vec2(1, 0) - 0.3 * out).norm(), 0, 1e-5) << i;
    const Vec3 front = -cube.pose.rotation.matrix().col(1);
    EXPECT_NEAR((front.head<2>() + out).norm(), 0, 1e-6) << i;
  }
}

TEST(Circle, OnTheFloorAroundAPoint) {
  Stage stage = table_stage(5);
  Pattern& circle = add_pattern(stage, Pattern::Kind::Circle, "floor", 5);
  circle.radius = 1;
  circle.middle = Vec2(1, 0);
  circle.outwards = true;
  circle.start_deg = 90;
  expect_true(stage, stage.run());
  EXPECT_NEAR(stage.box("cube_0").centre().x(), 1, 1e-5);
  EXPECT_NEAR(stage.box("cube_0").centre().y(), 1, 1e-5);
  EXPECT_NEAR(stage.box("cube_0").lower.z(), 0, 1e-4);
}

TEST(Circle, TooManySayHowMuchIsMissing) {
  Stage stage = table_stage(4);
  Pattern& circle = add_pattern(stage, Pattern::Kind::Circle, "table", 4);
  circle.radius = 0.05;
  circle.gap = 0.01;
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NE(result.reason().find("neighbours need 0.01 m between them"), std::string::npos)
      << result.reason();
}

TEST(Facings, StandInBlocksFromTheFront) {
  Stage stage = table_stage(11);
  Pattern& facings = add_pattern(stage, Pattern::Kind::Facings, "table", 11);
  facings.gap = 0.02;
  facings.inset = 0.03;
  facings.blocks = {{5, 2}, {6, 3}};
  expect_true(stage, stage.run());
  const double left = 1 - 0.5 * (5 * 0.1 + 4 * 0.02) + 0.05, front = -0.5 + 0.03 + 0.05;
  const std::pair<int, int> cells[] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 2}, {2, 0},
                                       {3, 0}, {4, 0}, {2, 1}, {3, 1}, {4, 1}};
  for (int i = 0; i < 11; ++i) {
    const Vec3 at = stage.box("cube_" + std::to_string(i)).centre();
    EXPECT_NEAR(at.x(), left + 0.12 * cells[i].first, 1e-5) << i;
    EXPECT_NEAR(at.y(), front + 0.12 * cells[i].second, 1e-5) << i;
  }
}

TEST(Facings, TooDeepSayHowMuchIsMissing) {
  Stage stage = table_stage(9);
  Pattern& facings = add_pattern(stage, Pattern::Kind::Facings, "table", 9);
  facings.gap = 0.02;
  facings.blocks = {{9, 1}};
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NEAR(result.conflict->missing.value(), 9 * 0.12 - 0.02 - 1, 1e-6);
}

// One half of a table is laid as others are, the other as its mirror image.
TEST(Symmetric, SettingIsItsMirrorImage) {
  Stage stage = table_stage(0);
  for (const char* half : {"left", "right"})
    for (const char* what : {"plate", "glass", "jug"}) {
      const bool follows = half == std::string("left");
      stage.add(std::string(what) + "_" + half,
                box_between(Vec3(-0.04, -0.06, 0), Vec3(0.04, 0.06, 0.05)));
      const std::string name = std::string(what) + "_" + half;
      stage.relate<relations::On>(name, "table");
      if (follows) {
        Relation& mirrored = stage.relate<relations::Symmetric>(name, std::string(what) + "_right");
        mirrored.as<relations::Symmetric>()->middle = "table";
        mirrored.tolerance = 1e-3;
      } else {
        stage.relate<relations::Within>(name).as<relations::Within>()->region = {
            Vec2(1.05, -0.5), Vec2(1.6, -0.5), Vec2(1.6, 0.5), Vec2(1.05, 0.5)};
      }
    }
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    for (const char* what : {"plate", "glass", "jug"}) {
      const Object& left = stage.at(std::string(what) + "_left");
      const Object& right = stage.at(std::string(what) + "_right");
      const Vec3 a = left.pose.translation, b = right.pose.translation;
      EXPECT_NEAR(a.x() - 1, 1 - b.x(), 1e-3);
      EXPECT_NEAR(a.y(), b.y(), 1e-3);
      const Mat3 u = left.pose.rotation.matrix(), v = right.pose.rotation.matrix();
      EXPECT_NEAR(u(0, 1), -v(0, 1), 0.04);
      EXPECT_NEAR(u(1, 1), v(1, 1), 0.04);
    }
  }
}

TEST(Symmetric, IsOneOfAPairWhicheverComesFirst) {
  relations::Symmetric kind;
  kind.point = Vec2(0.3, -1);
  kind.axis = Vec2(0.6, 0.8);
  Relation r;
  r.kind = kind;
  r.tolerance = 0.01;
  Outline a, b;
  a.hull = b.hull = {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)};
  a = moved(a, Vec2(2, 0.5));
  b = moved(b, *kind.point + 2 * (a.centre - *kind.point).dot(kind.axis) * kind.axis -
                   (a.centre - *kind.point));
  a.front = Vec2(1, 0);
  b.front = 2 * a.front.dot(kind.axis) * kind.axis - a.front;
  EXPECT_NEAR(relation_cost(r, a, &b), 0, 1e-9);
  EXPECT_NEAR(relation_cost(r, b, &a), 0, 1e-9);
  EXPECT_NEAR(relation_cost(r, moved(a, Vec2(0.02, 0)), &b), 2, 1e-6);
}

TEST(Solutions, DifferAndAreTheSameAgain) {
  Stage stage = table_stage(3, 0.08);
  for (int i = 0; i < 3; ++i) stage.relate<relations::On>("cube_" + std::to_string(i), "table");
  const SolutionOptions wanted{4, 0.15};
  const auto find = [&] { return arrange_several(stage.scene, stage.arrangement, wanted, {}, {}); };
  const Solutions first = find(), again = find();
  ASSERT_EQ(first.found.size(), 4u);
  EXPECT_EQ(again.num_seeds, first.num_seeds);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(fingerprint(first.found[i].scene), fingerprint(again.found[i].scene));
    double least = kInfinity;
    for (size_t j = 0; j < i; ++j)
      least = std::min(least, difference_of(first.found[i].scene, first.found[j].scene,
                                            stage.arrangement.things));
    EXPECT_EQ(first.found[i].difference, least);
    EXPECT_GE(least, 0.15);
  }
  EXPECT_FALSE(stage.at("cube_0").placed);
}

TEST(Solutions, OfWhatHasOnlyOneAreOne) {
  Stage stage = table_stage(3);
  add_pattern(stage, Pattern::Kind::Row, "table", 3);
  const Solutions found = arrange_several(stage.scene, stage.arrangement, {3, 1e-3}, {}, {});
  EXPECT_EQ(found.found.size(), 1u);
  EXPECT_EQ(found.num_seeds, 12);
  EXPECT_EQ(found.num_alike, 11);
}

TEST(Solutions, OfAConflictAreNone) {
  Stage stage = table_stage(1, 0.3);
  stage.relate<relations::Within>("cube_0").as<relations::Within>()->region = {
      Vec2(0, 0), Vec2(0.2, 0), Vec2(0.2, 1)};
  const Solutions found = arrange_several(stage.scene, stage.arrangement, {3, 1e-3}, {}, {});
  EXPECT_TRUE(found.found.empty());
  EXPECT_EQ(found.num_seeds, 1);
  EXPECT_EQ(found.last.status, ArrangeResult::Status::Conflict);
}

}  // namespace
}  // namespace trivet::test
