// Scenes of recipes: functions of the recipe, the key and k, and layouts that give the same poses.
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "apps/farm/scene/make_scene.h"
#include "apps/farm/scene/scene_json.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/layout/run.h"

namespace trivet::farm {
namespace {

LoadedModel loaded(const std::string& name, double x, double y, double z) {
  Model model = box_model(x, y, z);
  model.path = name;
  auto shape = make_shape(model.mesh);
  return {std::make_shared<const Model>(std::move(model)), std::move(shape)};
}

const LoadedModels& models() {
  static const LoadedModels all{{{"slab", {}}, loaded("slab", 0.5, 0.5, 0.05)},
                                {{"cube", {}}, loaded("cube", 0.05, 0.05, 0.05)},
                                {{"rod", {}}, loaded("rod", 0.02, 0.02, 0.1)}};
  return all;
}

Model model_of(const std::string& name, const Tessellation& tessellation) {
  return *models().at({name, tessellation}).model;
}

const std::string kSlab =
    R"("objects": [{"name": "slab", "model": "slab", "fixed": true, "position": [0, 0, 0.050001]}])";

Recipe recipe_of(const std::string& rest) {
  return parse_recipe("{\"trivet_recipe\": 1, " + kSlab + ", " + rest + "}", "recipe");
}

Recipe mixed_recipe() {
  return recipe_of(R"("groups": [
    {"name": "on", "models": [{"model": "cube", "weight": 2}, {"model": "rod"}], "count": [1, 3],
     "scale_range": [0.8, 1.2], "on": "slab", "keep": 0.01},
    {"name": "heap", "models": [{"model": "rod"}], "count": [0, 3], "rotation": "any",
     "heap": {"radius": 0.3, "height": 0.6, "rise": 0.2}},
    {"name": "in", "models": [{"model": "cube"}], "scale_range": 0.5, "in": "slab", "above": 0.3}],
    "then": [{"op": "push", "distance": [0, 0.1], "count": [0, 2]},
             {"op": "turn", "group": "on", "angle_deg": [-90, 90]}])");
}

TEST(RecipeScene, IsAFunctionOfRecipeKeyAndNumber) {
  const Recipe recipe = mixed_recipe();
  const SceneSource source{recipe, models(), {1, 2}}, other{recipe, models(), {1, 3}};
  std::vector<std::string> first;
  first.reserve(6);
  for (std::uint64_t k = 0; k < 6; ++k)
    first.push_back(json_line(scene_json(k, make_scene(source, k))));
  for (std::uint64_t k = 6; k-- > 0;)
    EXPECT_EQ(json_line(scene_json(k, make_scene(source, k))), first[k]);
  EXPECT_NE(json_line(scene_json(0, make_scene(other, 0))), first[0]);
  EXPECT_NE(first[0].substr(10), first[1].substr(10));
}

TEST(RecipeScene, EndsWhenItIsStopped) {
  const Recipe recipe = mixed_recipe();
  SceneSource source{recipe, models(), {1, 2}};
  const std::string whole = json_line(scene_json(0, make_scene(source, 0)));
  std::atomic<bool> cancel = false;
  source.context.cancel = &cancel;
  source.context.time_budget_s = 1000;
  const MadeScene made = make_scene(source, 0);
  EXPECT_EQ(made.end, OperationResult::Status::Ok);
  EXPECT_EQ(json_line(scene_json(0, made)), whole);
  source.context.time_budget_s = 1e-6;
  EXPECT_EQ(make_scene(source, 0).end, OperationResult::Status::OutOfTime);
  cancel = true;
  EXPECT_EQ(make_scene(source, 0).end, OperationResult::Status::Cancelled);
}

// A scene is also made by its layout, which trivet run lays out by code of its own.
TEST(RecipeScene, IsThatOfItsLayout) {
  const Recipe recipe = mixed_recipe();
  const SceneSource source{recipe, models(), {5, 6}};
  size_t num_operations = 0;
  for (std::uint64_t k = 0; k < 6; ++k) {
    const MadeScene made = make_scene(source, k);
    const LayoutRun run = run_layout(parse_layout(write_layout(made.layout), "k"), model_of, {});
    num_operations += made.layout.operations.size();
    for (const ObjectId id : made.run.scene.ids()) {
      const Object& a = made.run.scene.at(id);
      const Object& b = run.scene.at(*run.scene.find(a.name));
      ASSERT_EQ(a.placed, b.placed) << a.name;
      EXPECT_EQ(a.pose.translation, b.pose.translation) << a.name;
      EXPECT_EQ(a.pose.rotation.w, b.pose.rotation.w) << a.name;
      EXPECT_EQ(a.pose.rotation.z, b.pose.rotation.z) << a.name;
    }
    EXPECT_TRUE(run.check.ok());
  }
  EXPECT_GT(num_operations, 20u);
}

// Falls off in any case: a rod let fall over the rim of a slab, far above it.
TEST(RecipeScene, ObjectsStayInTheirContainer) {
  const Recipe recipe = recipe_of(R"("floor": true, "groups": [
    {"name": "in", "models": [{"model": "rod"}], "count": 3, "rotation": "any", "scale_range": 3,
     "in": "slab", "above": 0.1}])");
  int num_in = 0, num_out = 0;
  for (std::uint64_t k = 0; k < 12; ++k) {
    const MadeScene made = make_scene({recipe, models(), {1, 1}}, k);
    for (const ObjectId id : made.run.scene.ids()) {
      const Object& object = made.run.scene.at(id);
      if (object.fixed) continue;
      ++(object.placed ? num_in : num_out);
      if (!object.placed) {
        EXPECT_NE(made.left_out.at(object.name), "");
        continue;
      }
      const Vec3 centre = object.centre_of_mass();
      EXPECT_LE(std::abs(centre.x()), 0.51);
      EXPECT_LE(std::abs(centre.y()), 0.51);
    }
  }
  EXPECT_GT(num_in, 10);
  EXPECT_GT(num_out, 0) << "the test is vacuous";
}

