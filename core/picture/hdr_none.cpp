#include "core/base/error.h"
#include "core/picture/image_files.h"

namespace trivet {

FloatImage decode_hdr(const std::string&) {
  throw Error(Error::Kind::Environment,
              "this build of trivet reads no Radiance images (libstb-dev was not installed)");
}

}  // namespace trivet
