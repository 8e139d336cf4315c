// Private to gpu: what the pictures of one context share.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/picture/scene.h"
#include "gpu/picture/mesh.h"
#include "gpu/picture/programs.h"

namespace trivet {

/// Shaders, compiled when first needed, and meshes with their textures, which stay in graphics
/// memory while their models live. Needs its context to be current.
class PictureStore {
 public:
  const PicturePrograms& programs(bool emits);
  const TexturedPrograms& textured_programs();

  /// @param texture_bytes  of the scene's meshes before it.
  /// @throws Error (Environment) for lack of graphics memory.
  std::shared_ptr<const UploadedMesh> mesh(const PictureMesh& mesh, std::size_t texture_bytes);
  /// Forgets meshes that nobody draws, if textures take more than a scene's may, and those of
  /// models that are gone.
  void tidy();

  std::size_t num_sent() const { return m_num_sent; }

 private:
  struct Known {
    std::weak_ptr<const void> source;
    std::size_t max_texture_bytes;
    std::shared_ptr<const UploadedMesh> mesh;
  };
  static bool looks_the_same(const Known& known, std::size_t most);

  std::optional<PicturePrograms> m_programs[2];  // by whether surfaces give light
  std::optional<TexturedPrograms> m_textured;
  std::vector<Known> m_meshes;
  std::size_t m_num_sent = 0;
};

}  // namespace trivet
