// Output of programs that simulated an export, and reasons why objects moved.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/layout/boxes.h"
#include "ops/simulation/simulate.h"

namespace trivet {
namespace {

/// Two boxes on the floor, the second one on the first, as an export without files.
struct Stacked {
  Scene scene;
  SimulationExport done;

  Stacked() {
    add("lower one", 0.1);
    add("upper", 0.3);
    update_contacts(scene, 1e-6);
    done = simulation_of(scene, "s", {});
    const std::vector<std::string> names{"lower_one", "upper"};
    for (size_t i = 0; i < names.size(); ++i) done.scene.bodies[i].file_name = names[i];
  }
  void add(const char* name, double z) {
    const Model model = box_model(0.1, 0.1, 0.1);
    Object object;
    object.name = name;
    object.model = std::make_shared<const Model>(model);
    object.shape = make_shape(model.mesh);
    object.pose.translation = Vec3(0, 0, z), object.placed = true;
    object.state = ObjectState::Stable;
    scene.add(std::move(object));
  }
  SimulatedScene program(const std::string& output) const {
    return simulated_by_program(output, "engine", done, 2);
  }
};

const std::string kPoses =
    R"("objects": [{"name": "upper", "position": [0.003, 0, 0.3], "rotation": [1, 0, 0, 0]},
      {"name": "lower_one", "position": [0, 0, 0.1], "rotation": [-1, 0, 0, 0]}])";

std::string without_newlines(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string refusal(const Stacked& stacked, const std::string& output) {
  try {
    stacked.program(output);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::BadInput);
    return error.what();
  }
  return "";
}

TEST(Program, TellsPosesByNamesOfFile) {
  const Stacked stacked;
  const SimulatedScene out = stacked.program(
      "loading\n{" + without_newlines(kPoses) +
      R"(, "simulator": "Engine 4", "penetration": 2e-6, "warnings": 3, "contacts": [["lower_one", "floor"]]})" +
      "\nbye\n");
  EXPECT_EQ(out.simulator, "Engine 4");
  EXPECT_EQ(out.seconds, 2);
  EXPECT_EQ(out.penetration, 2e-6);
  EXPECT_EQ(out.num_warnings, 3);
  ASSERT_EQ(out.objects.size(), 2u);
  EXPECT_EQ(out.objects[0].name, "lower one");
  EXPECT_NEAR(out.objects[0].moved, 0, 1e-6);
  EXPECT_NEAR(out.objects[0].turned_deg, 0, 1e-5);  // -q is q
  EXPECT_NEAR(out.objects[1].moved, 0.003, 1e-6);
  const StayedWithin stayed = stayed_within(out);
  EXPECT_EQ(stayed.millimetre, 1u);
  EXPECT_EQ(stayed.two_millimetres_and_degrees, 1u);
  EXPECT_EQ(stayed.centimetre, 2u);
  ASSERT_TRUE(out.touched);
  EXPECT_TRUE(out.touched->contains({"lower one", "floor"}));
}

TEST(Program, IsRefusedForOtherOutput) {
  const Stacked stacked;
  EXPECT_NE(refusal(stacked, "").find("prints no line of JSON"), std::string::npos);
  EXPECT_NE(refusal(stacked, "{").find("engine"), std::string::npos);
  EXPECT_NE(refusal(stacked, R"({"objects": []})").find("no object is called \"lower_one\""),
            std::string::npos);
  for (const char* bad :
       {R"({"objects": 3})", R"({"objects": [{"name": "upper"}]})",
        R"({"objects": [{"name": "upper", "position": [0, 0], "rotation": [1, 0, 0, 0]}]})",
        R"({"objects": [{"name": "upper", "position": [0, 0, 0], "rotation": [0, 0, 0, 0]}]})",
        R"({"objects": [{"name": "upper", "position": ["a", 0, 0], "rotation": [1, 0, 0, 0]}]})"})
    EXPECT_NE(refusal(stacked, bad), "") << bad;
  EXPECT_NE(refusal(stacked, "{" + without_newlines(kPoses) + R"(, "contacts": [["a"]]})"), "");
}

TEST(Reasons, NameMissedContacts) {
  Stacked stacked;
  SimulatedScene out = stacked.program("{" + without_newlines(kPoses) +
                                       R"(, "contacts": [["floor", "lower_one"]]})");
  add_reasons(out, stacked.done, stacked.scene, {});
  EXPECT_TRUE(out.objects[0].why.empty());  // it stayed
  EXPECT_EQ(in_english(out.objects[1].why),
            (std::vector<std::string>{"the simulator finds no contact with \"lower one\""}));
  EXPECT_NE(simulated_text(out).find("finds no contact"), std::string::npos);
}

TEST(Reasons, AreUnknownWhereNothingIsFound) {
  Stacked stacked;
  SimulatedScene out = stacked.program("{" + without_newlines(kPoses) + "}");
  add_reasons(out, stacked.done, stacked.scene, {});
  EXPECT_TRUE(out.objects[1].why.empty());
  EXPECT_NE(simulated_text(out).find("it is not known why"), std::string::npos);
}

TEST(Reasons, NameOverlapsWeaknessAndNeighbours) {
  Stacked stacked;
  stacked.done.overlaps.push_back({"lower one", "upper", 0, 1, 0.25, 1, 1});
  SimulatedScene out = stacked.program("{" + without_newlines(kPoses) + "}");
  out.objects[0].moved = 1;
  edit_object(stacked.scene, *stacked.scene.find("upper"),
              [](Object& o) { o.pose.translation.x() += 0.0999; });
  update_contacts(stacked.scene, 1e-6);
  add_reasons(out, stacked.done, stacked.scene, {});
  const std::vector<std::string> why = in_english(out.objects[1].why);
  ASSERT_EQ(why.size(), 3u);
  EXPECT_EQ(why[0], "its convex parts overlap those of \"lower one\" by 0.25 metres");
  EXPECT_NE(why[1].find("it stands, but only just: margin"), std::string::npos);
  EXPECT_EQ(why[2], "it touches \"lower one\", which moved, too");
}

// The sides of both boxes may lie in one plane, which adds no contact.
TEST(Reasons, TellWhatDoesNotStand) {
  for (const double aside : {0.01, 0.0}) {
    Stacked stacked;
    SimulatedScene out = stacked.program("{" + without_newlines(kPoses) + "}");
    edit_object(stacked.scene, *stacked.scene.find("upper"),
                [&](Object& o) { o.pose.translation += Vec3(0.15, aside, 0); });
    update_contacts(stacked.scene, 1e-6);
    add_reasons(out, stacked.done, stacked.scene, {});
    EXPECT_EQ(in_english(out.objects[1].why), std::vector<std::string>{"it does not stand"});
  }
}

// Each of three equal boxes in a stack carries those above it.
TEST(Loads, CountAllThatIsCarried) {
  Stacked stacked;
  EXPECT_NEAR(stacked.done.scene.heaviest_load, 1, 1e-9);
  stacked.add("third", 0.5);
  update_contacts(stacked.scene, 1e-6);
  EXPECT_NEAR(simulation_of(stacked.scene, "s", {}).scene.heaviest_load, 2, 1e-9);
  edit_object(stacked.scene, *stacked.scene.find("lower one"), [](Object& o) { o.fixed = true; });
  EXPECT_NEAR(simulation_of(stacked.scene, "s", {}).scene.heaviest_load, 1, 1e-9);
}

}  // namespace
}  // namespace trivet
