// Where would it land, for thousands of places at once, on the graphics hardware.
#pragma once

#include <memory>
#include <string>

#include "core/contact/height_map.h"
#include "gpu/egl_context.h"

namespace trivet {

/// One thread of a compute shader per place. Differences and minima are exact to the last bit in
/// GLSL as in C++ (4.7.1 of its specification), so the brackets are those of the software; a
/// driver that computes something else is found out at the start. One thread at a time.
class GpuDropBrackets {
 public:
  /// @throws Error (Environment): no EGL, no OpenGL 4.3, or a driver that is not exact.
  explicit GpuDropBrackets(const EglOptions& options = {});
  ~GpuDropBrackets();

  std::string name() const;  // of the renderer
  /// See DropBracketFunction. @throws Error (Environment) when OpenGL fails.
  std::vector<DropBracket> operator()(const HeightMap& object, const HeightMap& scene, int columns,
                                      int rows);

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace trivet
