// The container of binary glTF: a header, a JSON chunk, a binary chunk.
#pragma once

#include <cstdint>
#include <string>

namespace trivet {

/// Pads both chunks to 4 bytes. An empty `binary` omits its chunk.
/// @throws Error (BadInput) if the file would exceed 4 GiB, the header's limit.
std::string pack_glb(std::string json, const std::string& binary);

/// The JSON chunk of a file. @throws Error (BadInput) naming the file if it is not a complete GLB.
std::string read_glb_json(const std::string& path);

/// The binary chunk after the JSON chunk; empty if there is none.
std::string read_glb_binary(const std::string& path);

/// 1 and 2 are other formats of the same name; 0: no binary glTF.
std::uint32_t glb_version(const std::string& path);

}  // namespace trivet