// Rods that fall over would leave it; the frame of a tray is where it came to lie.
TEST(RecipeScene, ObjectsLieInTheirRegion) {
  const Recipe recipe = recipe_of(R"("groups": [
    {"name": "rod", "models": [{"model": "rod"}], "count": 4, "rotation": "any", "on": "slab",
     "region": [[-0.4, -0.4], [0.1, -0.4], [-0.4, 0.4]]},
    {"name": "tray", "models": [{"model": "slab"}], "scale_range": 0.3, "on": "slab",
     "region": [[0.1, -0.1], [0.5, 0.5]]},
    {"name": "cube", "models": [{"model": "cube"}], "count": 2, "scale_range": 0.3, "on": "tray",
     "region": [[0, -0.15], [0.15, 0.15]], "region_of": "support"}])");
  int num_in = 0;
  for (std::uint64_t k = 0; k < 12; ++k) {
    const MadeScene made = make_scene({recipe, models(), {1, 1}}, k);
    const Scene& scene = made.run.scene;
    const Object& tray = scene.at(*scene.find("tray_0"));
    for (const ObjectId id : scene.ids()) {
      const Object& object = scene.at(id);
      const std::string group = object.name.substr(0, object.name.find('_'));
      if (!object.placed || object.fixed) continue;
      ++num_in;
      for (const Vec3& vertex : object.shape->mesh.vertices) {
        const Vec3 p = object.world_from_object().apply(vertex);
        const Vec3 q = tray.pose.rotation.matrix().transpose() * (p - tray.pose.translation);
        // Over the side of its region: metres, of any scale.
        const double beyond = group == "rod"    ? 0.8 * (p.x() - 0.1) + 0.5 * (p.y() + 0.4)
                              : group == "tray" ? 0.1 - p.x()
                                                : -q.x();
        EXPECT_LE(beyond, 1e-12) << object.name;
      }
    }
  }
  EXPECT_GT(num_in, 60);
}

// Six cubes of half the slab's width do not fit on it side by side.
TEST(RecipeScene, TellsRefusalsAsTheRecipeSays) {
  const std::string groups =
      R"("groups": [{"name": "big", "models": [{"model": "cube"}], "count": 6,
    "scale_range": 5, "on": "slab"}])";
  const auto make = [&](const std::string& rest) {
    const Recipe recipe = recipe_of(groups + rest);
    return make_scene({recipe, models(), {3, 4}}, 0);
  };
  const MadeScene kept = make("");
  EXPECT_TRUE(kept.accepted);
  EXPECT_GE(kept.left_out.size(), 2u);
  EXPECT_EQ(scene_json(0, kept).at("refused"), kept.left_out.size());
  const MadeScene dropped = make(R"(, "on_refusal": "drop")");
  EXPECT_FALSE(dropped.accepted);
  EXPECT_EQ(dropped.reason.rfind("dropped: ", 0), 0u) << dropped.reason;
  const MadeScene few = make(R"(, "accept": {"min_objects": 6, "attempts": 2})");
  EXPECT_FALSE(few.accepted);
  EXPECT_EQ(few.attempt, 1) << "the last attempt counts";
  EXPECT_NE(few.reason.find("accepted: at least 6"), std::string::npos) << few.reason;
  const MadeScene strict = make(R"(, "accept": {"max_refused": 0})");
  EXPECT_NE(strict.reason.find("accepted: at most 0"), std::string::npos) << strict.reason;
  const MadeScene retried = make(R"(, "on_refusal": "retry", "tries": 4)");
  EXPECT_LE(retried.left_out.size(), kept.left_out.size() + 1);
  EXPECT_EQ(retried.run.operations.size(), 6u) << "one record for each object";
}

