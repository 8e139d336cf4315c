// Live views of a scene: drawn again for every move of the mouse, on a GPU or on the CPU. Start
// here; what is drawn stands in live_scene.h.
//
// Beside picture.h, which shares meshes, normals and shadow maps with it: one hard-edged view and
// one shadow map with soft edges instead of many, and everything is kept from picture to picture
// that did not change: meshes, the shadow map, in drafts the objects that stand still.
#pragma once

#include <memory>

#include "gpu/egl_context.h"
#include "gpu/image.h"
#include "gpu/live_scene.h"

namespace trivet {

class LiveView {
 public:
  /// The context must outlive it, and serves several views of a scene at a time.
  explicit LiveView(EglContext& context);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  /// Rows from top to bottom. Objects out of the camera's sight are left out, for shadows too.
  /// @throws Error (BadInput) for sizes or a camera out of range; Error (Environment) when the
  ///   driver runs out of memory or refuses a shader. One thread at a time.
  Image draw(const LiveScene& scene, const LiveCamera& camera, const LiveOptions& options);

  /// What the last picture cost.
  struct Work {
    int objects_drawn = 0, objects_culled = 0;
    bool shadow_map_drawn = false;
    bool still_reused = false;  // a draft drew only what moves
    bool still_kept = false;    // a draft drew all; those that follow reuse most of it
    int meshes_sent = 0;
    int objects_as_boxes = 0;
  };
  const Work& work() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace trivet
