// Private to gpu: depths per pixel by framebuffers, with OpenGL 3.3 or later.
#pragma once

#include <map>

#include "gpu/egl/gl_objects.h"
#include "gpu/zlist/batch.h"
#include "gpu/zlist/shaders.h"

namespace trivet {

/// Float framebuffers that blend maxima: layers of two array textures, one per view.
struct ZListTarget {
  ZListTarget(int wide, int high, int deep);

  int width, height, num_layers;
  GlTexture moving;   // RGBA32F: front, -rear, sample; see shaders.h
  GlTexture nearest;  // RG32F: -nearest, -bound of the time
  GlFramebuffer moving_framebuffer, nearest_framebuffer;
};

/// Draws the faces of a batch.
class ZListFramebuffers {
 public:
  ZListFramebuffers();

  static std::size_t num_bytes();
  bool has_room(std::size_t num_views, std::size_t num_bodies, int width, int height) const;
  /// @return the target, with the depths of the batch in its lower left part; valid until the next
  /// call.
  const ZListTarget& draw(const ZListBatch& batch);

 private:
  const GlProgram& program(Motion::Kind kind, zlist_shaders::Pass pass);
  const ZListTarget& target_for(const ZListBatch& batch);
  void draw(const ZListBatch& batch, zlist_shaders::Pass pass, const ZListTarget& target);

  GlBuffer m_instances, m_layers;
  GlTexture m_instance_texels, m_layer_texels;
  std::size_t m_max_instances, m_max_layers;
  std::map<std::array<int, 3>, ZListTarget> m_targets;  // by width, height, number of layers
  std::map<std::pair<Motion::Kind, zlist_shaders::Pass>, GlProgram> m_programs;
};

}  // namespace trivet
