#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <set>

#include "core/base/error.h"
#include "core/scene/transaction.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/layout/run.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

/// "cube.obj" of edge 0.1 and "slab.obj" of 1 x 1 x 0.1; counts how often each is read.
class BoxSource {
 public:
  ModelSource source() {
    return [this](const std::string& name, const Tessellation&) {
      {
        const std::lock_guard lock(m_mutex);
        ++m_reads[name];
      }
      if (name == "cube.obj") return box_model(0.05, 0.05, 0.05);
      if (name == "slab.obj") return box_model(0.5, 0.5, 0.05);
      throw Error(Error::Kind::BadInput, name + ": no such file");
    };
  }
  int reads(const std::string& name) { return m_reads[name]; }

 private:
  std::mutex m_mutex;
  std::map<std::string, int> m_reads;
};

Layout parsed(const std::string& objects, const std::string& operations = "") {
  return parse_layout(
      "{\"trivet\": 1, \"objects\": [" + objects + "], \"operations\": [" + operations + "]}",
      "a.json");
}

std::string object(const std::string& name, const std::string& model,
                   const std::string& more = "") {
  return "{\"name\": \"" + name + "\", \"model\": \"" + model + "\"" + more + "}";
}

std::string put_at(const std::string& name, const std::string& position) {
  return "{\"op\": \"put\", \"object\": \"" + name + "\", \"position\": " + position + "}";
}

const std::string kSlab =
    object("slab", "slab.obj", ", \"fixed\": true, \"position\": [0, 0, 0.050001]");

TEST(RunLayout, PutsCubesOnSlab) {
  BoxSource boxes;
  const Layout layout =
      parsed(kSlab + "," + object("a", "cube.obj") + "," + object("b", "cube.obj"),
             put_at("a", "[0, 0, 1]") + "," + put_at("b", "[0.01, 0, 1]"));
  const LayoutRun run = run_layout(layout, boxes.source(), {});
  EXPECT_TRUE(run.ok());
  ASSERT_EQ(run.operations.size(), 2u);
  EXPECT_EQ(run.operations[0].op, "put");
  EXPECT_EQ(run.operations[1].object, "b");
  EXPECT_EQ(run.check.interpenetrating_pairs(), 0);
  const Object& a = run.scene.at(*run.scene.find("a"));
  const Object& b = run.scene.at(*run.scene.find("b"));
  EXPECT_EQ(a.state, ObjectState::Stable);
  EXPECT_NEAR(a.pose.translation.z(), 0.15, 1e-5);
  EXPECT_NEAR(b.pose.translation.z(), 0.25, 1e-5);
}

// A slope of 30 degrees holds a cube with perfect friction, and not at 0.5 < tan 30.
TEST(RunLayout, ObeysRulesOfSettling) {
  BoxSource boxes;
  const std::string turned = "\"rotation\": [0.9659258262890683, 0, 0.25881904510252074, 0]";
  Layout layout = parsed(
      object("slope", "slab.obj", ", \"fixed\": true, \"position\": [0, 0, 0.6], " + turned) + "," +
          object("a", "cube.obj"),
      put_at("a", "[0, 0, 1.2], " + turned));
  RunOptions options;
  const auto height = [&] {
    const LayoutRun run = run_layout(layout, boxes.source(), options);
    EXPECT_TRUE(run.ok());
    EXPECT_EQ(has_finite_friction(run.settle),
              has_finite_friction(settle_options(options, layout.settle)));
    return run.scene.at(*run.scene.find("a")).centre_of_mass().z();
  };
  EXPECT_LT(height(), 0.1);  // by default
  layout.settle.perfect_friction = true;
  EXPECT_GT(height(), 0.6);
  options.rules.perfect_friction = false;  // comes first
  EXPECT_LT(height(), 0.1);
  layout.settle = {};
  options.rules = {};
  options.settle.perfect_friction = true;  // comes last
  EXPECT_GT(height(), 0.6);
  layout.settle.perfect_friction = false;
  EXPECT_LT(height(), 0.1);
}

