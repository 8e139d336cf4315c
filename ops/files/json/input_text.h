// Text from files and pipes.
#pragma once

#include <cstdint>
#include <string>

namespace trivet {

/// Json: reading ends early where it is clear that the text is none.
enum class TextKind { Any, Json };

/// The whole file; pipes too, as long as they are open for writing.
/// @throws Error (BadInput): missing, a folder, unreadable, larger than `max_bytes`; a named pipe
///   not opened for writing within 10 s.
std::string read_input_text(const std::string& path, std::uintmax_t max_bytes, TextKind kind);

}  // namespace trivet
