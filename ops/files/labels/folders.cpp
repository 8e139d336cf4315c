#include "ops/files/labels/folders.h"

namespace trivet {

std::string number_text(std::int64_t number) {
  std::string digits = std::to_string(number);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

}  // namespace trivet
