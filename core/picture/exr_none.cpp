#include "core/base/error.h"
#include "core/picture/image_files.h"

namespace trivet {

std::string encode_exr(int, int, int, std::span<const float>) {
  throw Error(Error::Kind::Environment,
              "this build of trivet writes no OpenEXR (libopenexr-dev was not installed); accepted "
              "for depth and normals: .png");
}

}  // namespace trivet