// Rods that fall on rods topple from most starts.
TEST(RecipeScene, TriesAsManyStartsAsAGroupSays) {
  const auto make = [](const std::string& rest) {
    const Recipe recipe = recipe_of(R"("groups": [{"name": "rod", "models": [{"model": "rod"}],
        "count": 8, "rotation": "any", "heap": {"radius": 0.05, "height": 0.4, "rise": 0.1})" +
                                    rest + "}]");
    return make_scene({recipe, models(), {1, 2}}, 0);
  };
  const auto tried = [](const MadeScene& made) {
    int most = 1;
    for (const OperationRecord& record : made.run.operations) {
      const OperationResult& result = record.result;
      if (result.tried) most = std::max(most, result.tried->number);
      if (result.refusal) most = std::max(most, static_cast<int>(result.refusal->number("tries")));
    }
    return most;
  };
  const MadeScene once = make(R"(, "tries": 1)"), twice = make(R"(, "tries": 2)"), usual = make("");
  EXPECT_EQ(tried(once), 1);
  EXPECT_GT(once.left_out.size(), usual.left_out.size());
  EXPECT_GT(tried(twice), 1);
  EXPECT_EQ(json_line(scene_json(0, usual)), json_line(scene_json(0, make(R"(, "tries": 12)"))));
}

TEST(RecipeScene, DrawsMassesAndMaterialsOfRanges) {
  const auto with = [](const std::string& model) {
    return parse_recipe(
        R"({"trivet_recipe": 1, "groups": [{"name": "cube", "count": 3, "on": "floor", "models": [{"model": "cube")" +
            model + "}]}]}",
        "a");
  };
  const Recipe ranges = with(
      R"(, "class": "die", "mass": [1, 2], "material": {"friction": [0.4, 0.6], "density": 300})");
  const MadeScene made = make_scene({ranges, models(), {1, 2}}, 4);
  const MadeScene plain = make_scene({with(""), models(), {1, 2}}, 4);
  const Json told = scene_json(4, made);
  double total = 0;
  std::set<double> masses;
  for (const ObjectId id : made.run.scene.ids()) {
    const Object& object = made.run.scene.at(id);
    ASSERT_TRUE(object.given_mass);
    EXPECT_GE(object.given_mass->kilograms, 1);
    EXPECT_LE(object.given_mass->kilograms, 2);
    EXPECT_GE(object.material.friction, 0.4);
    EXPECT_LE(object.material.friction, 0.6);
    EXPECT_EQ(object.material.density, 300);
    masses.insert(object.given_mass->kilograms);
    if (object.placed) total += object.given_mass->kilograms;
    // A range moves no other decision.
    EXPECT_EQ(object.pose.translation,
              plain.run.scene.at(*plain.run.scene.find(object.name)).pose.translation);
  }
  EXPECT_EQ(masses.size(), 3u);
  EXPECT_NEAR(told.at("kilograms").get<double>(), total, 1e-12);
  for (const Json& object : told.at("objects")) {
    EXPECT_EQ(object.at("class"), "die");
    EXPECT_NEAR(object.at("kilograms").get<double>(), object.at("mass").get<double>(), 1e-12);
    EXPECT_EQ(object.at("supports"), Json::array({"floor"}));
  }
  EXPECT_EQ(manifest_row(told).at("classes"), Json({{"die", 3}}));
  const Layout again = layout_of_poses(ranges, told, "scene 4");
  EXPECT_EQ(again.objects[0].mass->kilograms, told.at("objects")[0].at("mass").get<double>());
  EXPECT_EQ(again.objects[0].class_name, "die");
  const Json without = scene_json(4, plain);
  EXPECT_NEAR(without.at("objects")[0].at("kilograms").get<double>(), 1, 1e-9)
      << "10 cm of density 1000";
  EXPECT_EQ(without.at("objects")[0].at("class"), "cube");
  EXPECT_FALSE(without.at("objects")[0].contains("mass"));
}

TEST(RecipeScene, StandsAgainFromItsPoses) {
  const Recipe recipe = mixed_recipe();
  const MadeScene made = make_scene({recipe, models(), {5, 6}}, 2);
  const Layout layout = layout_of_poses(recipe, scene_json(2, made), "scene 2");
  const LayoutRun run = run_start_only(layout, model_of, {});
  EXPECT_TRUE(run.check.ok());
  for (const ObjectId id : run.scene.ids()) {
    const Object& b = run.scene.at(id);
    const Object& a = made.run.scene.at(*made.run.scene.find(b.name));
    EXPECT_EQ(a.pose.translation, b.pose.translation);
    EXPECT_EQ(a.pose.rotation.w, b.pose.rotation.w);
    EXPECT_EQ(to_string(a.state), to_string(b.state));
  }
}

}  // namespace
}  // namespace trivet::farm
