// Private to gpu: textures of a mesh in graphics memory, and how shaders find them.
#pragma once

#include "core/io/textures/surface_look.h"
#include "gpu/egl/gl_objects.h"

namespace trivet {

/// Locations of what a program of textured surfaces takes per material (`surface_details()` of
/// shaders.h).
struct FinishUniforms {
  explicit FinishUniforms(const GlProgram& program);
  /// Once per use of the program.
  void set_units() const;

  GLint images[4], used, sets, places, emitted, normal_scale, cutoff;
};

class SurfaceImages {
 public:
  SurfaceImages() = default;
  /// Sends all images with their smaller copies, each once.
  /// @throws Error (Environment) for lack of graphics memory.
  explicit SurfaceImages(const SurfaceLook& look);

  /// Binds what that material takes. Leaves unit 0 active.
  void bind(const FinishUniforms& uniforms, std::size_t material) const;
  /// Samplers stay bound to units: other textures there would be read through them.
  static void unbind();

  bool emits() const;
  std::size_t num_bytes() const { return m_num_bytes; }

 private:
  struct Sampled {
    GLuint texture = 0, sampler = 0;
  };
  Sampled sampled(const TextureUse& use);

  std::vector<SurfaceFinish> m_finishes;
  std::vector<std::array<Sampled, 4>> m_sampled;  // base colour, polish, normal, emission
  std::vector<GlTexture> m_textures;
  std::vector<GlSampler> m_samplers;  // by wraps and filter
  std::size_t m_num_bytes = 0;
};

}  // namespace trivet
