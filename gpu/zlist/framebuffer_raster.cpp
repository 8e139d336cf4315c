// Depths by framebuffers, reduction and lists by compute shaders that read them.
#include "gpu/zlist/framebuffer.h"
#include "gpu/zlist/passes.h"

namespace trivet {
namespace {

class FramebufferRaster : public ZListRaster {
 public:
  explicit FramebufferRaster(std::uint32_t max_entries)
      : m_passes(zlist_shaders::Depths::Framebuffers, max_entries) {}

  const char* description() const override { return "framebuffers"; }
  std::size_t num_bytes() const override {
    return ZListFramebuffers::num_bytes() + m_passes.num_bytes();
  }
  bool has_room(std::size_t num_views, std::size_t num_bodies, int width,
                int height) const override {
    return num_views <= ZListPasses::kMaxLayers &&
           m_framebuffers.has_room(num_views, num_bodies, width, height);
  }

  std::vector<ZLists> rasterise(std::span<const ZListView> views, ZListOutput output) override {
    // The depths are drawn as with OpenGL 3.3; compute shaders read them from the textures.
    const ZListBatch batch = make_batch(views);
    const ZListTarget& target = m_framebuffers.draw(batch);
    bind_texture(1, GL_TEXTURE_2D_ARRAY, target.nearest.id());
    bind_texture(0, GL_TEXTURE_2D_ARRAY, target.moving.id());
    m_passes.start(batch);
    m_passes.find_upper_bounds(batch);
    return m_passes.finish(batch, output);
  }

 private:
  ZListFramebuffers m_framebuffers;
  ZListPasses m_passes;
};

}  // namespace

std::unique_ptr<ZListRaster> make_framebuffer_raster(std::uint32_t max_entries) {
  return std::make_unique<FramebufferRaster>(max_entries);
}

}  // namespace trivet
