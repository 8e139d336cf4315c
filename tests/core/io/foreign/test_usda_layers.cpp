// Layers of USD: what each of several says, in its order; and layers made to take long or much.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/usd/read_usda.h"
#include "fuzz/mutants.h"

namespace trivet {
namespace {

using namespace trivet::test;

const std::string kUsda = "#usda 1.0\n";
const std::string kUnits = "metersPerUnit = 1\nupAxis = \"Z\"\n";

std::string layer_text(const std::string& metadata, const std::string& prims) {
  return kUsda + "(\n" + kUnits + metadata + ")\n" + prims;
}
std::string at_x(const std::string& x) {
  return "double3 xformOp:translate = (" + x + ", 0, 0)\n" +
         "uniform token[] xformOpOrder = [\"xformOp:translate\"]\n";
}
/// A body of the size of a box in its own layer, whose default prim it is.
std::string asset_text(const std::string& more = "") {
  return layer_text(
      "defaultPrim = \"asset\"\n",
      "def Xform \"asset\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\"])\n{\n" + at_x("1") +
          more + "def Cube \"box\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) {}\n}\n");
}

using LayerTexts = std::vector<std::pair<std::string, std::string>>;

/// Layers in a folder of their own, the first of them read.
class Layers {
 public:
  explicit Layers(const LayerTexts& texts) {
    for (const auto& [name, text] : texts) write_text(m_folder.file(name), text);
    m_scene = read_usda(m_folder.file(texts[0].first), {}, no_mesh);
  }
  const ForeignScene& scene() const { return m_scene; }
  double x(const std::string& body) const {
    const ForeignBody* const found = find_body(m_scene, body);
    return found ? found->pose.translation.x() : -1;
  }
  bool names(const std::string& part) const {
    return std::any_of(m_scene.unread.begin(), m_scene.unread.end(), [&](const Sentence& note) {
      return in_english(note).find(part) != std::string::npos;
    });
  }

