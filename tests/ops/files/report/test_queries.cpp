// Queries: supports of an object, its loads, its stability and margin.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ops/files/report/queries.h"
#include "ops/operations/perform.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

// A plate of half width 0.5 on the floor, a cube on it, and on the cube another one off its centre.
Scene tower() {
  Scene scene;
  const auto add = [&](const char* name, const Vec3& half, double x) {
    const ObjectId id = scene.add(object_of(name, box_triangles(half)));
    EXPECT_TRUE(put(scene, id, {{}, Vec3(x, 0, 3)}).ok());
  };
  add("plate", Vec3(0.5, 0.5, 0.05), 0);
  add("low", Vec3(0.1, 0.1, 0.1), 0.2);
  add("high", Vec3(0.1, 0.1, 0.1), 0.26);
  return scene;
}

std::vector<std::string> names(const Scene& scene, const std::vector<TouchedBy>& touched) {
  std::vector<std::string> out;
  for (const TouchedBy& t : touched) out.push_back(named(scene, t.with).name);
  return out;
}

using Names = std::vector<std::string>;

TEST(Queries, ListSupportsAndLoads) {
  const Scene scene = tower();
  const ObjectId plate = *scene.find("plate"), low = *scene.find("low"), high = *scene.find("high");
  EXPECT_EQ(names(scene, held_by(scene, plate)), Names{"floor"});
  EXPECT_EQ(names(scene, held_by(scene, low)), Names{"plate"});
  EXPECT_EQ(names(scene, held_by(scene, high)), Names{"low"});
  EXPECT_EQ(names(scene, lying_on(scene, plate)), Names{"low"});
  EXPECT_EQ(names(scene, lying_on(scene, low)), Names{"high"});
  EXPECT_TRUE(lying_on(scene, high).empty());
  EXPECT_EQ(held_by(scene, low).front().contact->type, ContactType::Area);
}

TEST(Queries, AgreeWithLoadSupportList) {
  const Scene scene = tower();
  for (const LoadSupport::Entry& entry : load_support(scene).entries) {
    std::vector<ObjectId> supports, loads;
    bool on_floor = false;
    for (const TouchedBy& t : held_by(scene, entry.object))
      t.with.is_object() ? supports.push_back(t.with.object()) : void(on_floor = true);
    for (const TouchedBy& t : lying_on(scene, entry.object)) loads.push_back(t.with.object());
    EXPECT_EQ(supports, entry.supports);
    EXPECT_EQ(loads, entry.loads);
    EXPECT_EQ(on_floor, entry.on_floor);
  }
}

TEST(Queries, ComputeMarginsAloneAndWithAllFree) {
  const Scene scene = tower();
  const ObjectId low = *scene.find("low"), high = *scene.find("high");
  EXPECT_TRUE(rest_of(scene, high).at_rest);
  EXPECT_NEAR(rest_of(scene, high).margin, 0.04, 1e-5);  // 0.26 in the overlap 0.16 to 0.30
  const nlohmann::json json = nlohmann::json::parse(object_query_json(scene, low, {}));
  EXPECT_EQ(json["name"], "low");
  EXPECT_EQ(json["held_by"][0]["name"], "plate");
  EXPECT_EQ(json["held_by"][0]["hull"].size(), 4u);
  EXPECT_EQ(json["carries"], nlohmann::json({"high"}));
  EXPECT_NEAR(json["stability_margin"].get<double>(), 0.1, 1e-5);
  // With the load on it: the common centre is at 0.23 of 0.1 to 0.3.
  EXPECT_NEAR(json["with_all_free"]["margin"].get<double>(), 0.07, 1e-5);
  EXPECT_TRUE(json["with_all_free"]["stable"].get<bool>());
  const std::string text = object_query_text(scene, low, {});
  EXPECT_NE(text.find("held by: \"plate\" (area)"), std::string::npos) << text;
  EXPECT_NE(text.find("lying on it: \"high\" (area)"), std::string::npos) << text;
}

}  // namespace
}  // namespace trivet::test
