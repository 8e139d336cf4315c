// Cloths and cables as objects of a scene: at rest, judged, refused.
#include <tbb/global_control.h>

#include "core/flex/flexible.h"
#include "core/scene/fingerprint.h"
#include "draping.h"
#include "ops/base/interrupt.h"
#include "ops/operations/drape_watch.h"

namespace trivet::test {
namespace {

TEST(Drape, ClothComesToRestOnABlock) {
  Stage s = with_block();
  const OperationResult result = s.run(cloth());
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, OperationResult::End::AtRest);
  const Object& object = s.at("cloth");
  EXPECT_TRUE(object.fixed && object.placed);
  ASSERT_TRUE(object.flexible);
  const RestCertificate& c = object.flexible->certificate;
  EXPECT_LT(c.net_force, 1e-3);
  EXPECT_NEAR(c.balance, 1, 1e-4);
  EXPECT_TRUE(c.stable);
  EXPECT_LE(c.friction_used, 1 + 1e-12);
  ASSERT_EQ(object.flexible->supports.size(), 1u);
  EXPECT_EQ(object.flexible->supports[0].name, "block");
  EXPECT_NEAR(object.flexible->supports[0].share, 1, 1e-4);
  // Its rim hangs beside the block.
  EXPECT_LT(s.scene.world_box(*s.scene.find("cloth")).lower.z(), 0.37);
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok());
}

TEST(Drape, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::optional<std::uint64_t> first;
  for (const int threads : {1, 2, 8}) {
    Stage s = with_block();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    ASSERT_TRUE(s.run(cloth()).ok());
    const std::uint64_t bits = fingerprint(s.scene);
    EXPECT_EQ(first.value_or(bits), bits) << threads;
    first = bits;
  }
}

TEST(Drape, CableLiesOnTheFloorAndOverABlock) {
  Stage s = with_block();
  const OperationResult result = s.run(lead({{-0.2, 0, 0.41}, {0.6, 0.05, 0.41}}));
  ASSERT_TRUE(result.ok()) << result.reason();
  const Flexible& flexible = *s.at("lead").flexible;
  EXPECT_TRUE(flexible.is_cable);
  double sum = 0;
  for (const FlexSupport& support : flexible.supports) sum += support.share;
  EXPECT_NEAR(sum, 1, 1e-3);
  EXPECT_GE(s.scene.world_box(*s.scene.find("lead")).lower.z(), 0);
}

TEST(Drape, HangsFromPins) {
  Stage s;
  s.scene.floor = false;
  DrapeOperation o = lead({{-0.5, 0, 1}, {0, 0, 0.7}, {0.5, 0, 1}});
  o.pins = {{-0.5, 0, 1}, {0.5, 0, 1}};
  const OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  const Flexible& flexible = *s.at("lead").flexible;
  ASSERT_EQ(flexible.supports.size(), 1u);
  EXPECT_EQ(flexible.supports[0].name, "pins");
  EXPECT_NEAR(flexible.supports[0].share, 1, 1e-3);
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok());
}

TEST(Drape, IsRefusedWithReasons) {
  Stage s = with_block();
  DrapeOperation o = cloth();
  o.object = "block";
  s.refused(o, "block");
  s.refused(cloth(0.36, 0.4002), "\"block\"");  // nearer than half its thickness
  s.refused(cloth(0.36, 0.3), "\"block\"");     // through it
  o = cloth();
  o.steps = 3;
  s.refused(o, "did not come to rest within");
  o = cloth();
  o.material = "lead";
  s.refused(o, "cotton, felt, paper, towel, wool");
  o = cloth();
  o.cell = 1e-4;
  s.refused(o, "cells");
  o = cloth();
  o.thickness = 0.02;
  s.refused(o, "twice the thickness");
  s.refused(lead({{0, 0, 1}}), "two or more");
  s.refused(lead({}), "two or more");
  o = lead({{-0.2, 0, 0.5}, {0.2, 0, 0.5}, {0.2, 0.1, 0.5}, {0, 0.1, 0.5}, {0, -0.1, 0.502}});
  s.refused(o, "passes through itself");
  s.scene.floor = false;
  s.refused(lead({{3, 0, 1}, {3.4, 0, 1}}), "below");
}

