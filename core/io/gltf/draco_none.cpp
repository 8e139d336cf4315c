#include "core/base/bad_input.h"
#include "core/io/gltf/compressed.h"

namespace trivet::gltf {

DracoMesh decoded_draco(std::string_view, const std::vector<DracoAttribute>&) {
  bad_input(
      "it is compressed by Draco, which this build lacks; accepted: files without "
      "KHR_draco_mesh_compression");
}

}  // namespace trivet::gltf
