// Outputs that would overwrite an input.
#pragma once

#include <string>
#include <vector>

namespace trivet {

/// True if two paths lead to one file, through symbolic links and hard links too. Paths of files
/// that are not there yet are compared by where they lead.
bool same_file(const std::string& a, const std::string& b);

/// @throws Error (BadInput): the output would overwrite a file that a model names.
[[noreturn]] void fail_as_input(const std::string& output, const std::string& model);

/// Refuses an output that is one of the inputs, whatever these name: before any is read. Counted
/// with the output is what write_scene() puts beside it (the .bin of a .gltf, the .mtl of an .obj).
/// @throws Error (BadInput) naming the output.
void check_not_the_same(const std::string& output, const std::vector<std::string>& inputs);

/// The same, and counted with the inputs is what they name: buffers, materials, textures. Models
/// that nobody has read yet are read for that, if the output is there and may be one of their
/// files. Whatever is written later is looked up once more, by StagedFiles.
/// @param inputs  models, scenes, layouts; those that cannot be read name nothing.
/// @throws Error (BadInput) naming the output and the input.
void check_not_an_input(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace trivet
