// Textures in live views, of models as they are read from files.
#include <fstream>

#include "core/io/read_model.h"
#include "live_stage.h"
#include "support/mesa_leaks.h"
#include "support/temporary_folder.h"
#include "support/textured_square.h"

namespace trivet {
namespace {

using namespace test;
using testing::four_colours_png;
using testing::square_json;

std::shared_ptr<const Model> square_model(const std::string& alpha_mode) {
  const TemporaryFolder folder;
  nlohmann::ordered_json json = square_json();
  json["materials"][0]["alphaMode"] = alpha_mode;
  json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 0;
  std::ofstream(folder.file("c.png"), std::ios::binary) << four_colours_png();
  std::ofstream(folder.file("m.gltf")) << json.dump();
  return std::make_shared<const Model>(read_model(folder.file("m.gltf")));
}

/// The unit square, 120 x 120 pixels about the picture's middle.
LiveCamera above_square() {
  LiveCamera camera = from_above();
  camera.eye = Vec3(0.5, 0.5, 10), camera.target = Vec3(0.5, 0.5, 0);
  camera.height = 1.5;
  return camera;
}

LiveScene scene_of(std::shared_ptr<const Model> model) {
  LiveScene scene;
  scene.floor = false;
  scene.objects = {placed(std::move(model), Vec3(0, 0, 0.2))};
  return scene;
}

const std::uint8_t* seen(const Image& image, double x, double y) {
  const Vec2 at = pixel(above_square(), Vec3(x, y, 0.2));
  return image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

// Which of red, green and blue dominate.
std::array<bool, 3> dominant(const std::uint8_t* p) {
  const int most = std::max({p[0], p[1], p[2]});
  return {p[0] > most - 40, p[1] > most - 40, p[2] > most - 40};
}

TEST_F(Live, ShowsTextures) {
  const Image image = draw(scene_of(square_model("OPAQUE")), above_square());
  keep(image, "textured");
  EXPECT_EQ(dominant(seen(image, 0.15, 0.85)), (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(dominant(seen(image, 0.85, 0.85)), (std::array<bool, 3>{false, true, false}));
  EXPECT_EQ(dominant(seen(image, 0.15, 0.15)), (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(dominant(seen(image, 0.85, 0.15)), (std::array<bool, 3>{true, true, true}));
}

TEST_F(Live, MatchesPlainColours) {
  const Image textured = draw(scene_of(square_model("OPAQUE")), above_square());
  const Image red =
      draw(scene_of(box_model(Vec3(0, 0, -0.01), Vec3(1, 1, 0), {1, 0, 0, 1})), above_square());
  // Bilinear: at the centre of a texel, its colour alone. Materials of boxes are less rough.
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(seen(textured, 0.25, 0.75)[k], seen(red, 0.25, 0.75)[k], 12) << k;
}

TEST_F(Live, CutsOutTextures) {
  const LiveScene none{{}, false, {}};
  const Image empty = draw(none, above_square());
  for (const char* mode : {"MASK", "BLEND"}) {
    const Image image = draw(scene_of(square_model(mode)), above_square());
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(seen(image, 0.75, 0.25)[k], seen(empty, 0.75, 0.25)[k], 4) << mode;
    EXPECT_EQ(dominant(seen(image, 0.15, 0.85)), (std::array<bool, 3>{true, false, false}));
  }
}

TEST_F(Live, SendsTexturesOnce) {
  const LiveScene scene = scene_of(square_model("OPAQUE"));
  draw(scene, above_square());
  EXPECT_EQ(m_view->work().meshes_sent, 1);
  draw(scene, above_square());
  EXPECT_EQ(m_view->work().meshes_sent, 0);
}

// Plain and textured objects together: neither spoils the other's state, drafts included.
TEST_F(Live, MixesTexturedAndPlainObjects) {
  const auto grey = box_model(Vec3(0, 0, 0), Vec3(0.3, 0.3, 0.1), kGrey);
  LiveScene scene = scene_of(square_model("BLEND"));
  scene.objects.push_back(placed(grey, Vec3(1.05, 0.35, 0.2)));
  scene.objects.push_back(placed(square_model("MASK"), Vec3(-1.1, 0, 0.2)));
  LiveScene alone;
  alone.floor = false;
  alone.objects = {scene.objects[1]};
  const Image together = draw(scene, above_square()), single = draw(alone, above_square());
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(seen(together, 1.2, 0.5)[k], seen(single, 1.2, 0.5)[k], 4);
  LiveOptions draft = small();
  draft.draft = true;
  scene.objects[0].moving = true;
  const Image drafted = draw(scene, above_square(), draft);
  EXPECT_EQ(dominant(seen(drafted, 0.15, 0.85)), (std::array<bool, 3>{true, false, false}));
}

}  // namespace
}  // namespace trivet
