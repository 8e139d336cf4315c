#include "ops/base/names.h"

#include <algorithm>

#include "core/base/printable.h"

namespace trivet {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

bool is_object_name(const std::string& name) {
  return !name.empty() && name != "floor" && std::none_of(name.begin(), name.end(), is_control) &&
         is_utf8(name);
}

}  // namespace trivet