 private:
  TemporaryFolder m_folder;
  ForeignScene m_scene;
};

std::string error_of_usda(const std::string& text, const XmlLimits& limits = {}) {
  const TemporaryFolder folder;
  write_text(folder.file("s.usda"), text);
  ForeignOptions options;
  options.limits = limits;
  try {
    read_usda(folder.file("s.usda"), options, no_mesh);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(UsdaLayers, ReferencesBringPrims) {
  const Layers layers({{"s.usda", layer_text("",
                                             "def \"a\" (references = @./asset.usda@) {}\n"
                                             "def \"b\" (prepend payload = @asset.usda@</asset>"
                                             " (offset = 10))\n{\n" +
                                                 at_x("3") + "}\n")},
                       {"asset.usda", asset_text()}});
  EXPECT_EQ(layers.x("a"), 1);
  EXPECT_EQ(layers.x("b"), 3);
  EXPECT_TRUE(layers.scene().unread.empty());
  EXPECT_EQ(layers.scene().files.size(), 2u);
}

TEST(UsdaLayers, TheStrongestOpinionCounts) {
  // A sublayer is weaker than its layer, both are stronger than what they refer to.
  const Layers layers(
      {{"s.usda", layer_text("subLayers = [@./strong.usda@, @./weak.usda@]\n", "")},
       {"strong.usda", layer_text("", "over \"a\" {\n" + at_x("7") + "}\nover \"b\" {}\n")},
       {"weak.usda", layer_text("", "def \"a\" (references = @asset.usda@) {\n" + at_x("5") +
                                        "}\ndef \"b\" (references = @asset.usda@) {\n" + at_x("5") +
                                        "}\nover \"c\" {\n" + at_x("5") + "}\n")},
       {"asset.usda", asset_text()}});
  EXPECT_EQ(layers.x("a"), 7);
  EXPECT_EQ(layers.x("b"), 5);
  EXPECT_EQ(layers.scene().bodies.size(), 2u);  // "c" is only spoken about
}

TEST(UsdaLayers, ReferencesOfReferencesAreWeakerThanEither) {
  const Layers layers(
      {{"s.usda", layer_text("", "def \"a\" (references = @middle.usda@</m>) {}\n")},
       {"middle.usda",
        layer_text("", "def \"m\" (references = @asset.usda@) {\n" + at_x("4") + "}\n")},
       {"asset.usda", asset_text()}});
  EXPECT_EQ(layers.x("a"), 4);
}

TEST(UsdaLayers, VariantsAreChosenByTheStrongest) {
  const std::string sets = "variants = { string place = \"near\" }\nvariantSets = \"place\"\n";
  const std::string asset =
      layer_text("defaultPrim = \"asset\"\n",
                 "def Xform \"asset\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]\n" + sets +
                     ")\n{\ndef Cube \"box\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) {}\n"
                     "variantSet \"place\" = {\n\"near\" {\n" +
                     at_x("2") + "}\n\"far\" (doc = \"away\") {\n" + at_x("9") + "}\n}\n}\n");
  const Layers layers({{"s.usda", layer_text("",
                                             "def \"a\" (references = @asset.usda@) {}\n"
                                             "def \"b\" (references = @asset.usda@\n"
                                             "variants = { string place = \"far\" }) {}\n")},
                       {"asset.usda", asset}});
  EXPECT_EQ(layers.x("a"), 2);
  EXPECT_EQ(layers.x("b"), 9);
}

TEST(UsdaLayers, InheritedAndInactivePrims) {
  const Layers layers({{"s.usda", layer_text("", "class \"_far\" {\n" + at_x("6") +
                                                     "}\ndef \"a\" (references = @asset.usda@\n"
                                                     "inherits = </_far>) {}\n"
                                                     "def \"b\" (references = @asset.usda@\n"
                                                     "active = false) {}\n")},
                       {"asset.usda", asset_text()}});
  EXPECT_EQ(layers.x("a"), 6);
  EXPECT_EQ(layers.scene().bodies.size(), 1u);
}

TEST(UsdaLayers, PathsOfReferencedLayersFollow) {
  const std::string joint =
      "def PhysicsFixedJoint \"weld\" { rel physics:body0 = </asset>\n"
      "rel physics:body1 = </asset/second> }\n"
      "def Xform \"second\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]) {\n"
      "def Cube \"box\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) {} }\n";
  const Layers layers({{"s.usda", layer_text("",
                                             "def \"a\" (references = @asset.usda@) {}\n"
                                             "def \"b\" (references = @asset.usda@) {}\n")},
                       {"asset.usda", asset_text(joint)}});
  // Each copy is one body of two colliders.
  ASSERT_EQ(layers.scene().bodies.size(), 2u);
  for (const ForeignBody& body : layers.scene().bodies) EXPECT_EQ(body.colliders.size(), 2u);
}

TEST(UsdaLayers, InstancesHaveNoPlace) {
  const Layers layers(
      {{"s.usda",
        layer_text("", "def \"a\" (references = @group.usda@\ninstanceable = true) {}\n")},
       {"group.usda", layer_text("defaultPrim = \"g\"\n",
                                 "def \"g\" { def \"one\" (references = @asset.usda@) {} }\n")},
       {"asset.usda", asset_text()}});
  ASSERT_EQ(layers.scene().bodies.size(), 1u);
  EXPECT_EQ(layers.scene().bodies[0].place.kind, PosePlace::Kind::Nowhere);
  try {
    usda_over_layer(layers.scene(), {{0, {}}}, "./s.usda");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("inside an instance"), std::string::npos);
  }
}

TEST(UsdaLayers, WhatIsNotReadIsNamed) {
  const std::string collider = " (prepend apiSchemas = [\"PhysicsCollisionAPI\"])";
  const std::pair<std::string, std::string> cases[] = {
      {"def \"a\" (references = @missing.usda@) {}", "missing.usda: is no file"},
      {"def \"a\" (references = @https://a.b/c.usda@) {}", "is not fetched"},
      {"def \"a\" (references = @/etc/passwd@) {}", "outside its folder"},
      {"def \"a\" (references = </b>) {}", "has no prim /b"},
      {"def \"a\" (references = @s.usda@) {}", "no defaultPrim"},
      {"def \"a\" (specializes = </b>) {}", "specializes are not composed"},
      {"def PointInstancer \"a\" { def Cube \"c\"" + collider + " {} }", "PointInstancer"},
      {"def BasisCurves \"a\"" + collider + " {}", "\"BasisCurves\" is not read"},
      {"def Cube \"a\"" + collider +
           " { double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 1: (1, 0, 0), }\n"
           "uniform token[] xformOpOrder = [\"xformOp:translate\"] }",
       "poses over time"},
      {"def Cube \"a\"" + collider + " { uniform token[] xformOpOrder = [\"xformOp:shear\"] }",
       "xformOp:shear is not read"},
      {"def PhysicsScene \"p\" { vector3f physics:gravityDirection = (1, 0, 0) }", "to go down"},
      {"def Xform \"a\" {}", "nothing collides"},
  };
  for (const auto& [prims, part] : cases)
    EXPECT_TRUE(Layers(LayerTexts{{"s.usda", layer_text("", prims + "\n")}}).names(part)) << prims;
}

TEST(UsdaLayers, AllSyntaxIsRead) {
  const Layers layers(LayerTexts{{"s.usda", R"(#usda 1.0
(
    """A comment over
    two lines with a ) in it"""
    customLayerData = {
        dictionary a = { string "quoted key" = 'x'; double[] b = [1, 2,]; asset c = @@@x@y@@@ }
        bool d = 1
    }
    metersPerUnit = 1; upAxis = "Z"
    subLayers = []
)
# a comment
/* and
   one more */
over "nothing" {}
reorder rootPrims = ["b", "a"]
class Xform "c" ( "documented" ) { custom string x = "\"}" }
def Xform "b" (
    prepend apiSchemas = ["PhysicsRigidBodyAPI"]
    assetInfo = { asset identifier = @./b.usda@ }
    delete references = @gone.usda@
)
{
    reorder nameChildren = ["q", "p"]
    custom uniform token[] tokens = ["a", "b"] ( doc = "x" ) // end
    float empty
    float x.connect = </b.y>
    double x.timeSamples = { -1.5: 2, 3: None, }
    matrix4d m = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1) )
    float[] big = [-1e-3, +2., .5, inf, -inf, nan]
    string blocked = None
    prepend rel r = [</a>, </c>]
    rel none
    def Cube "box" ( prepend apiSchemas = ["PhysicsCollisionAPI"] ) {}
}
)"}});
  EXPECT_EQ(layers.scene().bodies.size(), 1u);
  EXPECT_TRUE(layers.scene().unread.empty());
}

TEST(UsdaLayers, ErrorsNameTheLine) {
  EXPECT_NE(error_of_usda("hello").find("accepted: USD as text"), std::string::npos);
  EXPECT_NE(error_of_usda("#usda 1.0\ndef \"\xff\" {}").find("UTF-8"), std::string::npos);
  EXPECT_NE(error_of_usda("PXR-USDC").find("is binary USD"), std::string::npos);
  for (const char* broken : {"def Xform \"a\"\n{", "def Xform \"a\"\n{ double x = }",
                             "def Xform \"a\"\n{ rel r = <a }", "def Xform\n{}", "undef\n\"a\" {}",
                             "def \"a\"\n{ int x = 1e }", "def \"a\"\n{ string s = \"", "/* \n",
                             "def \"a\"\n{} def \"a\" {}", "def \"a/b\"\n{}", "def \"\"\n{}"})
    EXPECT_NE(error_of_usda(kUsda + broken).find(": line "), std::string::npos) << broken;
}

TEST(UsdaLayers, HostileLayersEnd) {
  std::string deep;
  for (int i = 0; i < 400; ++i) deep += "def \"a\" {";
  EXPECT_NE(error_of_usda(kUsda + deep).find("nested too deeply"), std::string::npos);
  EXPECT_NE(
      error_of_usda(kUsda + "def \"a\" { int x = " + std::string(100'000, '[')).find("deeply"),
      std::string::npos);
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "def \"a" + std::to_string(i) + "\" {}\n";
  XmlLimits few;
  few.max_elements = 100;
  EXPECT_NE(error_of_usda(kUsda + many, few).find("too many elements"), std::string::npos);
  few = {};
  few.max_bytes = 100;
  EXPECT_NE(error_of_usda(kUsda + many, few).find("larger than"), std::string::npos);
}

TEST(UsdaLayers, ReferencesInACircleEnd) {
  const std::string circle = layer_text("defaultPrim = \"a\"\n",
                                        "def \"a\" (references = </b>) {}\n"
                                        "def \"b\" (references = </a>) {}\n"
                                        "def \"c\" (references = @s.usda@) { def \"d\" "
                                        "(references = </c>) {} }\n");
  EXPECT_TRUE(Layers(LayerTexts{{"s.usda", circle}}).names("refers to itself"));
  const std::string both = layer_text("subLayers = [@t.usda@, @s.usda@]\n", "");
  EXPECT_TRUE(Layers(LayerTexts{{"s.usda", both}, {"t.usda", both}}).names("nothing collides"));
}

TEST(UsdaLayers, ReferencesThatDoubleEnd) {
  std::string doubling = "def \"p0\" { def Cube \"c\" {} }\n";
  for (int i = 1; i < 30; ++i) {
    const std::string of = " (references = </p" + std::to_string(i - 1) + ">) {}\n";
    doubling.append("def \"p").append(std::to_string(i)).append("\" {\ndef \"l\"").append(of);
    doubling.append("def \"r\"").append(of).append("}\n");
  }
  EXPECT_NE(error_of_usda(layer_text("", doubling)).find("too large by its references"),
            std::string::npos);
}

// Bytes changed at random: an error that names the file, or a scene; nothing else, and soon.
TEST(UsdaLayers, ChangedBytesNeverCrash) {
  const std::string cases = std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases";
  std::vector<Seed> seeds;
  for (const Seed& seed : read_corpus(cases))
    if (seed.extension == ".usda") seeds.push_back(seed);
  ASSERT_FALSE(seeds.empty());
  const TemporaryFolder folder;
  const std::string file = folder.file("m.usda");
  int read = 0, refused = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    write_text(file, mutant(seeds, 11, i));
    try {
      read_usda(file, {}, no_mesh);
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::BadInput);
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace trivet
