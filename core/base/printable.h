// Bytes of untrusted files in messages, which are UTF-8 and of one line.
#pragma once

#include <string>
#include <string_view>

namespace trivet {

/// Bytes of the character that begins at `at`, 1 to 4; 0: none does [RFC 3629].
size_t utf8_length(std::string_view text, size_t at);

bool is_utf8(std::string_view text);

/// `text` for a message: white space becomes spaces, other control characters and bytes that are no
/// UTF-8 become "?". What is longer than `most` bytes ends in "...", not within a character.
std::string printable(std::string_view text, size_t most = 300);

}  // namespace trivet
