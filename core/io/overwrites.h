// Outputs that would overwrite an input.
#pragma once

#include <string>
#include <vector>

namespace trivet {

/// True if two paths lead to one file, through symbolic links and hard links too. Paths of files
/// that are not there yet are compared by where they lead.
bool same_file(const std::string& a, const std::string& b);

/// Refuses an output that is one of the inputs. Counted with the output is what write_scene() puts
/// beside it (the .bin of a .gltf, the .mtl of an .obj), and with the inputs what they name
/// (buffers and images of a glTF, materials of an OBJ and their maps).
/// @param inputs  models, scenes, layouts; those that cannot be read name nothing.
/// @throws Error (BadInput) naming the output and the input.
void check_not_an_input(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace trivet