TEST(RunLayout, ReadsSharedModelOnce) {
  BoxSource boxes;
  std::string objects = kSlab;
  for (int i = 0; i < 50; ++i)
    objects.append(",").append(object(std::to_string(i) + "_o", "cube.obj"));
  const Scene scene = make_scene(parsed(objects), boxes.source(), {});
  EXPECT_EQ(boxes.reads("cube.obj"), 1);
  std::set<const Model*> models;
  std::set<const Shape*> shapes;
  for (const ObjectId id : scene.ids()) {
    models.insert(scene.at(id).model.get());
    shapes.insert(scene.at(id).shape.get());
  }
  EXPECT_EQ(models.size(), 2u);
  EXPECT_EQ(shapes.size(), 2u);
  EXPECT_EQ(scene.at(*scene.find("7_o")).model->path, "cube.obj");
}

TEST(RunLayout, RefusesStartInsideAnotherAndContinues) {
  BoxSource boxes;
  const Layout layout =
      parsed(kSlab + "," + object("a", "cube.obj", ", \"position\": [0, 0, 0.12]") + "," +
                 object("b", "cube.obj") + "," + object("c", "cube.obj"),
             put_at("b", "[0, 0, 0.06]") + "," + put_at("c", "[0, 0, 1]"));
  const LayoutRun run = run_layout(layout, boxes.source(), {});
  EXPECT_FALSE(run.ok());
  ASSERT_EQ(run.operations.size(), 3u);
  EXPECT_EQ(run.operations[0].op, "stand");
  for (int i = 0; i < 2; ++i) {
    const OperationRecord& r = run.operations[i];
    EXPECT_FALSE(r.result.ok());
    EXPECT_NE(r.result.reason().find("\"" + r.object + "\""), std::string::npos)
        << r.result.reason();
    EXPECT_NE(r.result.reason().find("\"slab\""), std::string::npos) << r.result.reason();
  }
  EXPECT_TRUE(run.operations[2].result.ok());
  EXPECT_TRUE(run.check.ok());
  EXPECT_FALSE(run.scene.at(*run.scene.find("a")).placed);
}

TEST(RunLayout, StopsAtRefusalOnRequest) {
  BoxSource boxes;
  const Layout layout =
      parsed(kSlab + "," + object("b", "cube.obj") + "," + object("c", "cube.obj"),
             put_at("b", "[0, 0, 0.06]") + "," + put_at("c", "[0, 0, 1]"));
  RunOptions options;
  options.stop_at_refusal = true;
  const LayoutRun run = run_layout(layout, boxes.source(), options);
  ASSERT_EQ(run.operations.size(), 2u);
  EXPECT_FALSE(run.operations[1].result.ok());
  EXPECT_EQ(run.operations[1].result.reason(),
            "not tried, because put of \"b\" was refused before");
  EXPECT_FALSE(run.scene.at(*run.scene.find("c")).placed);
}

TEST(RunLayout, ReportsAllInterpenetrationsAtStart) {
  BoxSource boxes;
  const Layout layout =
      parsed(kSlab + "," + object("a", "cube.obj", ", \"position\": [0, 0, 0.12]") + "," +
             object("b", "cube.obj", ", \"position\": [0.3, 0, 0.12]"));
  const LayoutRun run = run_start_only(layout, boxes.source(), {});
  EXPECT_FALSE(run.ok());
  EXPECT_EQ(run.check.crossings.size(), 2u);
  EXPECT_GT(run.check.interpenetrating_pairs(), 1);
}

