// Bytes as text, and back [RFC 4648].
#pragma once

#include <string>
#include <string_view>

namespace trivet {

std::string base64(std::string_view bytes);
/// Up to the first '='; characters that are no digits are skipped.
std::string decoded_base64(std::string_view text);

}  // namespace trivet