TEST(Drape, TornOnesAreRefused) {
  Stage s = with_block();
  DrapeOperation o = lead({{-0.5, 0, 1}, {0.5, 0, 1}});
  o.density = 1000;  // half a tonne and more on a lead
  o.pins = {{-0.5, 0, 1}, {0.5, 0, 1}};
  s.refused(o, "stretched");
}

TEST(Drape, OpenMeshesComeDownAndClosedOnesDoNot) {
  Stage s = with_block();
  std::vector<Triangle> grid;
  const auto at = [](int i, int j) { return Vec3(0.03 * i - 0.15, 0.03 * j - 0.15, 0); };
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 10; ++i) {
      grid.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      grid.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  s.scene.add(object_of("napkin", grid));
  DrapeOperation o;
  o.object = "cloth";
  o.of = "napkin";
  o.start.translation = Vec3(0, 0, 0.42);
  const OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(s.at("cloth").flexible->vertices.size(), 121u);
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok());
  o.object = "other";
  o.of = "block";
  s.refused(o, "closed");
  // As for sheets, cells have to be twice as wide as the thickness.
  o.of = "napkin";
  o.thickness = 0.02;
  s.refused(o, "0.04");
}

TEST(Drape, CancelledKeepsTheScene) {
  Stage s = with_block();
  const std::string before = snapshot(s.scene);
  const std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  const OperationResult result = perform(s.scene, cloth(), s.options, context);
  EXPECT_EQ(result.status, OperationResult::Status::Cancelled);
  EXPECT_EQ(snapshot(s.scene), before);
}

TEST(Drape, CarriesWhatIsPutOnIt) {
  Stage s = with_block();
  ASSERT_TRUE(s.run(cloth()).ok());
  s.put("cup", box_triangles(Vec3(0.03, 0.03, 0.04)), {0, 0, 0.6});
  EXPECT_EQ(s.at("cup").state, ObjectState::Stable);
  EXPECT_NE(loads_text(s.scene).find("cup on cloth"), std::string::npos) << loads_text(s.scene);
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok());
}

TEST(Drape, WhatIsTakenFromBelowIsSeen) {
  Stage s = with_block();
  ASSERT_TRUE(s.run(cloth()).ok());
  DeleteOperation take;
  take.object = "block";
  const OperationResult result = s.run(take);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(has(result.unsupported, "cloth"));
  EXPECT_TRUE(has(check_scene(s.scene, 1, 0, s.options).not_at_rest, "cloth"));
}

TEST(Drape, WhatIsRenamedBelowCarriesOn) {
  Stage s = with_block();
  ASSERT_TRUE(s.run(cloth()).ok());
  const OperationResult result = s.run(RenameOperation{"block", "stone"});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result.unsupported.empty());
  EXPECT_EQ(s.at("cloth").flexible->supports[0].name, "stone");
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok());
}

TEST(Drape, CheckSeesPlantedErrors) {
  Stage s = with_block();
  ASSERT_TRUE(s.run(cloth()).ok());
  const auto spoil = [&](const auto& change) {
    Scene spoiled = s.scene;
    edit_object(spoiled, *spoiled.find("cloth"), [&](Object& object) {
      auto flexible = std::make_shared<Flexible>(*object.flexible);
      change(*flexible);
      object.flexible = flexible;
    });
    return check_scene(spoiled, 1, 0, s.options);
  };
  // A corner on the other side of the middle.
  const SceneCheck crossing = spoil([](Flexible& f) { f.vertices[0] = -f.vertices[0]; });
  ASSERT_FALSE(crossing.crossings.empty());
  EXPECT_EQ(crossing.crossings[0].a, "cloth");
  EXPECT_EQ(crossing.crossings[0].b, "cloth");
  // A vertex that hangs higher than it would.
  const SceneCheck pulled = spoil([](Flexible& f) { f.vertices[0].z() += 0.002; });
  EXPECT_TRUE(has(pulled.not_at_rest, "cloth"));
  // Friction that nothing gives.
  const SceneCheck pushed = spoil([](Flexible& f) { f.friction[5].x() += 0.01; });
  EXPECT_TRUE(has(pushed.not_at_rest, "cloth"));
  EXPECT_TRUE(spoil([](Flexible&) {}).ok());
}