std::string complaint(const Layout& layout, RunOptions options = {}) {
  BoxSource boxes;
  options.layout_file = "a.json";
  try {
    make_scene(layout, boxes.source(), options);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(RunLayout, NamesFirstFailingModelWithAnyThreads) {
  std::string objects = kSlab;
  for (int i = 0; i < 40; ++i)
    objects.append(",").append(object(std::to_string(i) + "_o", std::to_string(i) + "_none.obj"));
  for (const int num_threads : {1, 2, 8}) {
    RunOptions options;
    options.num_threads = num_threads;
    for (int repeat = 0; repeat < 20; ++repeat)
      EXPECT_EQ(complaint(parsed(objects), options),
                "a.json: /objects/1/model: 0_none.obj: no such file");
  }
}

TEST(RunLayout, RefusesObjectsBeyondCoordinateLimit) {
  EXPECT_EQ(complaint(parsed(object("a", "cube.obj", ", \"scale\": 1e15"))), "");
  EXPECT_NE(
      complaint(parsed(object("a", "slab.obj", ", \"scale\": 1e15, \"position\": [9e14, 0, 0]")))
          .find("a.json: /objects/0: \"a\" reaches"),
      std::string::npos);
}

TEST(RunLayout, ReportsProgressInOrder) {
  BoxSource boxes;
  std::vector<std::string> steps;
  RunOptions options;
  options.progress = [&](const Progress& p) { steps.push_back(p.stage + " " + p.item); };
  run_layout(parsed(kSlab + "," + object("a", "cube.obj"), put_at("a", "[0, 0, 1]")),
             boxes.source(), options);
  ASSERT_EQ(steps.size(), 6u);
  EXPECT_EQ(std::set<std::string>(steps.begin(), steps.begin() + 2),
            (std::set<std::string>{"load slab.obj", "load cube.obj"}));
  EXPECT_EQ(steps[2], "stand slab");
  EXPECT_EQ(steps[3], "put a");
}

TEST(RunLayout, TakesUpAxisFromModelUnlessGiven) {
  const ModelSource source = [](const std::string& name, const Tessellation&) {
    Model model = box_model(0.1, 0.2, 0.3);
    model.up = name == "y.glb" ? UpAxis::Y : UpAxis::Z;
    return model;
  };
  const Scene scene = make_scene(parsed(object("a", "y.glb") + "," + object("b", "z.obj") + "," +
                                        object("c", "y.glb", ", \"up\": \"z\"")),
                                 source, {});
  EXPECT_EQ(scene.at(*scene.find("a")).up, UpAxis::Y);
  EXPECT_EQ(scene.at(*scene.find("b")).up, UpAxis::Z);
  EXPECT_EQ(scene.at(*scene.find("c")).up, UpAxis::Z);
}

// A cube that hovers 3 clearances above the slab, as if it had been settled with a larger one: up
// to 2 of them it rests.
LayoutRun hovering(double largest_in_clearances) {
  BoxSource boxes;
  LayoutRun run;
  run.scene = make_scene(parsed(kSlab + "," + object("a", "cube.obj")), boxes.source(), {});
  Transaction transaction(run.scene);
  for (const auto& [name, z] : {std::pair("slab", 0.05), {"a", 0.15}})
    transaction.edit(*run.scene.find(name), [z = z](Object& o) {
      o.pose.translation.z() = z;
      o.placed = true;
    });
  const double usual = default_clearance(run.scene);
  transaction.edit(*run.scene.find("slab"), [&](Object& o) { o.pose.translation.z() += usual; });
  transaction.edit(*run.scene.find("a"), [&](Object& o) { o.pose.translation.z() += 4 * usual; });
  transaction.commit();
  run.largest_clearance = largest_in_clearances * usual;
  finish_run({}, run);
  return run;
}

TEST(RunLayout, JudgesByClearanceOfOperationsWhereItDecides) {
  EXPECT_EQ(hovering(0).check.not_at_rest, std::vector<std::string>{"a"});
  const LayoutRun held = hovering(2);
  EXPECT_TRUE(held.check.ok());
  EXPECT_EQ(held.stability.status, Stability::Status::Stable);
  EXPECT_EQ(held.settle.clearance, held.largest_clearance);
  const LayoutRun hangs = hovering(1.2);
  EXPECT_EQ(hangs.check.not_at_rest, std::vector<std::string>{"a"});
  EXPECT_EQ(hangs.settle.clearance, 0) << "the usual one, where the larger does not help";
  BoxSource boxes;
  const Layout layout = parsed(kSlab + "," + object("a", "cube.obj"), put_at("a", "[0, 0, 1]"));
  const LayoutRun put = run_layout(layout, boxes.source(), {});
  EXPECT_GT(put.largest_clearance, 0);
  EXPECT_EQ(put.settle.clearance, 0);
}

}  // namespace
}  // namespace trivet
