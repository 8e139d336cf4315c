// Weights of what lies on links at their joints; pieces that stand free and tip: known answers.
#include <gtest/gtest.h>

#include "core/io/foreign/foreign_testing.h"
#include "ops/files/foreign/findings.h"

namespace trivet {
namespace {

using namespace trivet::test;

SceneVerdict verdict_on(const std::string& text, const char* extension = "xml") {
  const TemporaryFolder folder;
  const std::string file = folder.file(std::string("in.") + extension);
  write_text(file, text);
  OpenedScene opened = open_scene(file, {});
  return judge(opened, {});
}

std::string notes_of(const SceneVerdict& verdict) {
  std::string out;
  for (const Sentence& note : verdict.notes) out += in_english(note) + "\n";
  return out;
}

/// A trapdoor of 1 kg and 1 m on a hinge with friction, and a cube of 1 kg on its middle.
std::string trapdoor(const std::string& hinge, bool cube) {
  return "<mujoco><worldbody><geom type='plane' size='3 3 1'/><body pos='0 0 1'><joint name='flap' "
         "type='hinge' axis='0 1 0' " +
         hinge + "/><geom type='box' size='.5 .5 .01' pos='.5 0 0' mass='1'/></body>" +
         (cube ? "<body name='cube' pos='.5 0 1.06'><freejoint/>"
                 "<geom type='box' size='.05 .05 .05' mass='1'/></body>"
               : "") +
         "</worldbody></mujoco>";
}

TEST(JointBearing, ATrapdoorFallsByWhatLiesOnIt) {
  const std::string told =
      "the link in the joint \"flap\" would swing: with what lies on it 9.80665 N m turn it";
  const auto notes = [](const std::string& hinge, bool cube) {
    return notes_of(verdict_on(trapdoor(hinge, cube)));
  };
  EXPECT_NE(notes("frictionloss='6'", true).find(told), std::string::npos)
      << notes("frictionloss='6'", true);
  EXPECT_EQ(notes("frictionloss='6'", false).find("would swing"), std::string::npos);
  EXPECT_EQ(notes("frictionloss='9.9'", true).find("would swing"), std::string::npos);
  // It lies on its stop; and it moves by its own weight alone, which is told already.
  EXPECT_EQ(notes("limited='true' range='-90 0'", true).find("would swing"), std::string::npos);
  EXPECT_EQ(notes("", true).find("with what lies"), std::string::npos);
  EXPECT_NE(notes("", true).find("its weight turns it with 4.90332 N m"), std::string::npos);
}

/// A cabinet of 5 kg, half a width of 0.2 m, with a drawer of 5 kg pulled out by `open`; and a cube
/// of 1 kg in the middle of that. It may stand free or be part of the world.
std::string cabinet(double open, bool cube, bool free = true) {
  const std::string at = std::to_string(-open);
  return std::string("<mujoco><worldbody><geom type='plane' size='3 3 1'/>") +
         "<body name='cabinet'>" + (free ? "<freejoint/>" : "") +
         "<geom type='box' size='.2 .2 .1' pos='0 0 .1' mass='5'/><body name='drawer' pos='0 " +
         at +
         " .3'><joint name='slide' type='slide' axis='0 -1 0'/>"
         "<geom type='box' size='.05 .15 .01' mass='5'/></body></body>" +
         (cube ? "<body name='cube' pos='0 " + at +
                     " .33'><freejoint/><geom type='box' size='.02 .02 .02' mass='1'/></body>"
               : "") +
         "</worldbody></mujoco>";
}

// 5 kg at 0 and 5 kg at `open` balance over the edge at 0.2 m for 0.4 m; with 1 kg more in the
// drawer for 0.3667 m.
TEST(JointBearing, AnOpenDrawerTipsItsCabinet) {
  for (const double open : {0.0, 0.39}) EXPECT_TRUE(verdict_on(cabinet(open, false)).ok()) << open;
  const SceneVerdict tips = verdict_on(cabinet(0.41, false));
  ASSERT_EQ(tips.findings.size(), 1u);
  EXPECT_EQ(tips.findings[0].kind, SceneFinding::Kind::Unstable);
  EXPECT_EQ(tips.findings[0].object, "cabinet");
  EXPECT_EQ(tips.findings[0].way.substr(0, 4), "tips");
  EXPECT_NE(tips.findings[0].way.find("-1.00)"), std::string::npos) << tips.findings[0].way;
  EXPECT_TRUE(verdict_on(cabinet(0.36, true)).ok());
  EXPECT_EQ(verdict_on(cabinet(0.375, true)).count(SceneFinding::Kind::Unstable), 1u);
  EXPECT_TRUE(verdict_on(cabinet(0.375, false)).ok());
}

TEST(JointBearing, WhatTheWorldHoldsDoesNotTip) {
  EXPECT_TRUE(verdict_on(cabinet(0.9, false, false)).ok());
}

/// The same in SDF, where models stand free unless they are static or a joint holds them.
std::string sdf_cabinet(double open, const std::string& more) {
  const auto link = [](const char* name, const std::string& pose, const char* size,
                       const std::string& at) {
    return std::string("<link name='") + name + "'><pose>" + pose +
           "</pose><inertial><mass>5</mass><pose>" + at + "</pose></inertial><collision name='c'>" +
           "<pose>" + at + "</pose><geometry><box><size>" + size +
           "</size></box></geometry></collision></link>";
  };
  return "<sdf version='1.9'><world name='w'><model name='ground'><static>true</static><link "
         "name='l'><collision name='c'><geometry><plane><normal>0 0 1</normal></plane></geometry>"
         "</collision></link></model><model name='unit'>" +
         link("frame", "0 0 0 0 0 0", ".4 .4 .2", "0 0 .1 0 0 0") +
         link("drawer", "0 " + std::to_string(-open) + " .3 0 0 0", ".1 .3 .02", "0 0 0 0 0 0") +
         "<joint name='slide' type='prismatic'><parent>frame</parent><child>drawer</child><axis>"
         "<xyz>0 -1 0</xyz></axis></joint>" +
         more + "</model></world></sdf>";
}

TEST(JointBearing, ModelsOfSdfStandFree) {
  EXPECT_TRUE(verdict_on(sdf_cabinet(0.39, ""), "sdf").ok());
  const SceneVerdict tips = verdict_on(sdf_cabinet(0.41, ""), "sdf");
  ASSERT_EQ(tips.findings.size(), 1u);
  EXPECT_EQ(tips.findings[0].object, "unit::frame");
  EXPECT_TRUE(verdict_on(sdf_cabinet(0.41, "<static>true</static>"), "sdf").ok());
  const std::string held =
      "<joint name='bolt' type='fixed'><parent>world</parent><child>frame</child></joint>";
  EXPECT_TRUE(verdict_on(sdf_cabinet(0.41, held), "sdf").ok());
}

}  // namespace
}  // namespace trivet
