#include "apps/trivet/verb_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/io/export.h"
#include "core/io/overwrites.h"
#include "ops/simulation/scene_formats.h"

namespace trivet::apps {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_write(const std::string& path) {
  throw Error(Error::Kind::Environment, "%1: cannot be written: %2", path, std::strerror(errno));
}

void check_distinct(const std::vector<std::string>& outputs,
                    const std::vector<std::string>& inputs) {
  for (size_t i = 0; i < outputs.size(); ++i) {
    for (size_t j = 0; j < i; ++j)
      if (same_file(outputs[i], outputs[j]))
        throw Error(Error::Kind::BadInput, "%1: used for two outputs; accepted: different files",
                    outputs[i]);
    trivet::check_not_the_same(outputs[i], inputs);
  }
}

// The folder that will hold it, or the nearest one above that exists: missing ones are made when
// all is written.
fs::path existing_folder(const fs::path& file) {
  std::error_code ignored;
  fs::path folder = file.parent_path();
  while (folder.has_relative_path() && !fs::exists(folder, ignored)) folder = folder.parent_path();
  return folder;
}

// Tries to make a file in a folder, and leaves none behind. @param path  to be named.
void check_takes_files(const fs::path& folder, const std::string& path) {
  const fs::path trial = folder / (".trivet_trial_" + std::to_string(getpid()));
  const int descriptor = open(trial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) fail_write(path);
  close(descriptor);
  unlink(trial.c_str());
}

void check_folder(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return check_takes_files(path, path);
  if (fs::exists(path, ignored))
    throw Error(Error::Kind::BadInput, "%1: is a file; accepted: a folder, there or not", path);
  check_takes_files(existing_folder(fs::absolute(path)), path);
}

void check_writable(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    errno = EISDIR;
    fail_write(path);
  }
  if (fs::exists(path, ignored)) {
    if (access(path.c_str(), W_OK) != 0) fail_write(path);
    if (!fs::is_regular_file(path, ignored)) return;  // a device or a pipe
  }
  // Follows a symbolic link, like the later write.
  const fs::path target = fs::weakly_canonical(fs::absolute(path), ignored);
  check_takes_files(existing_folder(ignored ? fs::absolute(path) : target), path);
}

void check_outputs(const std::vector<std::string>& outputs,
                   const std::vector<std::string>& inputs) {
  std::vector<std::string> wanted;
  for (const std::string& path : outputs)
    if (!path.empty()) wanted.push_back(path);
  check_distinct(wanted, inputs);
  for (const std::string& path : wanted) check_writable(path);
}

void check_extensions(const OutputPaths& paths) {
  using Kind = SceneFormat::Kind;
  if (!paths.scene.empty())
    check_extension(paths.scene, extensions_of({Kind::Scene, Kind::Simulator}));
  if (!paths.picture.empty()) check_extension(paths.picture, {".png"});
}

}  // namespace

void check_extension(const std::string& path, const std::vector<std::string>& accepted) {
  const std::string extension = lower_extension(path);
  if (std::find(accepted.begin(), accepted.end(), extension) != accepted.end()) return;
  std::string list;
  for (const std::string& e : accepted) list += (list.empty() ? "" : ", ") + e;
  throw Error(Error::Kind::BadInput, "%1: the extension \"%2\" is not accepted; accepted: %3", path,
              extension, list);
}

std::vector<std::string> VerbFiles::all_outputs() const {
  std::vector<std::string> out = outputs;
  for (const OutputPaths& paths : scenes)
    out.insert(out.end(), {paths.scene, paths.report, paths.picture});
  return out;
}

void check_files(const VerbFiles& files) {
  for (const OutputPaths& paths : files.scenes) {
    check_extensions(paths);
    std::vector<std::string> outputs = paths.all();
    outputs.insert(outputs.end(), files.outputs.begin(), files.outputs.end());
    check_outputs(outputs, files.inputs);
    check_files_beside(paths.scene);
  }
  if (files.scenes.empty()) check_outputs(files.outputs, files.inputs);
  for (const std::string& folder : files.folders)
    if (!folder.empty()) check_folder(folder);
}

void check_not_the_same(const std::vector<std::string>& outputs,
                        const std::vector<std::string>& inputs) {
  for (const std::string& path : outputs)
    if (!path.empty()) trivet::check_not_the_same(path, inputs);
}

void check_not_inputs(const std::vector<std::string>& outputs,
                      const std::vector<std::string>& inputs) {
  for (const std::string& path : outputs)
    if (!path.empty()) check_not_an_input(path, inputs);
}

}  // namespace trivet::apps
