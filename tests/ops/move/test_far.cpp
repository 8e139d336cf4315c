// Distant objects, and small objects in a large scene: the clearance becomes too coarse.
#include "stage.h"

namespace trivet::test {
namespace {

constexpr double kFar[] = {1e4, 1e9, 1e14};
constexpr const char* kSays = "is too coarse for \"cup\" of 0.1732 m; accepted: coordinates and";

struct Table : Stage {
  Table() {
    fix("table", box_triangles(Vec3(0.5, 0.5, 0.05)), Vec3(0, 0, 0.06));
    put("cup", box_triangles(Vec3(0.05, 0.05, 0.05)), Vec3(0, 0, 1));
    put("beside", box_triangles(Vec3(0.1, 0.1, 0.1)), Vec3(2, 0, 1));
  }
};

TEST(Far, RefusesEveryOperationThatLeadsThere) {
  for (const double far : kFar) {
    Table s;
    s.refused(TranslateOperation{{"beside"}, Vec3(far, 0, 0)}, kSays);
    s.refused(TranslateOperation{{"beside"}, Vec3(0, 0, far), true}, kSays);
    s.refused(TranslateOperation{{"beside"}, Vec3(0, -far, 0), false, true}, kSays);
    s.refused(RotateOperation{{"beside"}, Vec3::UnitZ(), 30, Vec3(0, far, 0)}, kSays);
    s.refused(PickUpOperation{{"beside"}, far, {}}, kSays);
    s.refused(PushOperation{{"beside"}, Vec2::UnitX(), far, {}}, kSays);
    s.refused(PutOperation{{"beside"}, Pose{{}, Vec3(far, 0, 1)}, {}}, kSays);
    const ObjectId id = s.scene.add(object_of("k", box_triangles(Vec3(0.1, 0.1, 0.1))));
    const OperationResult stood = stand(s.scene, id, {{}, Vec3(0, far, 1)});
    EXPECT_NE(stood.reason().find(kSays), std::string::npos) << stood.reason();
    EXPECT_EQ(stood.reason().find("\"k\" reaches a coordinate of "), 0u) << stood.reason();
  }
}

// An object that falls from there ends nearby; where double itself is too coarse it is refused.
TEST(Far, AcceptsHighStart) {
  Table s;
  const OperationResult result = s.run(PutOperation{{"beside"}, Pose{{}, Vec3(2, 0, 1e4)}, {}});
  EXPECT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(s.position("beside").z(), 0.1, 1e-5);
  s.run(PutOperation{{"beside"}, Pose{{}, Vec3(2, 0, 1e14)}, {}});
}

TEST(Far, NamesAcceptedRange) {
  Table s;
  const std::string reason =
      perform(s.scene, TranslateOperation{{"beside"}, Vec3(1e4, 0, 0)}).reason();
  const size_t at = reason.find("up to ");
  ASSERT_NE(at, std::string::npos) << reason;
  const double accepted = std::stod(reason.substr(at + 6));
  EXPECT_TRUE(perform(s.scene, TranslateOperation{{"beside"}, Vec3(0.99 * accepted, 0, 0)}).ok());
  s.refused(TranslateOperation{{"beside"}, Vec3(0.03 * accepted, 0, 0)}, kSays);
  EXPECT_TRUE(perform(s.scene, TranslateOperation{{"beside"}, Vec3(-0.5 * accepted, 0, 0)}).ok());
}

// The same distance is acceptable for large objects.
TEST(Far, AcceptsLargeScenes) {
  Stage city;
  city.fix("ground", box_triangles(Vec3(5e4, 5e4, 10)), Vec3(0, 0, 11));
  city.put("tower", box_triangles(Vec3(20, 20, 100)), Vec3(0, 0, 500));
  EXPECT_TRUE(city.run(TranslateOperation{{"tower"}, Vec3(0, 1e4, 10)}).ok());
  Stage hall;
  hall.fix("floor of 1 km", box_triangles(Vec3(500, 500, 0.5)), Vec3(0, 0, 0.6));
  hall.put("cup of 10 cm", box_triangles(Vec3(0.05, 0.05, 0.05)), Vec3(100, 0, 3));
  EXPECT_TRUE(hall.run(TranslateOperation{{"cup of 10 cm"}, Vec3(0, 100, 0.1)}).ok());
}

TEST(Far, UsesRequestedClearance) {
  Table s;
  SettleOptions fine;
  fine.clearance = 1e-3;
  const Operation away = TranslateOperation{{"beside"}, Vec3(1e4, 0, 0)};
  const OperationResult result = perform(s.scene, away, fine);
  ASSERT_TRUE(result.ok()) << result.reason();
  s.refused(TranslateOperation{{"beside"}, Vec3(1, 0, 0)}, kSays);
  const Operation back = TranslateOperation{{"beside"}, Vec3(-1e4, 0, 0)};
  EXPECT_TRUE(perform(s.scene, back, fine).ok());
  fine.clearance = 2.75e-3;  // too coarse itself
  EXPECT_NE(perform(s.scene, away, fine).reason().find(kSays), std::string::npos);
}

}  // namespace
}  // namespace trivet::test
