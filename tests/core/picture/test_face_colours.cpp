// Colours of faces for views without textures.
#include <gtest/gtest.h>

#include <cmath>

#include "core/picture/face_colours.h"

namespace trivet {
namespace {

using Colour = std::array<std::uint8_t, 4>;

const std::vector<Vec3> kVertices{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
const std::vector<Index3> kTriangles{{0, 1, 2}, {0, 1, 3}};

PictureMesh two_faces() {
  PictureMesh mesh;
  mesh.vertices = kVertices;
  mesh.triangles = kTriangles;
  return mesh;
}

int srgb_byte(double linear) {
  return int(255 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055) + 0.5);
}

TEST(FaceColours, AreThoseOfTheMaterials) {
  std::vector<Material> materials(2);
  materials[0].base_colour = {0.5f, 1, 0, 1};
  materials[1].base_colour = {2, NAN, 0.001f, 0.2f};
  const std::vector<Index> face_material{1, 0};
  PictureMesh mesh = two_faces();
  EXPECT_EQ(face_colours(mesh)[1], face_colours(mesh)[0]);  // light grey
  mesh.materials = materials;
  mesh.face_material = face_material;
  const auto colours = face_colours(mesh);
  EXPECT_EQ(colours[1], (Colour{std::uint8_t(srgb_byte(0.5)), 255, 0, 255}));
  EXPECT_EQ(colours[0], (Colour{255, 0, 3, 51}));  // 12.92 * 0.001 * 255
}

TEST(FaceColours, AreMeansOfTexturesAndVertexColours) {
  auto look = std::make_shared<SurfaceLook>();
  look->materials.resize(2);
  look->materials[0].base_colour = look->materials[1].base_colour = {1, 0.5f, 1, 0.8f};
  look->finishes.resize(2);
  look->finishes[1].base_colour.image = 0;
  look->face_material = {0, 1};
  const DecodedImage half_black{2, 1, {255, 255, 255, 255, 0, 0, 0, 255}};
  look->images = {std::make_shared<TextureImage>(make_texture_image(half_black, true))};
  PictureMesh mesh = two_faces();
  mesh.look = [&](std::size_t) { return look; };
  auto colours = face_colours(mesh);
  EXPECT_EQ(colours[0], (Colour{255, std::uint8_t(srgb_byte(0.5)), 255, 204}));
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(colours[1][k], srgb_byte(k == 1 ? 0.25 : 0.5), 2);  // a texel has 8 bits
  EXPECT_EQ(colours[1][3], 204);
  const Eigen::Vector4f white = Eigen::Vector4f::Ones(), black(0, 0, 0, 1);
  look->colours = {{white, white, black}, {white, white, white}};
  colours = face_colours(mesh);
  EXPECT_EQ(colours[0][0], srgb_byte(2.0 / 3));
  EXPECT_EQ(colours[0][3], 204);
}

}  // namespace
}  // namespace trivet
