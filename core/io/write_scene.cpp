#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/error.h"
#include "core/io/gltf_builder.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

// What the JSON names comes first: a glTF in place never names a file that is not there.
void write_gltf(const ExportScene& scene, const std::filesystem::path& target) {
  const GltfFiles files = gltf_files(gltf_document(scene), target.stem().string());
  const std::filesystem::path folder = target.parent_path();
  for (const auto& [name, bytes] : files.images)
    write_file_atomically((folder / name).string(), *bytes);
  if (!files.binary.empty())
    write_file_atomically((folder / files.binary_name).string(), files.binary);
  write_file_atomically(target.string(), files.json);
}

}  // namespace

void write_scene(const ExportScene& scene, const std::string& path) {
  const std::filesystem::path target(path);
  std::string extension = target.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".glb") {
    write_file_atomically(path, glb_bytes(gltf_document(scene)));
  } else if (extension == ".gltf") {
    write_gltf(scene, target);
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
                    "; accepted are .glb, .gltf, .obj, .ply and .stl");
  }
}

}  // namespace trivet
