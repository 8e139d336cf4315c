#include "ops/report/glb_nodes.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/base/error.h"
#include "core/io/glb_container.h"
#include "ops/layout/json_text.h"

namespace trivet {
namespace {

using nlohmann::json;

// Where the JSON chunk's text begins, and what a chunk has before its bytes.
constexpr std::streamoff kJsonStart = 20, kChunkHeader = 8;

json read_document(const std::string& path) { return parse_json(read_glb_json(path), path); }

// The second chunk; empty when there is none.
std::string read_binary(const std::string& path, size_t json_bytes) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(kJsonStart + static_cast<std::streamoff>(json_bytes));
  std::uint32_t header[2] = {0, 0};
  if (!file.read(reinterpret_cast<char*>(header), kChunkHeader)) return "";
  std::error_code error;
  std::string bytes(std::min<std::uintmax_t>(header[0], std::filesystem::file_size(path, error)),
                    '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(file.gcount()));
  return bytes;
}

const json* member(const json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto it = object.find(key);
  return it == object.end() ? nullptr : &*it;
}

std::string name_of(const json& node) {
  const json* name = member(node, "name");
  return name && name->is_string() ? name->get<std::string>() : "";
}

// One node per wanted one, with nothing but its mesh.
json reduced(json document, const std::string& path, const std::vector<std::string>& wanted) {
  std::map<std::string, json> mesh_of;
  if (const json* nodes = member(document, "nodes"); nodes && nodes->is_array())
    for (const json& node : *nodes)
      if (const json* mesh = member(node, "mesh")) mesh_of.emplace(name_of(node), *mesh);
  json nodes = json::array(), ids = json::array();
  for (const std::string& name : wanted) {
    const auto it = mesh_of.find(name);
    if (it == mesh_of.end())
      throw Error(Error::Kind::BadInput,
                  path + ": has no mesh for \"" + name + "\"; another program has changed it");
    ids.push_back(nodes.size());
    nodes.push_back({{"mesh", it->second}});
  }
  document["nodes"] = std::move(nodes);
  document["scenes"] = json::array({{{"nodes", std::move(ids)}}});
  document["scene"] = 0;
  return document;
}

std::string write_temporary(const std::string& bytes) {
  const char* const suffix = ".glb";
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) folder = "/tmp";
  std::string path = (folder / "trivet_XXXXXX").string() + suffix;
  const int descriptor = mkstemps(path.data(), static_cast<int>(std::strlen(suffix)));
  if (descriptor < 0)
    throw Error(Error::Kind::Environment,
                path + ": a temporary file cannot be written: " + std::strerror(errno));
  close(descriptor);
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return path;
  const std::string reason = std::strerror(errno);
  std::filesystem::remove(path, error);
  throw Error(Error::Kind::Environment, path + ": a temporary file cannot be written: " + reason);
}

std::vector<double> matrix_of(const json& node) {
  std::vector<double> matrix;
  const json* given = member(node, "matrix");
  if (given && given->is_array()) {
    for (const json& entry : *given) matrix.push_back(entry.is_number() ? entry.get<double>() : 0);
  } else if (!member(node, "translation") && !member(node, "rotation") && !member(node, "scale")) {
    for (int i = 0; i < 16; ++i) matrix.push_back(i % 5 == 0 ? 1 : 0);
  }
  return matrix;
}

}  // namespace

TemporaryGlb::TemporaryGlb(const std::string& path, const std::vector<std::string>& nodes) {
  const std::string text = read_glb_json(path);
  const json document = reduced(parse_json(text, path), path, nodes);
  const std::string dumped = document.dump(-1, ' ', false, json::error_handler_t::replace);
  m_path = write_temporary(pack_glb(dumped, read_binary(path, text.size())));
}

TemporaryGlb::~TemporaryGlb() {
  std::error_code ignored;
  std::filesystem::remove(m_path, ignored);
}

std::vector<NodePose> read_node_poses(const std::string& path) {
  const json document = read_document(path);
  std::vector<NodePose> poses;
  const json* nodes = member(document, "nodes");
  if (nodes && nodes->is_array())
    for (const json& node : *nodes) poses.push_back({name_of(node), matrix_of(node)});
  return poses;
}

}  // namespace trivet
