#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/error.h"
#include "core/io/writers.h"

namespace trivet {

void write_scene(const ExportScene& scene, const std::string& path) {
  const std::filesystem::path target(path);
  std::string extension = target.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".glb") {
    write_file_atomically(path, glb_bytes(scene));
  } else if (extension == ".obj") {
    const std::filesystem::path mtl = std::filesystem::path(target).replace_extension(".mtl");
    const ObjText text = obj_text(scene, mtl.filename().string());
    // The materials first: an OBJ in place never names a file that is not there.
    write_file_atomically(mtl.string(), text.mtl);
    write_file_atomically(path, text.obj);
  } else if (extension == ".ply") {
    write_file_atomically(path, ply_bytes(scene));
  } else if (extension == ".stl") {
    write_file_atomically(path, stl_bytes(scene));
  } else {
    throw Error(Error::Kind::BadInput,
                path + ": " + (extension.empty() ? "no extension" : "cannot write " + extension) +
                    "; accepted are .glb, .obj, .ply and .stl");
  }
}

}  // namespace trivet
