// Brackets of falls at many places, on a GPU or in software: the same bits.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/candidates/gpu_notes.h"
#include "core/candidates/height_map.h"

namespace trivet {

class BracketSource {
 public:
  struct Answer {
    std::vector<DropBracket> brackets;
    bool by_gpu = false;
  };

  virtual ~BracketSource() = default;
  /// See DropBracketFunction.
  virtual Answer find(const HeightMap& object, const HeightMap& scene, int columns, int rows) = 0;
};

/// On a GPU, which is made ready when it is first asked; one that is lost is made again, once for a
/// request. Where it cannot be had, in software from then on.
class GpuBrackets : public BracketSource {
 public:
  using Make = std::function<DropBracketFunction()>;

  /// @param make  may throw Error (Environment); empty: software.
  GpuBrackets(Make make, GpuNotes notes);
  Answer find(const HeightMap& object, const HeightMap& scene, int columns, int rows) override;

 private:
  std::optional<std::vector<DropBracket>> try_finding(const HeightMap& object,
                                                      const HeightMap& scene, int columns,
                                                      int rows);

  Make m_make;  // empty: it failed
  GpuNotes m_notes;
  DropBracketFunction m_gpu;  // empty: not made yet, or lost
  bool m_was_made = false;
};

/// The choice of `auto`: software until it has spent as much time as it takes to make a GPU ready;
/// then two requests on the GPU, of which the second is timed, and from then on the faster one.
class FasterBrackets : public BracketSource {
 public:
  static constexpr double kStartMs = 300;
  using Clock = std::function<double()>;  // milliseconds

  /// @param clock  empty: that of the machine.
  FasterBrackets(GpuBrackets::Make make, GpuNotes notes, Clock clock = {});
  Answer find(const HeightMap& object, const HeightMap& scene, int columns, int rows) override;

 private:
  enum class Stage { Collecting, WarmingUp, Timing, Software, Gpu };

  GpuBrackets m_gpu;
  Clock m_clock;
  Stage m_stage = Stage::Collecting;
  double m_software_ms = 0, m_software_pixels = 0;  // summed; pixels that were compared
};

}  // namespace trivet
