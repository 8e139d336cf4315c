// Textured squares from above, whose pixels are known: the same probes for every renderer. A square
// with a look is compared with one that has the same appearance by its material and normals.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "core/base/image.h"
#include "core/picture/scene.h"

namespace trivet::testing {

using RenderSquare =
    std::function<Image(const PictureScene&, const Camera&, const PictureOptions&)>;
using Texel = std::array<std::uint8_t, 4>;

inline constexpr int kProbeSide = 64;  // of the pictures, which show 2 x 2 m

/// From (-1, -1) to (1, 1) at a height; u to the right, v down as seen from above.
struct Square {
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles{{0, 1, 2}, {0, 2, 3}};
  std::vector<std::array<Eigen::Vector3f, 3>> normals;
  std::vector<Material> materials{Material()};
  std::shared_ptr<SurfaceLook> look;

  explicit Square(double height = 0)
      : vertices{{-1, -1, height}, {1, -1, height}, {1, 1, height}, {-1, 1, height}} {}

  /// @param repeats  of the image each way.
  SurfaceLook& add_look(float repeats = 1) {
    look = std::make_shared<SurfaceLook>();
    look->materials.emplace_back();
    look->materials[0].base_colour = {1, 1, 1, 1};
    look->finishes.emplace_back();
    look->face_material = {0, 0};
    const std::array<Eigen::Vector2f, 4> at{
        Eigen::Vector2f(0, repeats), {repeats, repeats}, {repeats, 0}, {0, 0}};
    for (const Index3& t : triangles)
      look->coordinates[0].push_back({at[size_t(t[0])], at[size_t(t[1])], at[size_t(t[2])]});
    return *look;
  }
  PictureMesh view() const {
    PictureMesh mesh;
    mesh.vertices = vertices, mesh.triangles = triangles;
    mesh.corner_normals = normals, mesh.materials = materials;
    if (look) mesh.look = [its = look](std::size_t) { return its; };
    return mesh;
  }
};

/// An image of side x side texels.
template <class F>
std::shared_ptr<const TextureImage> image_of(int side, bool srgb, F texel) {
  DecodedImage image{side, side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const std::uint8_t c : texel(x, y)) image.rgba.push_back(c);
  return std::make_shared<TextureImage>(make_texture_image(std::move(image), srgb));
}

inline constexpr Texel kRed{200, 30, 30, 255}, kGreen{30, 200, 30, 255}, kBlue{30, 30, 200, 255},
    kGrey{188, 188, 188, 255};

/// Red and green above, blue and grey below.
inline std::shared_ptr<const TextureImage> quadrants() {
  return image_of(32, true, [](int x, int y) {
    return y < 16 ? (x < 16 ? kRed : kGreen) : (x < 16 ? kBlue : kGrey);
  });
}

inline Material plain_of(const Texel& texel) {
  Material out;
  for (size_t k = 0; k < 3; ++k) out.base_colour[k] = linear_from_srgb_byte(texel[k]);
  out.roughness = Material().roughness;
  return out;
}

class LookProbes {
 public:
  explicit LookProbes(RenderSquare render, int samples) : m_render(std::move(render)) {
    m_options.width = m_options.height = kProbeSide;
    m_options.samples = samples;
    m_options.background = {1, 1, 1, 1};
  }

  /// Shows all of the square, and nothing else.
  Image shot(const Square& square, bool floor = false) const {
    const PictureMesh mesh = square.view();
    PictureObject object;
    object.mesh = &mesh;
    Camera camera;
    camera.eye = Vec3(0, 0, 10), camera.target = Vec3::Zero(), camera.up = Vec3::UnitY();
    camera.fov_deg = 2 * std::atan(0.1) * 180 / 3.14159265358979;
    return m_render({{object}, floor}, camera, m_options);
  }

