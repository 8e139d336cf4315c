#include "core/io/overwrites.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/gltf/builder.h"
#include "core/io/model_folder.h"
#include "core/io/opened_files.h"
#include "core/io/process/sandboxed_import.h"

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

// Layouts, reports and journals name no files that are opened like a model's.
bool is_model(const std::string& path) {
  const std::string extension = lower_extension(path);
  return !extension.empty() && extension != ".json" && extension != ".jsonl";
}

// No model names such a file; reading all models takes a while.
bool is_never_beside(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const char* const own : {".glb", ".gltf", ".obj", ".ply", ".stl", ".json"})
    if (extension == own) return true;
  return false;
}

// Reads it once in a process. One that cannot be read names nothing: whoever needs it will say so.
void open_model(const std::string& model) {
  std::error_code ignored;
  if (files_opened_for(model) || !fs::is_regular_file(model, ignored)) return;
  ImportLimits limits;
  limits.importer = find_importer();
  if (limits.importer.empty()) return;
  try {
    import_model(model, limits);
  } catch (const Error&) {
    note_opened(model, {});
  }
}

}  // namespace

void fail_as_input(const std::string& output, const std::string& model) {
  throw Error(Error::Kind::BadInput,
              "%1: is an input, named by %2, and would be overwritten; accepted: another name",
              output, model);
}

bool same_file(const std::string& a, const std::string& b) {
  struct stat of_a {
  }, of_b{};
  if (stat(a.c_str(), &of_a) == 0 && stat(b.c_str(), &of_b) == 0)
    return of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
  return canonical(a) == canonical(b);
}

void check_not_the_same(const std::string& output, const std::vector<std::string>& inputs) {
  for (const std::string& written : with_files_beside(output))
    if (std::any_of(inputs.begin(), inputs.end(),
                    [&](const std::string& input) { return same_file(written, input); }))
      throw Error(Error::Kind::BadInput,
                  "%1: is an input and would be overwritten; accepted: another name", written);
}

void check_not_an_input(const std::string& output, const std::vector<std::string>& inputs) {
  check_not_the_same(output, inputs);
  for (const std::string& written : with_files_beside(output)) {
    if (!exists(written) || is_never_beside(written)) continue;
    for (const std::string& input : inputs)
      if (is_model(input) && ModelFolder(input).holds(written)) open_model(input);
    if (const std::string model = model_that_opened(written, output); !model.empty())
      fail_as_input(written, model);
  }
}

}  // namespace trivet
