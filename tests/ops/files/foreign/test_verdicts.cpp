// Scenes of other programs judged: known findings, depths and heights.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/foreign/pair_table.h"

namespace trivet {
namespace {

using namespace trivet::test;
using Kind = SceneFinding::Kind;

SceneVerdict verdict_of_text(const std::string& text, const std::string& name = "scene.xml") {
  const TemporaryFolder folder;
  write_text(folder.file(name), text);
  OpenedScene opened = open_scene(folder.file(name), {});
  return judge(opened, {});
}

std::string boxes(const std::string& bodies, const std::string& more = "") {
  return "<mujoco><default><geom type='box' size='0.05 0.05 0.05'/></default><worldbody>"
         "<geom name='ground' type='plane' size='1 1 1'/>" +
         bodies + "</worldbody>" + more + "</mujoco>";
}

std::string box(const std::string& name, const std::string& pos, const std::string& geom = "") {
  return "<body name='" + name + "' pos='" + pos + "'><freejoint/><geom " + geom + "/></body>";
}

TEST(Verdicts, ABoxFlushOnThePlaneIsOk) {
  const SceneVerdict v = verdict_of_text(boxes(box("a", "0 0 0.05")));
  EXPECT_TRUE(v.ok()) << verdict_text(v);
  EXPECT_TRUE(v.whole());
  EXPECT_EQ(v.num_free, 1u);
}

TEST(Verdicts, AFileWithoutCollidersSaysSo) {
  const SceneVerdict v = verdict_of_text("<mujoco/>");
  EXPECT_TRUE(v.ok());
  ASSERT_EQ(v.notes.size(), 1u);
  EXPECT_EQ(v.notes[0].text, "no body of the file collides");
}

TEST(Verdicts, ASunkBoxHasItsDepth) {
  const SceneVerdict v = verdict_of_text(boxes(box("a", "0 0 0.047")));
  ASSERT_EQ(v.findings.size(), 1u) << verdict_text(v);
  EXPECT_EQ(v.findings[0].kind, Kind::PassesThrough);
  EXPECT_EQ(v.findings[0].other, "floor");
  EXPECT_NEAR(v.findings[0].metres, 0.003, 1e-9);
}

TEST(Verdicts, AFloatingBoxHasItsHeight) {
  const SceneVerdict v = verdict_of_text(boxes(box("a", "0 0 0.06")));
  ASSERT_EQ(v.findings.size(), 1u) << verdict_text(v);
  EXPECT_EQ(v.findings[0].kind, Kind::Floats);
  EXPECT_NEAR(v.findings[0].metres, 0.01, 1e-6);
}

// Three balls that touch, and one on them.
TEST(Verdicts, BallsThatLieExactlyAreOkHoweverTheyAreTurned) {
  const double r = 0.035, d = 2 * r / std::sqrt(3);
  std::string bodies;
  const auto add = [&](const Vec3& at, const char* quat) {
    std::ostringstream text;
    text.precision(17);
    text << "<body pos='" << at.x() << ' ' << at.y() << ' ' << at.z() << "' quat='" << quat
         << "'><freejoint/><geom type='sphere' size='0.035'/></body>";
    bodies += text.str();
  };
  add({d, 0, r}, "1 2 3 4");
  add({-d / 2, r, r}, "0.3 -2 1 0.4");
  add({-d / 2, -r, r}, "-1 0.1 0.7 2");
  add({0, 0, r + std::sqrt(4 * r * r - d * d)}, "0.2 1 -1 0.5");
  const SceneVerdict v = verdict_of_text(boxes(bodies));
  EXPECT_TRUE(v.ok()) << verdict_text(v);
}

TEST(Verdicts, APlaneAnywhereIsTheFloor) {
  std::string text = boxes(box("a", "0 0 1.25"));
  text.replace(text.find("type='plane'"), 12, "type='plane' pos='0 0 1.2'");
  EXPECT_TRUE(verdict_of_text(text).ok());
}

TEST(Verdicts, ATiltedPlaneCarriesWhatItsFrictionHolds) {
  const auto on_slope = [](const char* friction) {
    // A plane tilted by 20 degrees about y; the box lies flat on it.
    return std::string(
               "<mujoco><worldbody><geom type='plane' size='1 1 1' euler='0 20 0'/>"
               "<body name='a' euler='0 20 0' pos='") +
           "0.017101007166283437 0 0.046984631039295424'><freejoint/><geom type='box' size='0.05 "
           "0.05 0.05' friction='" +
           friction + "'/></body></worldbody></mujoco>";
  };
  // MuJoCo takes the larger friction of a pair: the plane's 1 holds either.
  EXPECT_TRUE(verdict_of_text(on_slope("0.1")).ok());
  std::string slippery = on_slope("0.1");
  slippery.replace(slippery.find("type='plane'"), 12, "type='plane' friction='0.2'");
  const SceneVerdict v = verdict_of_text(slippery);
  ASSERT_EQ(v.findings.size(), 1u) << verdict_text(v);
  EXPECT_EQ(v.findings[0].kind, Kind::NotAtRest);
}

TEST(Verdicts, BitsAndExcludesKeepPairsApart) {
  const std::string both = box("a", "0 0 0.05") + box("b", "0.05 0 0.05");
  EXPECT_EQ(verdict_of_text(boxes(both)).count(Kind::PassesThrough), 1u);
  EXPECT_TRUE(
      verdict_of_text(boxes(both, "<contact><exclude body1='a' body2='b'/></contact>")).ok());
  EXPECT_TRUE(verdict_of_text(boxes(box("a", "0 0 0.05", "contype='2' conaffinity='1'") +
                                    box("b", "0.05 0 0.05", "contype='2' conaffinity='1'")))
                  .ok());
}

TEST(Verdicts, ABodyThatDoesNotMeetTheFloorFalls) {
  const SceneVerdict v =
      verdict_of_text(boxes(box("a", "0 0 0.05", "contype='2' conaffinity='2'")));
  ASSERT_EQ(v.findings.size(), 1u);
  EXPECT_EQ(v.findings[0].kind, Kind::Floats);
  EXPECT_TRUE(v.findings[0].other.empty());
}

TEST(Verdicts, TheCentreThatAFileGivesDecides) {
  const auto edge = [](const char* inertial) {
    return boxes(
        "<body name='table' pos='0 0 0.2'><geom size='0.2 0.2 0.2'/></body>"
        "<body name='a' pos='0.22 0 0.45'><freejoint/>" +
        std::string(inertial) + "<geom/></body>");
  };
  EXPECT_EQ(verdict_of_text(edge("")).findings.size(), 1u);
  EXPECT_TRUE(
      verdict_of_text(edge("<inertial pos='-0.04 0 0' mass='1' diaginertia='0.01 0.01 0.01'/>"))
          .ok());
}

TEST(Verdicts, LinksInJointsAreHeld) {
  const SceneVerdict v = verdict_of_text(
      boxes("<body name='arm' pos='0 0 1'><joint type='hinge' axis='0 1 0'/><geom/></body>"));
  EXPECT_TRUE(v.ok());
  EXPECT_EQ(v.num_joints, 1u);
}

TEST(Verdicts, WhatIsNotReadMakesThemPartial) {
  const SceneVerdict v =
      verdict_of_text(boxes("<body pos='0 0 0.5'><geom type='hfield' hfield='h'/></body>"));
  EXPECT_FALSE(v.whole());
  EXPECT_NE(verdict_text(v).find("judged in part"), std::string::npos);
}

TEST(Verdicts, AreALineOfJsonAndARow) {
  const SceneVerdict v = verdict_of_text(boxes(box("a", "0 0 0.047") + box("b", "1 0 0.06")));
  const std::string json = verdict_json(v);
  EXPECT_EQ(json.find('\n'), std::string::npos);
  EXPECT_NE(json.find("\"kind\":\"passes through\",\"object\":\"a\",\"other\":\"floor\""),
            std::string::npos)
      << json;
  EXPECT_NE(verdict_table({v, v}).find("2 scenes: 0 ok; 2 pairs interpenetrate, 2 objects float"),
            std::string::npos)
      << verdict_table({v, v});
}

TEST(Verdicts, TellTheThreeClassesOfPairs) {
  const SceneVerdict v = verdict_of_text(
      boxes(box("a", "0 0 0.047") + box("b", "1 0 0.05") + box("c", "2 0 0.05000001")));
  EXPECT_EQ(v.pairs.num_through, 1u);
  EXPECT_EQ(v.pairs.touching.size(), 2u);
  EXPECT_EQ(v.pairs.num_apart, 3u);
  EXPECT_EQ(v.num_flush(), 1u);
  EXPECT_NE(verdict_text(v).find("pairs: 1 passes through, 2 touch or are closer than 4 um, 3 are "
                                 "apart"),
            std::string::npos)
      << verdict_text(v);
  EXPECT_NE(
      verdict_json(v).find("\"pairs\":{\"passing_through\":1,\"touching\":2,\"apart\":3},"
                           "\"touching\":[{\"object\":\"b\",\"other\":\"floor\",\"gap\":0.0}"),
      std::string::npos)
      << verdict_json(v);
}

// A file of others does not say by which clearance it was settled: its scene was larger then.
TEST(Verdicts, ASceneThatHasShrunkStillStands) {
  const double clearance = verdict_of_text(boxes(box("a", "0 0 0.05"))).clearance;
  const auto raised = [&](double clearances) {
    char pos[60];
    std::snprintf(pos, sizeof pos, "0 0 %.17g", 0.05 + clearances * clearance);
    return verdict_of_text(boxes(box("a", pos)));
  };
  EXPECT_TRUE(raised(6).ok()) << verdict_text(raised(6));
  EXPECT_FALSE(raised(40).ok());
  EXPECT_EQ(raised(40).count(Kind::Floats), 1u);
}

// MuJoCo lifts what touches until its margin is free.
TEST(Verdicts, WhatIsNearerThanItsMarginIsNamed) {
  const auto raised = [](double gap, double margin) {
    char pos[60], geom[60];
    std::snprintf(pos, sizeof pos, "0 0 %.17g", 0.05 + gap);
    std::snprintf(geom, sizeof geom, "margin='%g' type='box'", margin);
    std::string text = boxes(box("a", pos) + box("b", "1 0 0.0502"));
    text.replace(text.find("type='box'"), 10, geom);
    return verdict_of_text(text);
  };
  const SceneVerdict touching = raised(0, 1e-4);
  EXPECT_TRUE(touching.ok()) << verdict_text(touching);
  ASSERT_EQ(touching.notes.size(), 1u) << verdict_text(touching);
  EXPECT_EQ(in_english(touching.notes[0]),
            "pairs nearer to each other than the file's margins: 1, by up to 0.2 mm; their engine "
            "moves them apart");
  EXPECT_TRUE(raised(2e-4, 1e-4).ok());
  EXPECT_TRUE(raised(2e-4, 1e-4).notes.empty());
  // Larger ones are no clearance of a scene of a metre.
  const SceneVerdict coarse = raised(0, 1e-3);
  ASSERT_EQ(coarse.notes.size(), 1u) << verdict_text(coarse);
  EXPECT_NE(in_english(coarse.notes[0]).find("too large"), std::string::npos);
  EXPECT_LT(coarse.clearance, 1e-4);
}

TEST(PairTable, FrictionFollowsTheEngine) {
  const ContactBits a{1, 1, 0.2, 0, 0}, b{1, 1, 0.7, 0, 0}, first{1, 1, 0.1, 1, 0};
  EXPECT_EQ(pair_friction(a, b, FrictionRule::Larger), 0.7);
  EXPECT_EQ(pair_friction(a, b, FrictionRule::Smaller), 0.2);
  EXPECT_DOUBLE_EQ(pair_friction(a, b, FrictionRule::Product), 0.14);
  EXPECT_EQ(pair_friction(first, b, FrictionRule::Larger), 0.1);
}

// A box on a slope of 20 degrees, whose tangent is 0.364.
std::string slope(const std::string& above, const std::string& below, const std::string& more) {
  return "<mujoco><worldbody><body euler='0 20 0'><geom type='box' size='1 1 0.1' pos='0 0 -0.1' "
         "friction='" +
         below + "' " + more +
         "/></body><body name='b' euler='0 20 0' pos='0.0171010071662834 0 0.0469846310392954'>"
         "<freejoint/><geom type='box' size='0.05 0.05 0.05' friction='" +
         above + "'/></body></worldbody></mujoco>";
}

bool holds(EngineRules rules, const std::string& text, const std::string& name = "scene.xml") {
  const TemporaryFolder folder;
  write_text(folder.file(name), text);
  OpenOptions options;
  options.foreign.rules = rules;
  OpenedScene opened = open_scene(folder.file(name), options);
  return judge(opened, {}).ok();
}

TEST(EngineRules, FrictionCountsByTheEngineThatIsNamed) {
  const std::string unlike = slope("0.5", "0.3", "");
  EXPECT_TRUE(holds(EngineRules::OfFormat, unlike));
  EXPECT_TRUE(holds(EngineRules::Mujoco, unlike));
  EXPECT_FALSE(holds(EngineRules::Gazebo, unlike));
  EXPECT_FALSE(holds(EngineRules::Trivet, unlike));
  const std::string alike = slope("0.5", "0.5", "");
  EXPECT_TRUE(holds(EngineRules::Gazebo, alike));
  EXPECT_FALSE(holds(EngineRules::Bullet, alike));
}

TEST(EngineRules, PrioritiesAreMujocosAlone) {
  const std::string slippery = slope("0.5", "0.1", "priority='1'");
  EXPECT_FALSE(holds(EngineRules::Mujoco, slippery));
  const std::string rough = slope("0.1", "0.5", "priority='1'");
  EXPECT_TRUE(holds(EngineRules::OfFormat, rough));
  EXPECT_FALSE(holds(EngineRules::Gazebo, rough));
}

// URDF has no friction; Bullet and Gazebo each add theirs.
TEST(EngineRules, UrdfHasWhatItsEngineAdds) {
  const auto robot = [](const std::string& contact, const std::string& more) {
    return "<robot name='r'><link name='world'/><link name='slope'>" + contact +
           "<collision><origin xyz='0 0 -0.1'/><geometry><box size='2 2 0.2'/></geometry>"
           "</collision></link><link name='b'>" +
           contact +
           "<collision><geometry><box size='0.1 0.1 0.1'/></geometry></collision></link>"
           "<joint name='s' type='fixed'><parent link='world'/><child link='slope'/>"
           "<origin rpy='0 0.3490658503988659 0'/></joint>"
           "<joint name='f' type='floating'><parent link='world'/><child link='b'/><origin "
           "xyz='0.0171010071662834 0 0.0469846310392954' rpy='0 0.3490658503988659 0'/></joint>" +
           more + "</robot>";
  };
  EXPECT_FALSE(holds(EngineRules::OfFormat, robot("", ""), "r.urdf"));
  EXPECT_TRUE(holds(EngineRules::Mujoco, robot("", ""), "r.urdf"));
  EXPECT_TRUE(holds(EngineRules::Gazebo, robot("", ""), "r.urdf"));
  EXPECT_TRUE(holds(EngineRules::Trivet, robot("", ""), "r.urdf"));
  const std::string rough = "<contact><lateral_friction value='0.7'/></contact>";
  EXPECT_TRUE(holds(EngineRules::OfFormat, robot(rough, ""), "r.urdf"));
  EXPECT_TRUE(holds(EngineRules::Bullet, robot(rough, ""), "r.urdf"));
  for (const std::string smooth : {"<mu1>0.1</mu1>", "<mu1 value='0.1'/>"})
    EXPECT_FALSE(holds(EngineRules::Gazebo,
                       robot(rough, "<gazebo reference='b'>" + smooth + "</gazebo>"), "r.urdf"));
}

TEST(Verdicts, WhatIsLeftWhenTheTimeIsOverIsNamed) {
  const TemporaryFolder folder;
  write_text(folder.file("s.xml"), boxes(box("a", "0 0 0.05") + box("b", "0 0 0.149")));
  OpenedScene opened = open_scene(folder.file("s.xml"), {});
  RunOptions options;
  EXPECT_TRUE(judge(opened, options).whole());
  options.verdict_seconds = 1e-9;
  const SceneVerdict v = judge(opened, options);
  EXPECT_FALSE(v.whole());
  EXPECT_EQ(v.unread.size(), 3u);  // pairs, rest, the whole
  EXPECT_NE(verdict_text(v).find("not judged: whether pairs interpenetrate, of 1"),
            std::string::npos)
      << verdict_text(v);
  EXPECT_NE(verdict_text(v).find("(judged in part)"), std::string::npos);
}

// Facts about a shape are then found once, for however many bodies.
TEST(Verdicts, BodiesThatAreAlikeShareTheirShape) {
  const TemporaryFolder folder;
  write_text(folder.file("s.xml"), boxes(box("a", "0 0 0.05") + box("b", "1 0 0.05", "mass='2'") +
                                         box("c", "0 1 0.05", "size='0.05 0.05 0.06'") +
                                         box("d", "1 1 0.05") + box("e", "2 1 0.05", "mass='2'")));
  const OpenedScene opened = open_scene(folder.file("s.xml"), {});
  const Scene& scene = opened.judged.scene;
  const auto of = [&](const char* name) -> const Object& { return scene.at(*scene.find(name)); };
  EXPECT_EQ(of("a").shape, of("d").shape);
  EXPECT_EQ(of("b").shape, of("e").shape);
  EXPECT_EQ(of("a").given_mass, of("d").given_mass);
  for (const char* name : {"b", "c"}) EXPECT_NE(of("a").shape, of(name).shape) << name;
  EXPECT_NE(of("a").given_mass, of("b").given_mass);
}

}  // namespace
}  // namespace trivet
