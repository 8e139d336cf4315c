// Brackets of falls at many places, on a GPU or in software: the same bits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/contact/height_map.h"

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

/// On a GPU, which is made ready when it is first asked; where that or an answer fails, in software
/// from then on.
class GpuBrackets : public BracketSource {
 public:
  using Make = std::function<DropBracketFunction()>;
  using Note = std::function<void(const std::string&)>;

  /// @param make  may throw Error (Environment); empty: software.
  /// @param note  told, once, when software does it instead. May be empty.
  GpuBrackets(Make make, Note note);
  Answer find(const HeightMap& object, const HeightMap& scene, int columns, int rows) override;

 private:
  Make m_make;  // empty: done
  Note m_note;
  DropBracketFunction m_gpu;  // empty: not made yet, or failed
};

/// The choice of `auto`: software until it has spent as much time as it takes to make a GPU ready;
/// then two requests on the GPU, of which the second is timed, and from then on the faster one.
class FasterBrackets : public BracketSource {
 public:
  static constexpr double kStartMs = 300;
  using Clock = std::function<double()>;  // milliseconds

  /// @param clock  empty: that of the machine.
  FasterBrackets(GpuBrackets::Make make, GpuBrackets::Note note, Clock clock = {});
  Answer find(const HeightMap& object, const HeightMap& scene, int columns, int rows) override;

 private:
  enum class Stage { Collecting, WarmingUp, Timing, Software, Gpu };

  GpuBrackets m_gpu;
  Clock m_clock;
  Stage m_stage = Stage::Collecting;
  double m_software_ms = 0, m_software_pixels = 0;  // summed; pixels that were compared
};

}  // namespace trivet
