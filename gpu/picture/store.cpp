#include "gpu/picture/store.h"

#include <algorithm>

#include "core/picture/mesh_values.h"

namespace trivet {

const PicturePrograms& PictureStore::programs(bool emits) {
  std::optional<PicturePrograms>& programs = m_programs[emits];
  return programs ? *programs : programs.emplace(emits);
}

const TexturedPrograms& PictureStore::textured_programs() {
  return m_textured ? *m_textured : m_textured.emplace();
}

std::shared_ptr<const UploadedMesh> PictureStore::mesh(const PictureMesh& mesh,
                                                       std::size_t texture_bytes) {
  const std::shared_ptr<const void> source = mesh.source.lock();
  const std::size_t most = texture_bytes_left(texture_bytes);
  for (const Known& known : m_meshes)
    if (source && known.source.lock() == source && looks_the_same(known, most)) return known.mesh;
  auto sent = std::make_shared<const UploadedMesh>(upload_mesh(mesh, texture_bytes));
  ++m_num_sent;
  if (source) m_meshes.push_back({source, most, sent});
  return sent;
}

// Textures that may take `most` bytes would be those that were sent. Halving sides until they fit
// leaves a quarter of the bytes at least, so that much smaller ones are whole.
bool PictureStore::looks_the_same(const Known& known, std::size_t most) {
  return known.max_texture_bytes == most ||
         8 * known.mesh->texture_bytes() <= std::min(known.max_texture_bytes, most);
}

void PictureStore::tidy() {
  std::erase_if(m_meshes, [](const Known& known) { return known.source.expired(); });
  std::size_t texture_bytes = 0;
  for (const Known& known : m_meshes) texture_bytes += known.mesh->texture_bytes();
  if (texture_bytes_left(texture_bytes) < texture_bytes_left(0))
    std::erase_if(m_meshes, [](const Known& known) { return known.mesh.use_count() == 1; });
}

}  // namespace trivet
