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
      bad_file(path, "is truncated: a file of " + std::to_string(bytes) + " bytes cannot hold " +
                         std::to_string(count) + " elements \"" + value + "\"");
    if (keyword == "element") expected += count;
  } while (line.substr(0, line.find_last_not_of(" \t") + 1) != "end_header");
  if (!ascii) return;
  while (found < expected && next_line(in, line)) ++found;
  if (found < expected)
    bad_file(path, "is truncated: " + std::to_string(found) + " of " + std::to_string(expected) +
                       " lines of PLY data");
}

}  // namespace

void check_file(const std::string& path, const ImportLimits& limits) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) bad_file(path, "no such file");
  if (status.type() == fs::file_type::none) bad_file(path, "cannot be read: " + error.message());
  if (status.type() == fs::file_type::directory) bad_file(path, "is a folder, not a model file");
  if (status.type() != fs::file_type::regular) bad_file(path, "is not a regular file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) bad_file(path, std::string("cannot be read: ") + std::strerror(errno));
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (error) bad_file(path, "cannot be read: " + error.message());
  if (bytes == 0) bad_file(path, "the file is empty");
  if (bytes > limits.max_file_bytes)
    bad_file(path, std::to_string(bytes) + " bytes, more than the limit of " +
                       std::to_string(limits.max_file_bytes));
  if (has_extension(path, ".ply")) check_ply(path, in, bytes);
}

void check_faces(const std::string& path, const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      const auto where = [&] {
        const std::string name = mesh.mName.C_Str();
        return "mesh " + (name.empty() ? std::to_string(m) : "'" + name + "'") + ": face " +
               std::to_string(f);
      };
      if (face.mNumIndices == 0)
        bad_file(path, where() + " has no corners; the file is broken or truncated");
      const unsigned last = *std::max_element(face.mIndices, face.mIndices + face.mNumIndices);
      if (last >= mesh.mNumVertices)
        bad_file(path, where() + " refers to vertex " + std::to_string(last) + " of " +
                           std::to_string(mesh.mNumVertices));
    }
  }
}

}  // namespace trivet
