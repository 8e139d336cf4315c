// Types of the numbers in accessors; glTF 2.0, 3.6.2.2.
#pragma once

namespace trivet::gltf {

inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                     kUnsignedInt = 5125, kFloat = 5126;

}  // namespace trivet::gltf
