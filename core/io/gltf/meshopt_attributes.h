// Attributes compressed by meshoptimizer in version 1 of its data, and its filter of colours: later
// than the library of Debian 12. Private.
#pragma once

#include <string>
#include <string_view>

namespace trivet::gltf {

inline constexpr char kAttributes1 = '\xa1';  // the first byte

/// @param stride  a multiple of 4, at most 256. @return `count` times `stride` bytes; empty: the
/// data is damaged. [KHR_meshopt_compression, appendix A]
std::string decoded_attributes(std::string_view bytes, size_t count, size_t stride);

/// YCoCg to RGB in place, of 4 or 8 bytes each [KHR_meshopt_compression, appendix B].
void apply_colour_filter(std::string& bytes, size_t stride);

}  // namespace trivet::gltf