  /// Mean of 5 x 5 pixels about a place of the square, x to the right and y up, -1 to 1.
  static Vec3 seen(const Image& image, double x, double y) {
    Vec3 sum = Vec3::Zero();
    const int column = int((x + 1) / 2 * kProbeSide), row = int((1 - y) / 2 * kProbeSide);
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i) {
        const std::uint8_t* const p = image.pixel(column + i, row + j);
        sum += Vec3(p[0], p[1], p[2]);
      }
    return sum / 25;
  }
  static void expect_near(const Vec3& a, const Vec3& b, double tolerance, const char* what) {
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), tolerance)
        << what << ": " << a.transpose() << " and " << b.transpose();
  }
  /// The picture's middle of a square of that material.
  Vec3 plain(const Material& material,
             const Eigen::Vector3f& normal = Eigen::Vector3f::UnitZ()) const {
    Square square;
    square.normals.assign(2, {normal, normal, normal});
    square.materials = {material};
    return seen(shot(square), 0, 0);
  }
  void expect_texel(const Image& image, double x, double y, const Texel& texel,
                    const char* what) const {
    expect_near(seen(image, x, y), plain(plain_of(texel)), 4, what);
  }

  void shows_quadrants() const {
    const Image image = shot(textured());
    expect_texel(image, -0.5, 0.5, kRed, "above left");
    expect_texel(image, 0.5, 0.5, kGreen, "above right");
    expect_texel(image, -0.5, -0.5, kBlue, "below left");
    expect_texel(image, 0.5, -0.5, kGrey, "below right");
  }

  // The image twice each way: what is beyond its first copy is told by the wrap.
  void wraps() const {
    for (const TextureWrap wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror}) {
      Square square = textured(2);
      TextureUse& use = square.look->finishes[0].base_colour;
      use.wrap_u = wrap, use.wrap_v = TextureWrap::Clamp;
      const Image image = shot(square);
      expect_texel(image, -0.75, 0.75, kRed, "first copy");
      expect_texel(image, -0.25, 0.75, kGreen, "first copy");
      expect_texel(image, 0.25, 0.75, wrap == TextureWrap::Repeat ? kRed : kGreen, "beyond");
      expect_texel(image, 0.75, 0.75, wrap == TextureWrap::Mirror ? kRed : kGreen, "beyond");
      expect_texel(image, -0.75, -0.5, kBlue, "clamped below");
    }
  }

  void transforms() const {
    Square square = textured();
    // A quarter turn against the clock about the corner above left, then one to the left.
    square.look->finishes[0].base_colour.transform = {{{0, 1, 0}, {-1, 0, 1}}};
    const Image image = shot(square);
    expect_texel(image, -0.5, 0.5, kBlue, "above left");
    expect_texel(image, 0.5, 0.5, kRed, "above right");
    expect_texel(image, -0.5, -0.5, kGrey, "below left");
    expect_texel(image, 0.5, -0.5, kGreen, "below right");
  }

  // Finer than pixels, black and white are their mean, everywhere.
  void filters_fine_checkers() const {
    Square square = textured(4);
    square.look->images[0] = image_of(256, true, [](int x, int y) {
      return (x + y) % 2 ? Texel{0, 0, 0, 255} : Texel{255, 255, 255, 255};
    });
    const Image image = shot(square);
    Material grey = plain_of(kGrey);
    for (const double x : {-0.7, -0.31, 0.0, 0.42, 0.8})
      for (const double y : {-0.6, 0.1, 0.77})
        expect_near(seen(image, x, y), plain(grey), 5, "fine checkers");
  }

  void shows_vertex_colours() const {
    Square square;
    square.add_look().colours = {
        {Eigen::Vector4f(0.5f, 0, 0, 1), {0, 0.5f, 0, 1}, {0, 0, 0.5f, 1}},
        {Eigen::Vector4f(0.5f, 0, 0, 1), {0, 0, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}}};
    const Image image = shot(square);
    Material mean;
    mean.base_colour = {0.25f, 0, 0.25f, 1};
    expect_near(seen(image, 0, 0), plain(mean), 12, "between opposite corners");
    Material corner;
    corner.base_colour = {0.05f, 0.4f, 0.05f, 1};
    expect_near(seen(image, 0.8, -0.8), plain(corner), 8, "near the green corner");
  }

  // Turned away from the key light, where metal and matt surfaces differ.
  void uses_metal_and_roughness() const {
    const Eigen::Vector3f away(0, 0.5f, std::sqrt(0.75f));
    Square square;
    square.normals.assign(2, {away, away, away});
    SurfaceLook& look = square.add_look();
    look.materials[0].base_colour = {0.8f, 0.5f, 0.2f, 1};
    look.materials[0].metallic = 1, look.materials[0].roughness = 1;
    look.images = {image_of(8, false, [](int x, int) {
      return x < 4 ? Texel{0, 102, 255, 255} : Texel{255, 204, 0, 255};
    })};
    look.finishes[0].metallic_roughness.image = 0;
    const Image image = shot(square);
    Material metal = look.materials[0], matt = metal;
    metal.roughness = 0.4f;
    matt.metallic = 0, matt.roughness = 0.8f;
    expect_near(seen(image, -0.5, 0), plain(metal, away), 4, "rough metal");
    expect_near(seen(image, 0.5, 0), plain(matt, away), 4, "no metal");
    EXPECT_GT((plain(metal, away) - plain(matt, away)).norm(), 10);
  }

  /// The colour that a black surface of that radiance has, below the film's knee.
  void glows() const {
    Square square;
    SurfaceLook& look = square.add_look();
    look.materials[0].base_colour = {0, 0, 0, 1};
    look.finishes[0].emitted = {0.3f, 0.3f, 0};
    look.images = {quadrants()};
    look.finishes[0].emission.image = 0;
    const Image lit = shot(square);
    look.finishes[0].emitted = {0, 0, 0};
    look.finishes[0].emission = {};
    const Image dark = shot(square);
    const auto light = [](double srgb) {
      const double c = srgb / 255;
      return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const auto added = [&](double x, double y, int k) {
      return light(seen(lit, x, y)[k]) - light(seen(dark, x, y)[k]);
    };
    EXPECT_NEAR(added(0.5, -0.5, 0), 0.3 * linear_from_srgb_byte(188), 0.02);
    EXPECT_NEAR(added(0.5, -0.5, 2), 0, 0.02);
    EXPECT_NEAR(added(-0.5, 0.5, 0), 0.3 * linear_from_srgb_byte(200), 0.02);
    EXPECT_NEAR(added(-0.5, 0.5, 1), 0.3 * linear_from_srgb_byte(30), 0.02);
  }

  // As bright as a square whose corner normals are tilted that way, with mirrored images too.
  void bends_normals() const {
    for (const auto& [x, y] : {std::pair(0.5f, 0.0f), {-0.5f, 0.0f}, {0.0f, 0.5f}, {0.0f, -0.5f}})
      for (const bool mirrored : {false, true}) {
        const float z = std::sqrt(1 - x * x - y * y);
        Square square;
        SurfaceLook& look = square.add_look();
        look.materials[0] = plain_of(kGrey);
        const auto byte = [](float c) { return std::uint8_t(std::lround((c + 1) * 127.5f)); };
        look.images = {image_of(4, false, [&, tx = x, ty = y](int, int) {
          return Texel{byte(mirrored ? -tx : tx), byte(ty), byte(z), 255};
        })};
        look.finishes[0].normal.image = 0;
        const float right = mirrored ? -1.0f : 1.0f;
        if (mirrored) look.finishes[0].normal.transform[0] = {-1, 0, 1};
        look.tangents.assign(2, Eigen::Vector4f(right, 0, 0, right));
        Square tilted;
        tilted.materials = {plain_of(kGrey)};
        const Eigen::Vector3f n(x, y, z);
        tilted.normals.assign(2, {n, n, n});
        expect_near(seen(shot(square), 0, 0), seen(shot(tilted), 0, 0), 4,
                    mirrored ? "mirrored normal map" : "normal map");
      }
  }

  // The right half is cut out: the background there, and light on the floor below.
  void cuts_out() const {
    const auto leaf = image_of(32, true, [](int x, int) {
      return x < 16 ? kGreen : Texel{255, 0, 255, 20};
    });
    Square square = textured();
    square.look->images = {leaf};
    square.look->finishes[0].transparency = Transparency::Cut;
    const Image image = shot(square);
    expect_texel(image, -0.5, 0, kGreen, "what is kept");
    expect_near(seen(image, 0.5, 0), Vec3::Constant(255), 2, "what is cut out");
    EXPECT_EQ(image.pixel(3 * kProbeSide / 4, kProbeSide / 2)[3], 255);
    // Half a metre above the floor.
    Square raised(0.5);
    raised.look = square.look;
    Square whole = raised;
    whole.look = std::make_shared<SurfaceLook>(*square.look);
    whole.look->finishes[0].transparency = Transparency::None;
    const Vec3 through = seen(shot(raised, true), 0.6, 0.3);
    EXPECT_GT(through.mean(), 120) << "the floor is lit through what is cut out";
    EXPECT_GT((through - seen(shot(whole, true), 0.6, 0.3)).norm(), 40);
  }

  void blends() const {
    Square square = textured();
    square.look->images = {image_of(8, true, [](int x, int) {
      return x < 4 ? Texel{30, 30, 30, 128} : Texel{30, 30, 30, 0};
    })};
    square.look->finishes[0].transparency = Transparency::Blend;
    const Image image = shot(square);
    const double dark = plain(plain_of({30, 30, 30, 255})).mean(),
                 half = seen(image, -0.5, 0).mean();
    EXPECT_GT(half, dark + 40);
    EXPECT_LT(half, 255 - 25);
    expect_near(seen(image, 0.5, 0), Vec3::Constant(255), 2, "nothing there");
  }

  void all() const {
    shows_quadrants();
    wraps();
    transforms();
    filters_fine_checkers();
    shows_vertex_colours();
    uses_metal_and_roughness();
    glows();
    bends_normals();
    cuts_out();
    blends();
  }

 private:
  static Square textured(float repeats = 1) {
    Square square;
    SurfaceLook& look = square.add_look(repeats);
    look.materials[0].roughness = Material().roughness;
    look.images = {quadrants()};
    look.finishes[0].base_colour.image = 0;
    return square;
  }

  RenderSquare m_render;
  PictureOptions m_options;
};

}  // namespace trivet::testing
