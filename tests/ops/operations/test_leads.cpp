// Leads that objects hold: they go along, or hold back.
#include "draping.h"
#include "ops/operations/live_move.h"
#include "support/same_scene.h"

namespace trivet::test {
namespace {

// A lamp on the floor and a socket, and a lead of 1.2 m between them.
struct Lamp : Stage {
  Lamp() {
    put("lamp", box_triangles(Vec3(0.05, 0.05, 0.1)), {-0.4, 0, 0.11});
    fix("socket", box_triangles(Vec3(0.04, 0.02, 0.04)), {0.5, 0, 0.04 + 1e-5});
    DrapeOperation o = lead({{-0.345, 0, 0.05}, {0.05, 0, 0.3}, {0.455, 0, 0.05}});
    o.pins = {o.path.front(), o.path.back()};
    o.held_by = {"lamp", "socket"};
    const OperationResult result = run(o);
    EXPECT_TRUE(result.ok()) << result.reason();
  }
  OperationResult put_lamp(const Vec3& at) {
    PutOperation o;
    o.object = "lamp";
    o.start.translation = at;
    return run(o);
  }
  Vec3 end_of_lead() const {
    const Object& lead = this->at("lead");
    return lead.world_from_object().apply(lead.flexible->vertices.front());
  }
};

TEST(Leads, AreCarriedByWhatHoldsThem) {
  Lamp s;
  const std::vector<FlexSupport> supports = s.at("lead").flexible->supports;
  double sum = 0;
  for (const FlexSupport& support : supports) sum += support.share;
  EXPECT_NEAR(sum, 1, 1e-3);
  const auto is_named = [&](const char* name) {
    return std::any_of(supports.begin(), supports.end(),
                       [&](const FlexSupport& x) { return x.name == name; });
  };
  EXPECT_TRUE(is_named("lamp") && is_named("socket") && is_named("floor") && !is_named("pins"));
  const Vec3 from_lamp = s.end_of_lead() - s.position("lamp");
  const double length = s.at("lead").flexible->length;
  for (const Vec3& at : {Vec3(-0.3, 0.2, 0.11), Vec3(-0.45, -0.1, 0.11), Vec3(-0.4, 0, 0.11)}) {
    const OperationResult moved = s.put_lamp(at);
    ASSERT_TRUE(moved.ok()) << moved.reason();
    EXPECT_TRUE(moved.unsupported.empty());
    EXPECT_LT((s.end_of_lead() - s.position("lamp") - from_lamp).norm(), 1e-9);
    EXPECT_EQ(s.at("lead").flexible->length, length);
    EXPECT_LT(s.at("lead").flexible->certificate.net_force, 1e-3);
    EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).not_at_rest.empty());
  }
}

TEST(Leads, RefuseMovesBeyondTheirLength) {
  Lamp s;
  const OperationResult result = s.put_lamp({-2, 0, 0.11});
  EXPECT_FALSE(result.ok());
  EXPECT_NE(result.reason().find("\"lead\" would be stretched"), std::string::npos)
      << result.reason();
}

TEST(Leads, OfWhatIsTakenAwayAreNotAtRest) {
  Lamp s;
  UnplaceOperation o;
  o.object = "lamp";
  const OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(has(result.unsupported, "lead"));
  EXPECT_TRUE(has(check_scene(s.scene, 1, 0, s.options).not_at_rest, "lead"));
  DrapeOperation again;
  again.object = "lead";
  again.again = true;
  s.refused(again, "lamp");
}

TEST(Leads, AreHeldByRenamedHolders) {
  Lamp s;
  RenameOperation o;
  o.object = "lamp";
  o.to = "light";
  ASSERT_TRUE(s.run(o).ok());
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).not_at_rest.empty());
  EXPECT_EQ(s.at("lead").flexible->ties.front().name, "light");
}

// The lead would be in its way.
TEST(Leads, ComeAlongWhenTheirHolderIsDragged) {
  Lamp s, at_once;
  PushOperation push;
  push.object = "lamp";
  LiveMove live(s.scene, push, s.options);
  ASSERT_FALSE(live.refused()) << live.result().reason();
  live.follow(Vec3(-0.3, 0.05, 0));
  live.follow(Vec3(-0.2, 0.05, 0));
  const Operation operation = live.operation();
  const OperationResult result = live.finish(s.scene);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(s.position("lamp").x(), -0.2, 1e-6);
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok());
  ASSERT_TRUE(at_once.run(operation).ok());
  EXPECT_EQ(difference(s.scene, at_once.scene), "");
}

TEST(Leads, TakeBackDragsBeyondTheirLength) {
  Lamp s;
  PushOperation push;
  push.object = "lamp";
  LiveMove live(s.scene, push, s.options);
  live.follow(Vec3(-2, 0, 0));
  const OperationResult result = live.finish(s.scene);
  EXPECT_FALSE(result.ok());
  EXPECT_NE(result.reason().find("\"lead\" would be stretched"), std::string::npos)
      << result.reason();
  EXPECT_NEAR(s.position("lamp").x(), -0.4, 1e-6);
}

}  // namespace
}  // namespace trivet::test
