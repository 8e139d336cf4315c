// Puzzles with known answers, and the conflicts of those that have none.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ops/arrange/arrange_testing.h"

namespace trivet {
namespace {

using test::expect_true;
using test::Stage;
using test::state_of;

Pattern& add_grid(Stage& stage, int count) {
  Pattern grid;
  grid.kind = Pattern::Kind::Grid;
  grid.on = "tray";
  grid.level = 0;
  grid.gap = 1e-4;
  for (int i = 0; i < count; ++i) {
    stage.add_cube("cube_" + std::to_string(i));
    grid.things.push_back("cube_" + std::to_string(i));
  }
  stage.arrangement.patterns.push_back(grid);
  return stage.arrangement.patterns.back();
}

TEST(Puzzle, TwelveCubesFillATrayOfThreeByFour) {
  Stage stage;
  stage.fix("tray", test::tray(0.401, 0.301), Vec3(1, 2, 1e-5));
  add_grid(stage, 12);
  const ArrangeResult result = stage.run();
  expect_true(stage, result);
  for (int i = 0; i < 12; ++i) {
    const Aabb box = stage.box("cube_" + std::to_string(i));
    EXPECT_GT(box.lower.x(), 1 - 0.2005);
    EXPECT_LT(box.upper.y(), 2 + 0.1505);
    EXPECT_NEAR(box.lower.z(), 0.02, 1e-4);
  }
}

TEST(Puzzle, ThirteenCubesAreOneTooMany) {
  Stage stage;
  stage.fix("tray", test::tray(0.401, 0.301), Vec3(0, 0, 1e-5));
  add_grid(stage, 13);
  const auto before = state_of(stage.scene);
  const ArrangeResult result = stage.run();
  EXPECT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NE(result.reason().find("grid of 13 objects on \"tray\" does not fit: there is room for 4 "
                                 "by 3"),
            std::string::npos)
      << result.reason();
  EXPECT_EQ(state_of(stage.scene), before);
}

// Books of an eighth of a metre with gaps of 1/128 m: all of it exact in float32.
ArrangeResult run_row(Stage& stage, double board) {
  stage.fix("board", test::box_between(Vec3(-0.5 * board, -0.1, 0), Vec3(0.5 * board, 0.1, 0.05)),
            Vec3(0, 0, 1e-5));
  Pattern row;
  row.on = "board";
  row.gap = 1.0 / 128;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "book_" + std::to_string(i);
    stage.add(name, test::box_between(Vec3(-0.0625, -0.08, 0), Vec3(0.0625, 0.08, 0.2)));
    row.things.push_back(name);
  }
  stage.arrangement.patterns.push_back(row);
  return stage.run();
}

TEST(Puzzle, RowThatFitsExactlyIsPlaced) {
  Stage stage;
  const ArrangeResult result = run_row(stage, 0.5234375);
  expect_true(stage, result);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(stage.box("book_" + std::to_string(i)).lower.x(),
                -0.26171875 + i * (0.125 + 1.0 / 128), 1e-5);
}

TEST(Puzzle, RowATenthOfAMillimetreTooLongIsNot) {
  Stage stage;
  const ArrangeResult result = run_row(stage, 0.5234375 - 1e-4);
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NEAR(result.conflict->missing.value(), 1e-4, 1e-7);
  EXPECT_NE(result.reason().find("with gaps they are 0.5234375 m wide"), std::string::npos)
      << result.reason();
}

TEST(Puzzle, ContradictionOfTwoAmongFiftyIsFound) {
  Stage stage;
  stage.add_cube("jug");
  stage.relate<relations::At>("jug").as<relations::At>()->point = Vec2(0, 0);
  for (int i = 0; i < 12; ++i) {
    const std::string name = "cup_" + std::to_string(i);
    stage.add_cube(name, 0.05);
    stage.relate<relations::Near>(name, "jug").as<relations::Near>()->upper = 2;
    stage.relate<relations::Within>(name).as<relations::Within>()->region = {
        Vec2(-3, -3), Vec2(3, -3), Vec2(3, 3), Vec2(-3, 3)};
    stage.relate<relations::Aligned>(name, "jug").tolerance = 2;
    if (i % 2)
      stage.relate<relations::Behind>(name, "jug").as<relations::Behind>()->overlap = 0;
    else
      stage.relate<relations::InFrontOf>(name, "jug").as<relations::InFrontOf>()->overlap = 0;
  }
  stage.add_cube("teapot", 0.12);
  stage.relate<relations::LeftOf>("teapot", "jug");
  stage.relate<relations::RightOf>("teapot", "jug").as<relations::RightOf>()->lower = 0.05;
  stage.relate<relations::Near>("teapot", "jug").as<relations::Near>()->upper = 1;
  EXPECT_GE(stage.arrangement.relations.size(), 50u);
  stage.arrangement.max_attempts = 1;
  stage.arrangement.max_evictions = 6;
  const auto before = state_of(stage.scene);
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_EQ(result.conflict->thing, "teapot");
  const std::vector<std::string> both{"\"teapot\" left_of \"jug\"", "\"teapot\" right_of \"jug\""};
  EXPECT_EQ(in_english(result.conflict->constraints), both);
  // The teapot would have to pass the jug: both widths, and the gap.
  EXPECT_NEAR(result.conflict->missing.value(), 0.1 + 0.12 + 0.12 + 0.05 - 0.12, 1e-6);
  EXPECT_EQ(state_of(stage.scene), before);
}

TEST(Puzzle, ReportsTheLengthMissingBetweenTwo) {
  Stage stage;
  stage.fix("bowl_1", test::box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.1)),
            Vec3(-0.2, 0, 1e-5));
  stage.fix("bowl_2", test::box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.1)),
            Vec3(0.2, 0, 1e-5));
  stage.add("bowl_3", test::box_between(Vec3(-0.127, -0.1, 0), Vec3(0.127, 0.1, 0.1)),
            {"", {}, {0}});
  stage.relate<relations::RightOf>("bowl_3", "bowl_1");
  stage.relate<relations::LeftOf>("bowl_3", "bowl_2");
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NEAR(result.conflict->missing.value(), 0.054, 1e-6);  // they leave 0.2 m, it needs 0.254
  EXPECT_FALSE(result.conflict->as_they_stand);
  EXPECT_EQ(result.conflict->constraints.size(), 2u);
  EXPECT_EQ(
      result.reason().find("\"bowl_3\" does not fit between \"bowl_1\" and \"bowl_2\": they leave "
                           "0.2 m along x, it needs 0.254 m; the cheapest to drop: "),
      0u)
      << result.reason();
  EXPECT_EQ(result.num_attempts, 1) << "no other seed would find a place";
}

TEST(Conflict, NamesWhatIsInTheWay) {
  Stage stage;
  stage.fix("post", test::box_between(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 1)), Vec3(0, 0, 1e-5));
  stage.add_cube("cube", 0.2);
  stage.relate<relations::Within>("cube").as<relations::Within>()->region = {
      Vec2(-0.25, -0.25), Vec2(0.25, -0.25), Vec2(0.25, 0.25), Vec2(-0.25, 0.25)};
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  const std::vector<std::string> both{"\"cube\" within its region", "clear of \"post\""};
  EXPECT_EQ(in_english(result.conflict->constraints), both) << result.reason();
}

TEST(Conflict, SaysThatTheHeadRoomIsTooLow) {
  Stage stage;
  stage.fix("shelf", test::shelf({0.1, 0.4, 0.8}), Vec3(0, 0, 1e-5));
  stage.add_cube("cube", 0.29);
  stage.relate<relations::On>("cube", "shelf").as<relations::On>()->level = 0;
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NE(result.reason().find("head room"), std::string::npos) << result.reason();
}

}  // namespace
}  // namespace trivet
