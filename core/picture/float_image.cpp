#include "core/picture/image_files.h"

namespace trivet {

FloatImage decode_float_image(const std::string& bytes) {
  return bytes.compare(0, 2, "#?") == 0 ? decode_hdr(bytes) : decode_exr(bytes);
}

}  // namespace trivet
