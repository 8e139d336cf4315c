// Private to gpu: passes by compute shaders over the faces and pixels of a batch, and the one
// read-back of their results. Needs OpenGL 4.3.
#pragma once

#include <map>
#include <optional>

#include "gpu/egl/gl_objects.h"
#include "gpu/zlist/batch.h"
#include "gpu/zlist/shaders.h"

namespace trivet {

class ZListPasses {
 public:
  /// @param depths  where the passes find the depths of the pixels: storage buffer 2, or textures
  /// in units 0 (moving faces) and 1 (fixed ones).
  ZListPasses(zlist_shaders::Depths depths, std::uint32_t max_entries);

  static constexpr std::size_t kMaxLayers = 256;
  std::size_t num_bytes() const;

  /// Sends the batch and binds the buffers: nothing is counted yet.
  void start(const ZListBatch& batch);
  /// Over all faces.
  void run(const ZListBatch& batch, zlist_shaders::Pass pass);
  /// The upper bounds of the time from the pixels of framebuffers.
  void find_upper_bounds(const ZListBatch& batch);
  /// Reduction and lists of the views that have more doubtful pixels than are handed over; waits
  /// for all. One read, unless the entries are many: the hardware itself decides, so that nobody
  /// waits for the number of doubtful pixels.
  std::vector<ZLists> finish(const ZListBatch& batch, ZListOutput output);

 private:
  std::vector<ZLists> read_back(const ZListBatch& batch);
  void read(std::size_t first, void* to, std::size_t bytes);
  const GlProgram& program(Motion::Kind kind, zlist_shaders::Pass pass);
  void run_job(const GlProgram& program, const ZListJob& job);
  void over_pixels(const GlProgram& program, const ZListBatch& batch);
  std::size_t first_entry(const ZListBatch& batch) const;

  zlist_shaders::Depths m_depths;
  std::uint32_t m_max_entries;
  GlBuffer m_results;  // counters, layers, entries
  GlBuffer m_large, m_instances;
  GlBuffer m_sent, m_received;  // copies of parts of the results, for the processor
  GlProgram m_reduction;
  std::optional<GlProgram> m_upper_bounds;  // made when first needed
  std::map<std::pair<Motion::Kind, zlist_shaders::Pass>, GlProgram> m_programs;
};

/// A buffer for shaders to write, which the processor does not reach: drivers keep it on the card.
GlBuffer make_storage(std::size_t bytes);

}  // namespace trivet
