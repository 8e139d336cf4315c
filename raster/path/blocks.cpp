// Pixels in blocks of eight, blocks in bands of rows, bands in parallel.
#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>

#include "core/base/parallel.h"
#include "raster/path/state.h"

namespace trivet {
namespace {

constexpr int kBlockWidth = 4, kBlockHeight = 2;
constexpr int kPathRows = 8;

}  // namespace

void PathTracer::finish(const Path& path, PixelSums& sums) {
  if (!path.has_seen) return;
  const float c = path.coverage;
  sums.matt += path.albedo.cwiseProduct(path.sum_matt);
  sums.albedo += path.albedo;
  sums.bright += path.sum_bright;
  sums.coverage += c;
  sums.seen += 1;
  sums.normal += path.normal, sums.position += path.position;
  // Sums of squares give the variance, by which the filter tells noise from detail.
  const float matt = luminance(path.sum_matt), bright = luminance(path.sum_bright);
  sums.squared_matt += matt * matt, sums.squared_bright += bright * bright;
}

void PathTracer::trace_block(int x0, int y0, SumImage& image) const {
  // A cancelled picture ends at the next block.
  if (m_path.cancel && m_path.cancel->load(std::memory_order_relaxed)) throw PictureCancelled();
  std::array<PixelSums, kRayLanes> sums;
  for (int sample = 0; sample < m_options.samples; ++sample) {
    std::array<Path, kRayLanes> paths;
    // Lanes beyond the picture's border stay off.
    for (int i = 0; i < kRayLanes; ++i) {
      const int x = x0 + i % kBlockWidth, y = y0 + i / kBlockWidth;
      paths[i].on = x < image.width && y < image.height;
      if (paths[i].on) start_path(paths[i], x, y, sample);
    }
    follow(paths);
    for (int i = 0; i < kRayLanes; ++i) finish(paths[i], sums[i]);
  }
  for (int i = 0; i < kRayLanes; ++i) {
    const int x = x0 + i % kBlockWidth, y = y0 + i / kBlockWidth;
    if (x < image.width && y < image.height)
      image.pixels[std::size_t(y) * image.width + x] = sums[i];
  }
}

namespace {

/// Tells how much of a count is done, at most 256 times, from any thread; fractions grow up to 1.
class ProgressSteps {
 public:
  ProgressSteps(int count, const std::function<void(double)>& tell)
      : m_count(count), m_tell(tell) {}

  void count_one() {
    // At most 256 calls, and the last at the end.
    const int step = (m_count + 255) / 256, done = ++m_done;
    if (!m_tell || (done % step != 0 && done != m_count)) return;
    const std::lock_guard lock(m_mutex);
    // Another thread may have told more meanwhile: fractions never fall.
    if (done < m_told) return;
    m_told = done;
    m_tell(double(done) / m_count);
  }

 private:
  const int m_count;
  const std::function<void(double)>& m_tell;
  std::atomic<int> m_done = 0;
  std::mutex m_mutex;
  int m_told = 0;
};

}  // namespace

SumImage PathTracer::trace() {
  SumImage image;
  image.width = m_options.width, image.height = m_options.height;
  image.samples = m_options.samples;
  image.pixels.resize(std::size_t(image.width) * image.height);
  const int num_bands = (image.height + kPathRows - 1) / kPathRows;
  const int blocks_per_row = (image.width + kBlockWidth - 1) / kBlockWidth;
  const int block_rows = (image.height + kBlockHeight - 1) / kBlockHeight;
  ProgressSteps progress(blocks_per_row * block_rows, m_options.progress);
  // A band is one thread's work; its pixels depend on nothing but their own numbers.
  in_parallel(num_bands, [&](std::size_t band) {
    const int first = static_cast<int>(band) * kPathRows;
    for (int y = first; y < std::min(first + kPathRows, image.height); y += kBlockHeight)
      for (int x = 0; x < image.width; x += kBlockWidth) {
        trace_block(x, y, image);
        progress.count_one();
      }
  });
  return image;
}

}  // namespace trivet
