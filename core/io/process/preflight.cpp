#include "core/io/process/preflight.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

}  // namespace

void check_file(const std::string& path, const ImportLimits& limits) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) bad_file(path, "no such file");
  if (status.type() == fs::file_type::none)
    bad_file(path, "cannot be read: %1", error.message().c_str());
  if (status.type() == fs::file_type::directory) bad_file(path, "is a folder, not a model file");
  if (status.type() != fs::file_type::regular) bad_file(path, "is not a regular file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) bad_file(path, "cannot be read: %1", std::strerror(errno));
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (error) bad_file(path, "cannot be read: %1", error.message().c_str());
  if (bytes == 0) bad_file(path, "the file is empty");
  if (bytes > limits.max_file_bytes)
    bad_file(path, "%1 bytes, more than the limit of %2", bytes, limits.max_file_bytes);
}

void check_faces(const std::string& path, const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      const auto where = [&] {
        const std::string name = mesh.mName.C_Str();
        return name.empty() ? say("mesh %1: face %2", m, f) : say("mesh '%1': face %2", name, f);
      };
      if (face.mNumIndices == 0)
        bad_file(path, "%1 has no corners; the file is broken or truncated", where());
      const unsigned last = *std::max_element(face.mIndices, face.mIndices + face.mNumIndices);
      if (last >= mesh.mNumVertices)
        bad_file(path, "%1 refers to vertex %2 of %3", where(), last, mesh.mNumVertices);
    }
  }
}

}  // namespace trivet