TEST(Drape, UnfixedItIsStiff) {
  Stage s = with_block();
  ASSERT_TRUE(s.run(cloth()).ok());
  FixOperation unfix;
  unfix.object = "cloth";
  unfix.fixed = false;
  ASSERT_TRUE(s.run(unfix).ok());
  EXPECT_FALSE(s.at("cloth").flexible);
}

// The floor has no edge that presses: what lies on it is at rest wherever it slid to.
TEST(Drape, RestsOnTheFloorForTheCheckToo) {
  for (int i = 0; i < 4; ++i) {
    Stage s;
    s.fix("edge", box_triangles(Vec3(0.05, 0.2, 0.1)), {0, 0, 0.1 + 1e-5});
    const double end = 0.25 + 0.1 * i;
    const OperationResult result = s.run(lead({{-0.1, -0.3 * i, 0.25}, {end, 0.1 * i, 0.25}}));
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok()) << i;
  }
}

TEST(Drape, HoldersAreAsManyAsPinsAndKnown) {
  Stage s = with_block();
  DrapeOperation o = lead({{-0.5, 0, 1}, {0, 0, 0.7}, {0.5, 0, 1}});
  o.pins = {{-0.5, 0, 1}, {0.5, 0, 1}};
  o.held_by = {"block"};
  s.refused(o, "held_by");
  o.held_by = {"block", "blok"};
  s.refused(o, "blok");
}

TEST(Drape, IsDoneAgainWhenWhatIsBelowMoved) {
  Stage s = with_block();
  ASSERT_TRUE(s.run(cloth()).ok());
  const double before = s.scene.world_box(*s.scene.find("cloth")).lower.z();
  DeleteOperation away;
  away.object = "block";
  EXPECT_TRUE(has(s.run(away).unsupported, "cloth"));
  s.fix("low", box_triangles(Vec3(0.1, 0.1, 0.1)), {0, 0, 0.1 + 1e-5});
  DrapeOperation again;
  again.object = "cloth";
  again.again = true;
  const OperationResult result = s.run(again);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_TRUE(check_scene(s.scene, 1, 0, s.options).ok());
  EXPECT_EQ(s.at("cloth").flexible->grid->num_u, 16);
  EXPECT_LT(s.scene.world_box(*s.scene.find("cloth")).lower.z(), before - 0.15);
  again.object = "low";
  s.refused(again, "it is not flexible");
  again.object = "clothe";
  s.refused(again, "clothe");
}

TEST(Drape, WatchersSeeItComeDownFromCoarseToFine) {
  Stage s = with_block();
  std::vector<size_t> sizes;
  {
    const DrapeWatch watch(
        [&](const std::shared_ptr<const Object>& object, double) {
          EXPECT_EQ(object->name, "cloth");
          sizes.push_back(object->model->mesh.triangles.size());
        },
        1e9);
    DrapeOperation o = cloth();
    o.material = "paper";
    o.cell = o.size->x() / 32;
    ASSERT_TRUE(s.run(o).ok());
  }
  EXPECT_GT(sizes.size(), 10u);
  EXPECT_LT(sizes.front(), sizes.back());
  EXPECT_TRUE(std::is_sorted(sizes.begin(), sizes.end()));
}

}  // namespace
}  // namespace trivet::test
