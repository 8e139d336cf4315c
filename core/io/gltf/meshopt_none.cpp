#include "core/base/bad_input.h"
#include "core/io/gltf/compressed.h"

namespace trivet::gltf {

std::string decoded_meshopt(std::string_view, const GltfJson&) {
  bad_input(
      "a buffer view is compressed by meshoptimizer, which this build lacks; accepted: "
      "files without EXT_meshopt_compression");
}

}  // namespace trivet::gltf
