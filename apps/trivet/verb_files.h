// Files that a verb reads and writes, as its arguments name them: the program checks them before
// the verb runs.
#pragma once

#include <string>
#include <vector>

namespace trivet::apps {

/// Outputs of a scene.
struct OutputPaths {
  std::string scene, report, picture;  // empty: not requested
  bool allow_unstable = false;         // an exit status of 0 though the scene does not stand

  std::vector<std::string> all() const { return {scene, report, picture}; }
};

struct VerbFiles {
  std::vector<std::string> all_outputs() const;

  std::vector<OutputPaths> scenes = {};   // one after another; their extensions are checked, too
  std::vector<std::string> outputs = {};  // others; empty ones are skipped
  std::vector<std::string> inputs = {};   // must not be overwritten
  std::vector<std::string> folders = {};  // that the verb fills; missing ones are made
};

/// @throws Error: BadInput for a wrong extension, two outputs in one file, an output that is an
/// input, a file where a folder is to be; Environment if one cannot be written.
void check_files(const VerbFiles& files);

/// For inputs that only another input names, such as the models of a layout, before they are read.
/// @throws Error (BadInput) when an output is one of them.
void check_not_the_same(const std::vector<std::string>& outputs,
                        const std::vector<std::string>& inputs);
/// The same, and counted with the inputs is what they name, such as textures.
void check_not_inputs(const std::vector<std::string>& outputs,
                      const std::vector<std::string>& inputs);

/// @throws Error (BadInput) naming the accepted extensions.
void check_extension(const std::string& path, const std::vector<std::string>& accepted);

}  // namespace trivet::apps
