#include "core/base/error.h"
#include "core/picture/image_files.h"

namespace trivet {

std::string encode_exr(int, int, int, std::span<const float>) {
  throw Error(Error::Kind::Environment,
              "this build of trivet writes no OpenEXR (libopenexr-dev was not installed); accepted "
              "for depth and normals: .png");
}

FloatImage decode_exr(const std::string&) {
  throw Error(Error::Kind::Environment,
              "this build of trivet reads no OpenEXR (libopenexr-dev was not installed)");
}

}  // namespace trivet
