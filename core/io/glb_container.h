// The container of binary glTF: a header, a JSON chunk, a binary chunk.
#pragma once

#include <string>

namespace trivet {

/// Pads both chunks to 4 bytes. An empty `binary` leaves its chunk out.
/// @throws Error (BadInput) when the file would pass 4 GiB, which is all that the header can count.
std::string pack_glb(std::string json, const std::string& binary);

/// The JSON chunk of a file. @throws Error (BadInput) naming the file when it is no whole GLB.
std::string read_glb_json(const std::string& path);

/// The binary chunk behind a JSON chunk of that length; empty when there is none.
std::string read_glb_binary(const std::string& path, size_t json_bytes);

}  // namespace trivet
