// Interactive views of a scene: redrawn for every move of the mouse, on a GPU or on the CPU. Start
// here; scene.h declares the contents.
//
// Shares meshes, normals and shadow maps with picture.h: one view without accumulation and one soft
// shadow map instead of many. Unchanged data is cached from picture to picture: meshes, the shadow
// map, in drafts the static objects.
#pragma once

#include <memory>

#include "core/base/image.h"
#include "gpu/egl/context.h"
#include "gpu/live/scene.h"

namespace trivet {

class LiveView {
 public:
  /// The context must outlive this object, and serves several views of a scene at a time.
  explicit LiveView(EglContext& context);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  /// Draws; rows from top to bottom. Objects out of sight are left out, with their shadows.
  /// @throws Error (BadInput) for sizes or a camera out of range; Error (Environment) when the
  ///   driver runs out of memory or refuses a shader. One thread at a time.
  Image draw(const LiveScene& scene, const LiveCamera& camera, const LiveOptions& options);

  /// Statistics of the last picture.
  struct Work {
    int objects_drawn = 0, objects_culled = 0;
    bool shadow_map_drawn = false;
    bool still_reused = false;  // a draft redrew only the moving objects
    bool still_kept = false;    // a draft drew all objects; the following ones reuse most of it
    int meshes_sent = 0;
    int objects_as_boxes = 0;
  };
  const Work& work() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace trivet
