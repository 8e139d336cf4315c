// Depths by compute shaders: one thread per face, minima and maxima by atomics on ordered floats.
#include "gpu/zlist/passes.h"

namespace trivet {
namespace {

using zlist_shaders::Pass;

constexpr std::size_t kPlaneBytes = sizeof(std::uint32_t) * kMaxZListPixels;
constexpr std::uint32_t kLowest = 0, kHighest = 0xffffffffu;
/// Values of empty pixels: of front, rear, sample, nearest.
constexpr std::uint32_t kEmpty[] = {kLowest, kHighest, kLowest, kHighest};
constexpr std::size_t kNumPlanes = std::size(kEmpty);

class ComputeRaster : public ZListRaster {
 public:
  explicit ComputeRaster(std::uint32_t max_entries)
      : m_image(make_storage(kNumPlanes * kPlaneBytes)),
        m_passes(zlist_shaders::Depths::Storage, max_entries) {}

  const char* description() const override { return "compute shaders"; }
  std::size_t num_bytes() const override { return kNumPlanes * kPlaneBytes + m_passes.num_bytes(); }
  bool has_room(std::size_t num_views, std::size_t /*num_bodies*/, int width,
                int height) const override {
    return num_views <= ZListPasses::kMaxLayers &&
           num_views * static_cast<std::size_t>(width) * height <= kMaxZListPixels;
  }
  std::vector<ZLists> rasterise(std::span<const ZListView> views, ZListOutput output) override;

 private:
  void clear(const ZListBatch& batch);

  GlBuffer m_image;
  ZListPasses m_passes;
};

void ComputeRaster::clear(const ZListBatch& batch) {
  // Each plane of a batch starts with its own empty value: minima high, maxima low.
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_image.id());
  const std::size_t plane = sizeof(std::uint32_t) * batch.layers.size() * batch.layer_pixels;
  for (std::size_t i = 0; i < kNumPlanes; ++i)
    glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, static_cast<GLintptr>(i * plane),
                         static_cast<GLsizeiptr>(plane), GL_RED_INTEGER, GL_UNSIGNED_INT,
                         &kEmpty[i]);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, m_image.id());
}

std::vector<ZLists> ComputeRaster::rasterise(std::span<const ZListView> views, ZListOutput output) {
  const ZListBatch batch = make_batch(views);
  clear(batch);
  m_passes.start(batch);
  // Moving faces come first: fixed ones are looked at only where a moving one is.
  m_passes.run(batch, Pass::Moving);
  m_passes.run(batch, Pass::Fixed);
  return m_passes.finish(batch, output);
}

}  // namespace

std::unique_ptr<ZListRaster> make_compute_raster(std::uint32_t max_entries) {
  return std::make_unique<ComputeRaster>(max_entries);
}

}  // namespace trivet
