#include "ops/files/inplace/scene_copy.h"

#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/printable.h"
#include "core/io/export.h"
#include "core/io/gltf/builder.h"
#include "core/io/model_folder.h"
#include "core/io/staged_files.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBeforeJson = 20;  // bytes of a .glb: its header, that of the chunk

std::string whole_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool leaves_folder(const fs::path& file) {
  const fs::path normal = file.lexically_normal();
  return file.is_absolute() || (!normal.empty() && *normal.begin() == "..");
}

// Files that the scene names go along to another folder.
void copy_companions(const GltfJson& root, const std::string& scene, const fs::path& target,
                     StagedFiles& staged) {
  const fs::path from = fs::path(scene).parent_path();
  const ModelFolder folder(scene);
  const fs::path to = target.parent_path();
  if (fs::weakly_canonical(from / ".") == fs::weakly_canonical(to / ".")) return;
  std::vector<std::string> wanted;
  for (const char* list : {"buffers", "images"})
    for (const GltfJson& item : member(root, list)) {
      const GltfJson& uri = member(item, "uri");
      if (!uri.is_string() || uri.get<std::string>().rfind("data:", 0) == 0) continue;
      const fs::path file = decoded_uri(uri.get<std::string>());
      if (leaves_folder(file))
        throw Error(Error::Kind::BadInput,
                    "the scene names \"%1\", which lies outside its folder; accepted: an output in "
                    "the scene's own folder",
                    printable(uri.get<std::string>(), 100));
      if (folder.has(from / file)) wanted.push_back(file.string());
    }
  std::erase_if(wanted, [&](const std::string& file) {
    return fs::exists(to / file) &&
           whole_file((to / file).string()) == whole_file((from / file).string());
  });
  for (const std::string& file : wanted) check_file_beside(target.string(), file);
  for (const std::string& file : wanted) {
    if (const fs::path below = (to / file).parent_path(); !below.empty())
      staged.add_folder(below.string());
    staged.add((to / file).string(), whole_file((from / file).string()));
  }
}

// By its content, as readers take it: names of either kind are given to both.
bool is_text(const std::string& scene) {
  const std::size_t begin = scene.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  const std::size_t first = scene.find_first_not_of(" \t\r\n", begin);
  return first != std::string::npos && scene[first] == '{';
}

// The same container with another JSON chunk; all other chunks byte for byte.
// @param glb  what is in the file now; it was read from before, and may be another one by now.
std::string with_json(const std::string& file, const std::string& glb, std::string json) {
  std::uint32_t old_json = 0;
  if (glb.size() >= kBeforeJson) std::memcpy(&old_json, glb.data() + 12, sizeof old_json);
  if (glb.size() < kBeforeJson + old_json || glb.compare(0, 4, "glTF") != 0)
    throw Error(Error::Kind::Environment,
                "%1: has changed since it was read; accepted: a scene that stays as it is", file);
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::string rest = glb.substr(kBeforeJson + old_json);
  const auto total = static_cast<std::uint32_t>(kBeforeJson + json.size() + rest.size());
  const auto length = static_cast<std::uint32_t>(json.size());
  std::string out = glb.substr(0, 8);
  out.append(reinterpret_cast<const char*>(&total), 4);
  out.append(reinterpret_cast<const char*>(&length), 4);
  out += glb.substr(16, 4);
  return out + json + rest;
}

}  // namespace

void write_scene_copy(const std::string& from, const GltfJson& original, const GltfJson& json,
                      const std::string& to) {
  if (lower_extension(to) != lower_extension(from))
    throw Error(Error::Kind::BadInput, "%1: the scene stays what it is; accepted: %2", to,
                lower_extension(from));
  const std::string scene = whole_file(from);
  const bool stays_text = is_text(scene);
  const std::string text =
      json.dump(stays_text ? 1 : -1, ' ', false, GltfJson::error_handler_t::replace);
  StagedFiles staged(to);
  copy_companions(original, from, to, staged);
  staged.add(to, stays_text ? text : with_json(from, scene, text));
  staged.commit();
}

}  // namespace trivet
