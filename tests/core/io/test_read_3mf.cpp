// 3MF as slicers and CAD write it: archives with other things in them, units, transforms.
#include "core/io/cubes.h"
#include "core/io/look.h"

namespace trivet {
namespace {

using testing::cube_model_3mf;
using testing::error_of;
using testing::expect_parts;
using testing::expect_unit_cube;
using testing::joined_notes;
using testing::rels_3mf;
using testing::replaced;
using testing::zipped;

class Read3mf : public testing::IoTest {
 protected:
  std::string packed(const std::string& model, const std::string& rels = rels_3mf()) const {
    return write("a.3mf", zipped({{"[Content_Types].xml", "<Types/>"},
                                  {"_rels/.rels", rels},
                                  {"3D/a.model", model}}));
  }
};

const std::string kThumbnail =
    "<Relationship Target=\"/Metadata/thumbnail.png\" Id=\"r1\" "
    "Type=\"http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail\"/>";

TEST_F(Read3mf, TakesArchivesOfOtherPrograms) {
  expect_unit_cube(packed(cube_model_3mf()));
  expect_unit_cube(packed(cube_model_3mf(), rels_3mf(kThumbnail)));
  const std::string model = cube_model_3mf();
  // The model first, no relationships, a leading slash, fields of ZIP that others leave out.
  expect_unit_cube(write("b.3mf", zipped({{"3D/3dmodel.model", model}})));
  expect_unit_cube(write("c.3mf", zipped({{"/3D/a.model", model}, {"_rels/.rels", rels_3mf()}})));
  expect_unit_cube(write("d.3mf", zipped({{"Metadata/thumbnail.png", "png"},
                                          {"_rels/.rels", rels_3mf(kThumbnail)},
                                          {"3D/a.model", model}},
                                         std::string("\x34\x12\4\0abcd", 8))));
  expect_unit_cube(write("e.zip.obj", zipped({{"3D/a.model", model}})));
}

TEST_F(Read3mf, ReadsUnits) {
  for (const auto& [unit, metres] :
       {std::pair("", 0.001), std::pair("micron", 1e-6), std::pair("millimeter", 0.001),
        std::pair("centimeter", 0.01), std::pair("inch", 0.0254), std::pair("foot", 0.3048),
        std::pair("meter", 1.0)}) {
    const std::string attribute = *unit ? "unit=\"" + std::string(unit) + "\"" : "";
    const Model model = expect_unit_cube(packed(cube_model_3mf(attribute)));
    EXPECT_EQ(model.metres_per_unit, metres) << unit;
    EXPECT_EQ(model.up, UpAxis::Z);
    EXPECT_TRUE(model.up_from_format);
  }
  expect_unit_cube(packed(cube_model_3mf("unit=\"cubit\"")), {"\"cubit\" is unknown"});
}

TEST_F(Read3mf, PlacesItemsAndComponents) {
  const std::string items =
      "<item objectid=\"1\" transform=\"2 0 0 0 1 0 0 0 1 3 0 0\"/>"
      "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>";
  const Model model = read_model(packed(cube_model_3mf("", items)));
  const MassProperties mass = testing::mass_of(model);
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 3, 1e-12);
  EXPECT_NEAR(mass.centre.x(), 2, 1e-12);
  expect_parts(joined_notes(model), {"mirrored meshes, winding turned round: 1"});
  const std::string parts =
      "<object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 "
      "5\"/>"
      "<component objectid=\"1\"/></components></object></resources>";
  const Model joined = read_model(packed(
      replaced(cube_model_3mf("", "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/>"),
               "</resources>", parts)));
  EXPECT_NEAR(testing::mass_of(joined).volume, 2, 1e-12);
  EXPECT_LT((testing::mass_of(joined).centre - Vec3(10, 0, 2.5)).norm(), 1e-12);
}

TEST_F(Read3mf, NamesItemsThatAreNotToBePrinted) {
  for (const char* const value : {"0", "false"}) {
    const std::string items =
        "<item objectid=\"1\" printable=\"1\"/><item objectid=\"1\" printable=\"" +
        std::string(value) + "\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>";
    const Model model = read_model(packed(cube_model_3mf("", items)));
    EXPECT_NEAR(testing::mass_of(model).volume, 2, 1e-12);
    expect_parts(joined_notes(model), {"items read that are marked as not to be printed: 1"});
  }
}

TEST_F(Read3mf, ReadsColoursOfMaterials) {
  std::string text =
      cube_model_3mf("", "",
                     "<basematerials id=\"5\"><base name=\"red\" displaycolor=\"#FF0000\"/>"
                     "<base name=\"glass\" displaycolor=\"#0000FF80\"/></basematerials>");
  text = replaced(text, "<object id=\"1\"", "<object id=\"1\" pid=\"5\" pindex=\"0\"");
  text = replaced(text, "v1=\"0\" v2=\"2\" v3=\"3\"", "v1=\"0\" v2=\"2\" v3=\"3\" p1=\"1\"");
  const Model model = expect_unit_cube(packed(text));
  std::array<int, 2> faces{};
  for (const Index m : model.face_material) ++faces[model.materials[m].name == "glass"];
  EXPECT_EQ(faces, (std::array<int, 2>{11, 1}));
  EXPECT_EQ(model.materials[0].base_colour, (std::array<float, 4>{1, 0, 0, 1}));
}

TEST_F(Read3mf, RefusesWhatItCannotMean) {
  const auto expect_refused = [&](const std::string& model, const std::vector<std::string>& parts) {
    expect_parts(error_of([&] { read_model(packed(model)); }), parts);
  };
  expect_refused(cube_model_3mf("", "<item objectid=\"7\"/>"), {"object 7", "not there"});
  expect_refused(replaced(cube_model_3mf(), "v3=\"3\"", "v3=\"8\""), {"vertex 8 of 8"});
  expect_refused(replaced(cube_model_3mf(), "x=\"0.5\"", "x=\"half\""),
                 {"\"half\" is not a number"});
  expect_refused(replaced(cube_model_3mf(), "</model>", ""), {"3D/a.model", "line 2"});
  expect_refused(cube_model_3mf("requiredextensions=\"q\" xmlns:q=\"http://example.com/quantum\""),
                 {"requires the extension", "quantum"});
  expect_refused(
      replaced(cube_model_3mf(), "<object id=\"1\" type=\"model\"><mesh>",
               "<object id=\"1\"><components><component objectid=\"1\"/></components><mesh>"),
      {"nested too deeply"});
  expect_parts(error_of([&] { read_model(write("b.3mf", "PK\3\4 nonsense")); }), {"b.3mf", "ZIP"});
  expect_parts(error_of([&] {
                 read_model(write("c.3mf", zipped({{"a.txt", "a"}})));
               }),
               {"without a model of 3MF"});
}

}  // namespace
}  // namespace trivet
