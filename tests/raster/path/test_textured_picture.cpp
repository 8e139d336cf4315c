// Textures in pictures by rays: the probes that all renderers have, and the same bytes again.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "raster/path/picture.h"
#include "support/look_probes.h"

namespace trivet {
namespace {

testing::LookProbes probes(bool filter = false) {
  PathOptions path;
  path.filter = filter;
  return testing::LookProbes(
      [path](const PictureScene& scene, const Camera& camera, const PictureOptions& options) {
        return trace_picture(scene, camera, options, path);
      },
      64);
}

TEST(TexturedPath, ShowsImagesWhereTheyAre) { probes().shows_quadrants(); }
TEST(TexturedPath, KeepsImagesThroughTheFilter) { probes(true).shows_quadrants(); }
TEST(TexturedPath, WrapsCoordinates) { probes().wraps(); }
TEST(TexturedPath, TransformsCoordinates) { probes().transforms(); }
TEST(TexturedPath, FiltersFineCheckers) { probes().filters_fine_checkers(); }
TEST(TexturedPath, ShowsVertexColours) { probes().shows_vertex_colours(); }
TEST(TexturedPath, UsesMetalAndRoughness) { probes().uses_metal_and_roughness(); }
TEST(TexturedPath, ShowsLightOfSurfaces) { probes().glows(); }
TEST(TexturedPath, BendsNormals) { probes().bends_normals(); }
TEST(TexturedPath, CutsOut) { probes().cuts_out(); }
TEST(TexturedPath, Blends) { probes().blends(); }

TEST(TexturedPath, GivesTheSameBytesForAnyNumberOfThreads) {
  testing::Square square(0.3);
  SurfaceLook& look = square.add_look(3);
  look.images = {testing::quadrants(), testing::image_of(8, true, [](int x, int y) {
                   return testing::Texel{255, 255, 255, std::uint8_t(30 * x + y)};
                 })};
  look.finishes[0].base_colour.image = 1;
  look.finishes[0].emission.image = 0;
  look.finishes[0].emitted = {0.1f, 0.2f, 0.3f};
  look.finishes[0].transparency = Transparency::Blend;
  const PictureMesh mesh = square.view();
  PictureObject object;
  object.mesh = &mesh;
  PictureOptions options;
  options.width = 96, options.height = 64, options.samples = 4;
  Image one, many;
  tbb::task_arena(1).execute([&] { one = trace_picture({{object}, true}, std::nullopt, options); });
  tbb::task_arena(5).execute([&] {
    many = trace_picture({{object}, true}, std::nullopt, options);
  });
  EXPECT_EQ(one.rgba, many.rgba);
}

}  // namespace
}  // namespace trivet
