// Text of files in the encodings that programs write.
#pragma once

#include <string>

namespace trivet {

/// The text in UTF-8 without its byte order mark. UTF-16 of either byte order is told by its mark
/// or by its zero bytes, UTF-32 by its mark; other bytes stay as they are.
std::string utf8_text(std::string bytes);

}  // namespace trivet
