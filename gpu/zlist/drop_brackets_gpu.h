// Brackets of a falling object's travel, for thousands of places at once, on the GPU.
#pragma once

#include <memory>
#include <string>

#include "core/candidates/height_map.h"
#include "gpu/egl/context.h"
#include "gpu/egl/gpu_faults.h"

namespace trivet {

/// One compute shader thread per place. Differences and minima are exact to the last bit in GLSL as
/// in C++ (4.7.1 of its specification), so the brackets equal those of the software version; a
/// self-test at construction rejects drivers that differ. One thread at a time.
class GpuDropBrackets {
 public:
  /// @throws Error (Environment): no EGL, no OpenGL 4.3, or a driver that is not exact.
  explicit GpuDropBrackets(const EglOptions& options = {}, const GpuFaults& faults = {});
  ~GpuDropBrackets();

  std::string name() const;  // of the renderer
  /// See DropBracketFunction. @throws Error (Environment) when OpenGL fails or the hardware was
  /// reset; then another one has to be made.
  std::vector<DropBracket> operator()(const HeightMap& object, const HeightMap& scene, int columns,
                                      int rows);

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace trivet
