// Private to gpu: all objects of z-lists that live in one context.
#pragma once

#include "gpu/egl/egl_context.h"
#include "gpu/zlist/zlist_gpu.h"
#include "gpu/zlist/zlist_lists.h"

namespace trivet {

/// A query, and the view for its lists.
struct ZListAsk {
  const FirstContactQuery* query;
  double horizon;
  ZListFrame frame;
};

enum class ZListTrouble { None, Meshes, Bodies, Entries, Pairs };
/// For people; of a trouble.
const char* to_string(ZListTrouble trouble);

struct ZListAnswer {
  ZListTrouble trouble = ZListTrouble::None;
  CandidatePairs proposal;  // valid if there is no trouble
};

class ZListDevice {
 public:
  /// @param options  with a method other than Auto.
  explicit ZListDevice(const GpuZListOptions& options);
  ~ZListDevice();
  ZListDevice(const ZListDevice&) = delete;
  ZListDevice& operator=(const ZListDevice&) = delete;

  /// Answers queries with one kind of motion, within the available memory.
  /// @param in_software  lists by GpuZListOptions::software_lists.
  /// @throws Error (Environment) when OpenGL fails or the hardware was reset.
  std::vector<ZListAnswer> find_candidates(std::span<const ZListAsk> asks, bool in_software);

  const ZListRaster& raster() const { return *m_raster; }
  const EglContext& context() const { return m_context; }
  int gl_version() const;
  /// The renderer, and how it is used.
  std::string description() const;

 private:
  std::vector<ZListAnswer> answer(std::span<const ZListAsk> asks, std::span<const ZListView> views,
                                  bool in_software);
  void check_alive() const;

  GpuZListOptions m_options;
  EglContext m_context;
  std::unique_ptr<ZListRaster> m_raster;
  std::unique_ptr<ZListMeshCache> m_meshes;
};

}  // namespace trivet
