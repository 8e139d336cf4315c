#include "apps/farm/scene/model_store.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/farm/recipe/sha256.h"
#include "apps/farm/store/publish.h"
#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/json.h"
#include "core/io/model_folder.h"
#include "ops/files/json/text.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;  // of a .gltf

std::string sha256_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in || fs::is_directory(path)) bad_file(path, "cannot be read; accepted: a model file");
  Sha256 hash;
  std::string block(1 << 20, '\0');
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    hash.add({block.data(), static_cast<size_t>(in.gcount())});
  if (in.bad()) bad_file(path, "cannot be read");
  return hex(hash.digest());
}

std::string without_percent(const std::string& uri) {
  std::string out;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uri[i + 1]) != 0 &&
                       std::isxdigit(uri[i + 2]) != 0;
    out += coded ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (coded) i += 2;
  }
  return out;
}

std::vector<std::string> uris_of_gltf(const fs::path& file) {
  const auto document = json_if_valid<nlohmann::json>(read_text_file(file.string(), kMostBytes))
                            .value_or(nlohmann::json());
  std::vector<std::string> out;
  for (const char* const list : {"buffers", "images"}) {
    if (!document.is_object() || !document.contains(list) || !document[list].is_array()) continue;
    for (const nlohmann::json& item : document[list])
      if (item.is_object() && item.contains("uri") && item["uri"].is_string())
        out.push_back(without_percent(item["uri"].get<std::string>()));
  }
  return out;
}

constexpr const char* kSpaces = " \t\v\f\r\n";

// Rest of the line after the keyword, and its last word: names may have spaces, maps options before
// them.
std::vector<std::string> names_after(const fs::path& file,
                                     bool (*is_keyword)(const std::string& word)) {
  std::ifstream in(file, std::ios::binary);
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0)
      line.pop_back();
    // No stream: making one for each line takes longer than reading it.
    const size_t start = line.find_first_not_of(kSpaces), end = line.find_first_of(kSpaces, start);
    if (end == std::string::npos || !is_keyword(line.substr(start, end - start))) continue;
    const std::string rest = line.substr(line.find_first_not_of(kSpaces, end));
    out.push_back(rest);
    out.push_back(rest.substr(rest.find_last_of(" \t") + 1));
  }
  return out;
}

bool names_library(const std::string& word) { return word == "mtllib"; }
bool names_image(const std::string& word) {
  return word.rfind("map_", 0) == 0 || word == "bump" || word == "disp" || word == "decal" ||
         word == "refl" || word == "norm";
}

/// Files that it refers to, as it names them.
std::vector<std::string> references(const fs::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".gltf") return uris_of_gltf(file);
  if (extension == ".obj") return names_after(file, names_library);
  if (extension == ".mtl") return names_after(file, names_image);
  return {};
}

// Only the folder of the model and below, links followed: what the import sees.
bool is_below(const ModelFolder& seen, const fs::path& folder, const fs::path& name) {
  return !name.empty() && name.is_relative() && *name.begin() != ".." && seen.has(folder / name);
}

void add_references(const ModelFolder& seen, const fs::path& folder, const fs::path& name,
                    std::set<std::string>& found) {
  for (const std::string& reference : references(folder / name)) {
    const fs::path other = (name.parent_path() / reference).lexically_normal();
    if (!is_below(seen, folder, other)) continue;
    if (found.insert(other.generic_string()).second) add_references(seen, folder, other, found);
  }
}

std::string hash_of(const fs::path& folder, const std::string& name,
                    const std::vector<std::string>& beside) {
  std::map<std::string, std::string> lines{{name, ""}};
  for (const std::string& other : beside) lines[other];
  std::string text;
  for (const auto& [file, unused] : lines)
    text += sha256_of_file((folder / file).string()) + "  " + file + "\n";
  return sha256_hex(text);
}

}  // namespace

BatchModel batch_model(const std::string& file) {
  const fs::path path(file);
  BatchModel out{file, path.filename().string(), {}, {}, "models/"};
  std::error_code error;
  if (!fs::is_regular_file(path, error))
    bad_file(file, "is no file; accepted: a model file, relative to the recipe");
  std::set<std::string> found;
  add_references(ModelFolder(file), path.parent_path(), path.filename(), found);
  found.erase(out.name);
  out.beside.assign(found.begin(), found.end());
  out.hash = hash_of(path.parent_path(), out.name, out.beside);
  return out;
}

void store_model(const BatchModel& model, const std::string& out) {
  const fs::path target = (fs::path(out) / model.stored_path()).parent_path();
  std::error_code ignored;
  if (fs::exists(target / model.name, ignored)) return;
  const fs::path folder = fs::path(model.file).parent_path();
  PublishedFolder copy(target.string());
  copy.add_copy(model.name, (folder / model.name).string());
  for (const std::string& other : model.beside) copy.add_copy(other, (folder / other).string());
  copy.publish();
}

std::string check_stored(const std::string& out, const std::string& stored_path) {
  const fs::path file = fs::path(out) / stored_path;
  try {
    BatchModel model = batch_model(file.string());
    model.stored_in = stored_path.substr(0, stored_path.find('/') + 1);
    if (model.stored_path() == stored_path) return "";
    return stored_path + ": has other bytes than when it was stored";
  } catch (const Error& e) {
    return e.what();
  }
}

}  // namespace trivet::farm
