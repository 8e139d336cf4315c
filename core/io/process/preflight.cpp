#include "core/io/process/preflight.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/base/extension.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

bool has_extension(const std::string& path, const std::string& wanted) {
  return lower_extension(path) == wanted;
}

/// Reads a line ended by \n, \r\n or \r; skips blank ones. False at the end of the file.
bool next_line(std::istream& in, std::string& line) {
  line.clear();
  for (int c = in.get(); c != EOF; c = in.get())
    if (c != '\n' && c != '\r')
      line += static_cast<char>(c);
    else if (line.find_first_not_of(" \t") != std::string::npos)
      return true;
    else
      line.clear();
  return !line.empty();
}

// assimp 5.2 searches forever for a missing end of the header, and if the text ends early it
// repeats the last face for each missing one.
void check_ply(const std::string& path, std::istream& in, std::uintmax_t bytes) {
  std::string line, keyword, value;
  bool ascii = false;
  std::uint64_t expected = 0, found = 0;
  do {
    if (!next_line(in, line))
      bad_file(path, "cannot be read as a model: the PLY header has no end_header");
    std::istringstream words(line);
    std::uint64_t count = 0;
    words >> keyword >> value >> count;
    if (keyword == "format") ascii = value == "ascii";
    if (keyword == "element" && count > bytes)  // each takes at least a byte
      bad_file(path, "is truncated: a file of %1 bytes cannot hold %2 elements \"%3\"", bytes,
               count, value);
    if (keyword == "element") expected += count;
  } while (line.substr(0, line.find_last_not_of(" \t") + 1) != "end_header");
  if (!ascii) return;
  while (found < expected && next_line(in, line)) ++found;
  if (found < expected) bad_file(path, "is truncated: %1 of %2 lines of PLY data", found, expected);
}

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
  if (has_extension(path, ".ply")) check_ply(path, in, bytes);
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
