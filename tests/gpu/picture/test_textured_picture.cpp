// Textures in pictures by OpenGL: the probes that all renderers have.
#include "core/base/error.h"
#include "gpu/picture/picture.h"
#include "support/look_probes.h"
#include "support/mesa_leaks.h"

namespace trivet {
namespace {

class TexturedPicture : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      m_context = std::make_unique<EglContext>();
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  testing::LookProbes probes() const {
    return testing::LookProbes(
        [this](const PictureScene& scene, const Camera& camera, const PictureOptions& options) {
          return render_picture(*m_context, scene, camera, options);
        },
        16);
  }
  std::unique_ptr<EglContext> m_context;
};

TEST_F(TexturedPicture, ShowsImagesWhereTheyAre) { probes().shows_quadrants(); }
TEST_F(TexturedPicture, WrapsCoordinates) { probes().wraps(); }
TEST_F(TexturedPicture, TransformsCoordinates) { probes().transforms(); }
TEST_F(TexturedPicture, FiltersFineCheckers) { probes().filters_fine_checkers(); }
TEST_F(TexturedPicture, ShowsVertexColours) { probes().shows_vertex_colours(); }
TEST_F(TexturedPicture, UsesMetalAndRoughness) { probes().uses_metal_and_roughness(); }
TEST_F(TexturedPicture, ShowsLightOfSurfaces) { probes().glows(); }
TEST_F(TexturedPicture, BendsNormals) { probes().bends_normals(); }
TEST_F(TexturedPicture, CutsOut) { probes().cuts_out(); }
TEST_F(TexturedPicture, Blends) { probes().blends(); }

}  // namespace
}  // namespace trivet
