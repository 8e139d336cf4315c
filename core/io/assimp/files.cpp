#include "core/io/assimp/files.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>

#include "core/io/opened_files.h"

namespace trivet {

bool FolderIoSystem::may_open(const std::string& file) const {
  constexpr size_t kMaxNames = 100;
  if (is_model(file) || m_folder.has(file)) return true;
  const bool known = std::find(m_outside.begin(), m_outside.end(), file) != m_outside.end();
  if (!known && m_outside.size() < kMaxNames && !m_folder.holds(file)) m_outside.push_back(file);
  return false;
}

bool FolderIoSystem::Exists(const char* file) const {
  return may_open(file) && DefaultIOSystem::Exists(is_model(file) ? m_model.c_str() : file);
}

Assimp::IOStream* FolderIoSystem::Open(const char* file, const char* mode) {
  const bool reads = std::string(mode).find_first_of("wa+") == std::string::npos;
  if (!reads || !may_open(file)) return nullptr;
  if (!is_model(file)) {
    note_opened(m_model, {file});
    return DefaultIOSystem::Open(file, mode);
  }
  if (!m_text) return DefaultIOSystem::Open(m_model.c_str(), mode);
  return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(m_text->data()),
                                    m_text->size());
}

}  // namespace trivet
