#include "core/io/overwrites.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/gltf/builder.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::string canonical(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path : whole.string();
}

std::vector<std::string> with_files_beside(const std::string& output) {
  std::vector<std::string> out{output};
  const fs::path path(output);
  if (lower_extension(output) == ".gltf")
    out.push_back((path.parent_path() / binary_name(path.stem().string())).string());
  if (lower_extension(output) == ".obj") out.push_back(fs::path(path).replace_extension(".mtl"));
  return out;
}

std::vector<std::string> named_by_gltf(const std::string& path) {
  const GltfJson json = parse_gltf_json(path, read_gltf_text(path));
  std::vector<std::string> out;
  for (const char* const list : {"buffers", "images"})
    for (const GltfJson& item : member(json, list))
      if (const GltfJson& uri = member(item, "uri"); uri.is_string())
        if (const auto text = uri.get<std::string>(); text.rfind("data:", 0) != 0)
          out.push_back(decoded_uri(text));
  return out;
}

// The rest of a line of text after a keyword that begins like this, and its last word: options may
// stand before a name, and spaces in it.
std::vector<std::string> named_by_lines(const std::string& path, const std::string& keyword) {
  std::vector<std::string> out;
  std::ifstream in(path, std::ios::binary);
  for (std::string line; std::getline(in, line);) {
    const size_t first = line.find_first_not_of(" \t");
    if (first == line.npos || line.compare(first, keyword.size(), keyword) != 0) continue;
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const size_t end = line.find_first_of(" \t", first);
    const size_t name = end == line.npos ? line.npos : line.find_first_not_of(" \t", end);
    if (name == line.npos) continue;
    out.push_back(line.substr(name));
    if (const size_t last = line.find_last_of(" \t"); last > name)
      out.push_back(line.substr(last + 1));
  }
  return out;
}

std::vector<std::string> in_folder_of(const std::string& file, std::vector<std::string> names) {
  for (std::string& name : names) {
    std::replace(name.begin(), name.end(), '\\', '/');
    name = (fs::path(file).parent_path() / name).string();
  }
  return names;
}

std::vector<std::string> named_by(const std::string& model) {
  const std::string extension = lower_extension(model);
  if (extension == ".gltf" || extension == ".glb") return in_folder_of(model, named_by_gltf(model));
  if (extension != ".obj") return {};
  std::vector<std::string> out = in_folder_of(model, named_by_lines(model, "mtllib"));
  for (const std::string& materials : std::vector<std::string>(out))
    for (const char* const keyword : {"map_", "bump", "disp", "norm", "refl"})
      for (std::string& map : in_folder_of(materials, named_by_lines(materials, keyword)))
        out.push_back(std::move(map));
  return out;
}

// No model names such a file; looking into all models takes a while.
bool is_never_beside(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const char* const own : {".glb", ".gltf", ".obj", ".ply", ".stl", ".json"})
    if (extension == own) return true;
  return false;
}

void check_not_named(const std::string& output, const std::string& model) {
  std::error_code ignored;
  if (!fs::is_regular_file(model, ignored)) return;
  std::vector<std::string> names;
  try {
    names = named_by(model);
  } catch (const Error&) {
    return;  // reading it will say so
  }
  for (const std::string& name : names)
    if (exists(name) && same_file(output, name))
      throw Error(Error::Kind::BadInput,
                  "%1: is an input, named by %2, and would be overwritten; accepted: another name",
                  output, model);
}

}  // namespace

bool same_file(const std::string& a, const std::string& b) {
  struct stat of_a {
  }, of_b{};
  if (stat(a.c_str(), &of_a) == 0 && stat(b.c_str(), &of_b) == 0)
    return of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
  return canonical(a) == canonical(b);
}

void check_not_an_input(const std::string& output, const std::vector<std::string>& inputs) {
  for (const std::string& written : with_files_beside(output)) {
    const auto it = std::find_if(inputs.begin(), inputs.end(), [&](const std::string& input) {
      return same_file(written, input);
    });
    if (it != inputs.end())
      throw Error(Error::Kind::BadInput,
                  "%1: is an input and would be overwritten; accepted: another name", written);
    if (!exists(written) || is_never_beside(written)) continue;
    for (const std::string& input : inputs) check_not_named(written, input);
  }
}

}  // namespace trivet
