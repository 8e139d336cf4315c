// Joints of URDF and SDF: the cabinet of drawer.xml in the other formats gives the same answers.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/joint_values.h"
#include "core/io/text/file_bytes.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/mend/settle_free.h"

namespace trivet {
namespace {

using namespace trivet::test;

std::string case_text(const std::string& name) {
  return file_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/" + name,
                    1 << 20)
      .value_or("");
}

/// A scene and its values in a folder of their own.
struct ScenePlace {
  TemporaryFolder folder;
  std::string extension;
  OpenedScene opened;
  NewPoses poses;

  ScenePlace(const std::string& format, const std::string& text, const std::string& values)
      : extension(format), opened(open(text, values)) {}
  OpenedScene open(const std::string& text, const std::string& values) {
    write_text(in(), text);
    if (!values.empty()) write_text(joint_values_path(in()), values);
    return open_scene(in(), {});
  }
  std::string in() const { return folder.file("in." + extension); }
  std::string out() const { return folder.file("out." + extension); }
  JointMove move(const std::string& joint, double to) {
    return move_joint_of(opened, joint_named(opened, joint), to, OperationRun({}, {}), poses);
  }
  void settle() {
    for (const SettledObject& o : settle_scene(opened.judged.scene, {}).moved) poses[o.id] = o.to;
  }
  Vec3 at(const std::string& name) const {
    return opened.judged.scene.at(*opened.judged.scene.find(name)).pose.translation;
  }
  OpenedScene written(const std::vector<SceneJoint>& moved) {
    opened.write_with_joints(poses, moved, out());
    return open_scene(out(), {});
  }
};

Vec3 in_scene(const OpenedScene& opened, const std::string& name) {
  return opened.judged.scene.at(*opened.judged.scene.find(name)).pose.translation;
}

bool has_note(const std::vector<Sentence>& notes, const std::string& part) {
  return std::any_of(notes.begin(), notes.end(), [&](const Sentence& note) {
    return in_english(note).find(part) != std::string::npos;
  });
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A format with the names that it gives, and the direction in which its drawer opens.
struct Format {
  const char* extension;
  std::string prefix, drawer;
  Vec3 opens, closed, hinge;
};

class JointsOfFormats : public testing::TestWithParam<Format> {
 protected:
  std::string slide() const { return GetParam().prefix + "slide"; }
  std::string lid() const { return GetParam().prefix + "lid"; }
  std::string file() const { return std::string("drawer.") + GetParam().extension; }
  std::string values() const { return case_text(file() + ".joints.json"); }
};

TEST_P(JointsOfFormats, AreReadWithLimitsAndValues) {
  ScenePlace place(GetParam().extension, case_text(file()), values());
  ASSERT_EQ(place.opened.joints.size(), 2u);
  EXPECT_EQ(place.opened.num_joints, 2u);
  const SceneJoint& drawer = joint_named(place.opened, slide());
  EXPECT_FALSE(drawer.turns);
  EXPECT_EQ(drawer.value, 0.2);
  EXPECT_EQ(drawer.lower, 0);
  EXPECT_EQ(drawer.upper, 0.3);
  EXPECT_LT((drawer.axis - GetParam().opens).norm(), 1e-15);
  EXPECT_LT((place.at(GetParam().drawer) - GetParam().closed - 0.2 * GetParam().opens).norm(),
            1e-15);
  const SceneJoint& hinge = joint_named(place.opened, lid());
  EXPECT_TRUE(hinge.turns);
  EXPECT_EQ(hinge.value, 0);
  EXPECT_NEAR(hinge.upper, 90, 1e-12);
  EXPECT_LT((hinge.anchor - GetParam().hinge).norm(), 1e-15);
  EXPECT_TRUE(has_note(place.opened.notes, "the values of joints are those of"));
}

TEST_P(JointsOfFormats, WithoutValuesTheyAreClosed) {
  ScenePlace place(GetParam().extension, case_text(file()), "");
  EXPECT_EQ(joint_named(place.opened, slide()).value, 0);
  EXPECT_LT((place.at(GetParam().drawer) - GetParam().closed).norm(), 1e-15);
  EXPECT_FALSE(has_note(place.opened.notes, "the values of joints"));
}

TEST_P(JointsOfFormats, ADrawerClosesWithItsContents) {
  ScenePlace place(GetParam().extension, case_text(file()), values());
  place.settle();
  const Vec3 before = place.at("cube");
  EXPECT_NEAR(before.z(), place.at(GetParam().drawer).z() - 0.1 + 0.005 + 0.03, 1e-4);
  const JointMove move = place.move(slide(), 0);
  EXPECT_EQ(move.end, JointMove::End::Reached);
  ASSERT_EQ(move.carried.size(), 1u);
  EXPECT_LT((place.at("cube") - before + 0.2 * GetParam().opens).norm(), 1e-12);
  OpenedScene again = place.written({joint_named(place.opened, slide())});
  EXPECT_EQ(joint_named(again, slide()).value, 0);
  EXPECT_LT((in_scene(again, "cube") - place.at("cube")).norm(), 1e-12);
  EXPECT_LT((in_scene(again, GetParam().drawer) - GetParam().closed).norm(), 1e-12);
  EXPECT_TRUE(judge(again, {}).ok()) << verdict_text(judge(again, {}));
}

TEST_P(JointsOfFormats, ALidStopsAtItsLimit) {
  ScenePlace place(GetParam().extension, case_text(file()), values());
  EXPECT_EQ(place.move(lid(), 120).end, JointMove::End::Limit);
  const std::string name = GetParam().prefix + "lid";
  const ObjectId id = *place.opened.judged.scene.find(name);
  EXPECT_NEAR(place.opened.judged.scene.world_box(id).upper.z(), GetParam().hinge.z() + 0.4, 1e-7);
  OpenedScene again = place.written(place.opened.joints);
  EXPECT_NEAR(joint_named(again, lid()).value, 90, 1e-12);
  EXPECT_EQ(joint_named(again, slide()).value, 0.2);
}

TEST_P(JointsOfFormats, ValuesStandBesideAndTheFileStaysEqual) {
  ScenePlace place(GetParam().extension, case_text(file()), values());
  place.move(slide(), 0.1);
  place.poses.clear();  // of the links: they have no pose of their own
  place.written({joint_named(place.opened, slide())});
  EXPECT_EQ(file_bytes(place.out(), 1 << 20), case_text(file()));
  const JointValues values = read_joint_values(joint_values_path(place.out()));
  EXPECT_EQ(values.at(slide()), 0.1);
  EXPECT_EQ(values.at(lid()), 0);
  // Without a move the values go along; old ones of another file do not stay.
  place.opened.write({}, place.folder.file("same." + place.extension));
  EXPECT_EQ(joint_values_path(place.folder.file("same")), place.folder.file("same.joints.json"));
  EXPECT_EQ(read_joint_values(joint_values_path(place.folder.file("same." + place.extension)))
                .at(slide()),
            0.2);
}

TEST_P(JointsOfFormats, BadValuesAreRefused) {
  const auto error = [&](const std::string& values) {
    return error_of([&] { ScenePlace(GetParam().extension, case_text(file()), values); });
  };
  EXPECT_NE(error("{\"door\": 1}").find("\"door\" is no slide or hinge"), std::string::npos);
  EXPECT_NE(error("{\"" + slide() + "\": \"x\"}").find("is of type string"), std::string::npos);
  EXPECT_NE(error("{\"" + slide() + "\": 1e7}").find("numbers up to"), std::string::npos);
  EXPECT_NE(error("[1]").find("{\"joint\": number"), std::string::npos);
  EXPECT_NE(error("{").find("joints.json"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, JointsOfFormats,
                         testing::Values(Format{"urdf", "", "drawer", Vec3(0, -1, 0),
                                                Vec3(0, -0.01, 0.2), Vec3(0, 0.2, 0.43)},
                                         Format{"sdf", "unit::", "unit::drawer", Vec3(1, 0, 0),
                                                Vec3(2, 0, 0.2), Vec3(1.8, 0, 0.43)}),
                         [](const auto& one) { return std::string(one.param.extension); });

std::string robot(const std::string& links, const std::string& joints) {
  std::string out = "<robot name='r'>";
  for (const char c : links)
    out += std::string("<link name='") + c +
           "'><inertial><origin xyz='0.5 0 0'/><mass value='1'/></inertial><collision><origin "
           "xyz='0.5 0 0'/>"
           "<geometry><box size='1 0.6 0.02'/></geometry></collision></link>";
  return out + joints + "</robot>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& inside) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='a'/><child link='" + name +
         "'/><origin xyz='0 0 1'/>" + inside + "</joint>";
}

TEST(JointsOfUrdf, ThatMimicAreHeldWithTheReason) {
  const std::string text =
      robot("abc", joint("b", "prismatic", "<axis xyz='0 0 1'/><limit lower='0' upper='1'/>") +
                       joint("c", "prismatic",
                             "<axis xyz='0 0 1'/><limit lower='0' upper='1'/>"
                             "<mimic joint='b' multiplier='2' offset='3'/>"));
  ScenePlace place("urdf", text, "{\"b\": 0.5}");
  EXPECT_EQ(joint_named(place.opened, "c").value, 4);
  EXPECT_EQ(place.at("c").z(), 5);
  EXPECT_EQ(place.at("b").z(), 1.5);
  EXPECT_NE(error_of([&] { place.move("b", 0); }).find("\"c\" follows it"), std::string::npos);
  EXPECT_NE(error_of([&] { place.move("c", 0); }).find("it follows \"b\""), std::string::npos);
  EXPECT_NE(error_of([&] { ScenePlace("urdf", text, "{\"c\": 0.5}"); }).find("it follows \"b\""),
            std::string::npos);
}

TEST(JointsOfUrdf, ContinuousOnesTurnWithoutEnd) {
  ScenePlace place("urdf",
                   robot("ab", joint("b", "continuous",
                                     "<axis xyz='0 0 1'/>"
                                     "<limit effort='1' velocity='1'/>")),
                   "");
  EXPECT_EQ(place.move("b", 400).end, JointMove::End::Reached);
  EXPECT_NEAR(joint_named(place.opened, "b").value, 400, 1e-12);
  OpenedScene again = place.written(place.opened.joints);
  EXPECT_NEAR(joint_named(again, "b").value, 400, 1e-12);
}

TEST(JointsOfUrdf, OtherKindsAreNamedAndStay) {
  for (const char* type : {"planar", "spherical"}) {
    ScenePlace place("urdf", robot("ab", joint("b", type, "")), "");
    EXPECT_TRUE(place.opened.joints.empty());
    EXPECT_TRUE(has_note(place.opened.notes, std::string("is of type ") + type)) << type;
    EXPECT_EQ(place.at("b").z(), 1);
  }
}

// A trapdoor of 1 kg and 1 m.
TEST(JointsOfUrdf, LinksThatGravityMovesAreNamed) {
  const auto notes = [](const std::string& inside) {
    return ScenePlace("urdf", robot("ab", joint("b", "revolute", inside)), "").opened.notes;
  };
  const std::string turning = "<axis xyz='0 1 0'/><limit lower='-1' upper='1'/>";
  EXPECT_TRUE(has_note(notes(turning), "its weight turns it with 4.90332 N m"));
  EXPECT_FALSE(has_note(notes("<axis xyz='0 1 0'/><limit lower='-1' upper='0'/>"), "would swing"));
  EXPECT_FALSE(has_note(notes(turning + "<dynamics friction='5'/>"), "would swing"));
  EXPECT_FALSE(has_note(notes("<axis xyz='0 0 1'/><limit lower='-1' upper='1'/>"), "would swing"));
}

TEST(JointsOfUrdf, ALinkBelowALinkGoesAlong) {
  const std::string text = robot(
      "abc", joint("b", "revolute", "<axis xyz='0 0 1'/><limit lower='-2' upper='2'/>") +
                 "<joint name='c' type='prismatic'><parent link='b'/><child link='c'/>"
                 "<origin xyz='1 0 1'/><axis xyz='1 0 0'/><limit lower='0' upper='1'/></joint>");
  ScenePlace place("urdf", text, "");
  place.move("b", 90);
  EXPECT_LT((joint_named(place.opened, "c").axis - Vec3(0, 1, 0)).norm(), 1e-15);
  place.move("c", 0.5);
  EXPECT_LT((place.at("c") - Vec3(0, 1.5, 2)).norm(), 1e-12);
  const OpenedScene again = place.written(place.opened.joints);
  EXPECT_LT((in_scene(again, "c") - Vec3(0, 1.5, 2)).norm(), 1e-12);
}

std::string sdf_model(const std::string& version, const std::string& joints) {
  std::string out = "<sdf version='" + version + "'><model name='m'><pose>0 0 0 0 0 0</pose>";
  for (const char* link : {"a", "b", "c"})
    out +=
        std::string("<link name='") + link +
        "'><pose>0 0 1 0 0 1.5707963267948966</pose><collision name='c'><geometry><box><size>1 1 "
        "1</size></box></geometry></collision></link>";
  return out + joints + "</model></sdf>";
}

TEST(JointsOfSdf, AxesAreInTheFrameThatTheVersionSays) {
  const auto axis = [](const std::string& version, const std::string& xyz) {
    ScenePlace place("sdf",
                     sdf_model(version,
                               "<joint name='j' type='prismatic'><parent>a</parent>"
                               "<child>b</child><axis>" +
                                   xyz + "</axis></joint>"),
                     "");
    return joint_named(place.opened, "m::j").axis;
  };
  EXPECT_LT((axis("1.9", "<xyz>1 0 0</xyz>") - Vec3(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((axis("1.4", "<xyz>1 0 0</xyz>") - Vec3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((axis("1.9", "<xyz expressed_in='__model__'>1 0 0</xyz>") - Vec3(1, 0, 0)).norm(),
            1e-15);
  EXPECT_LT((axis("1.6", "<use_parent_model_frame>1</use_parent_model_frame><xyz>1 0 0</xyz>") -
             Vec3(1, 0, 0))
                .norm(),
            1e-15);
}

TEST(JointsOfSdf, ChainsThatCloseAreHeld) {
  const auto one = [](const std::string& name, const std::string& parent,
                      const std::string& child) {
    return "<joint name='" + name + "' type='revolute'><parent>" + parent + "</parent><child>" +
           child +
           "</child><axis><xyz>0 0 1</xyz><limit><lower>-1e16</lower></limit></axis></joint>";
  };
  ScenePlace ring(
      "sdf", sdf_model("1.9", one("1", "a", "b") + one("2", "b", "c") + one("3", "c", "a")), "");
  EXPECT_EQ(ring.opened.joints.size(), 3u);
  EXPECT_NE(error_of([&] { ring.move("m::2", 10); }).find("closes a chain"), std::string::npos);
  ScenePlace two("sdf", sdf_model("1.9", one("1", "a", "c") + one("2", "b", "c")), "");
  EXPECT_NE(error_of([&] { two.move("m::1", 10); }).find("closes a chain"), std::string::npos);
  ScenePlace world("sdf", sdf_model("1.9", one("1", "world", "b") + one("2", "d", "c")), "");
  EXPECT_TRUE(has_note(world.opened.notes, "not between links of one model"));
  EXPECT_EQ(world.opened.joints.size(), 1u);
}

}  // namespace
}  // namespace trivet
