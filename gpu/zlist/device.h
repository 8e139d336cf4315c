// Private to gpu: all objects of z-lists that live in one context.
#pragma once

#include "gpu/egl/context.h"
#include "gpu/zlist/lists.h"
#include "gpu/zlist/stage.h"

namespace trivet {

/// Options of the context that these ask for.
EglOptions egl_options(const GpuZListOptions& options);

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
  bool in_software = false;  // software made the lists
  CandidatePairs proposal;   // valid if there is no trouble
};

/// Work after the depths. Chosen: the cheaper lists, see ListCosts.
enum class ZListWanted { Bounds, GpuLists, SoftwareLists, Chosen };

class ZListDevice {
 public:
  /// @param options  with a method other than Auto.
  explicit ZListDevice(const GpuZListOptions& options);
  ~ZListDevice();
  ZListDevice(const ZListDevice&) = delete;
  ZListDevice& operator=(const ZListDevice&) = delete;

  /// Answers queries with one kind of motion, within the available memory.
  /// @throws Error (Environment) when OpenGL fails or the hardware was reset.
  std::vector<ZListAnswer> find_candidates(std::span<const ZListAsk> asks, ZListWanted wanted);

  const ZListRaster& raster() const { return *m_raster; }
  const EglContext& context() const { return m_context; }
  int gl_version() const;
  /// The renderer, and how it is used.
  std::string description() const;

 private:
  std::vector<ZListAnswer> answer(std::span<const ZListAsk> asks, std::span<const ZListView> views,
                                  ZListWanted wanted);
  ListCosts list_costs(Motion::Kind kind);
  std::uint32_t most_handed_over(const ZListView& view, ZListWanted wanted);

  GpuZListOptions m_options;
  EglContext m_context;
  std::unique_ptr<ZListRaster> m_raster;
  std::unique_ptr<ZListMeshCache> m_meshes;
};

}  // namespace trivet
