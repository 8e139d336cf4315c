// Errors of bad input.
#pragma once

#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/sentence.h"

namespace trivet {

[[noreturn]] inline void bad_input(Sentence sentence) {
  throw Error(Error::Kind::BadInput, std::move(sentence));
}
template <class First, class... Parts>
[[noreturn]] void bad_input(const char* pattern, First&& first, Parts&&... parts) {
  bad_input(say(pattern, std::forward<First>(first), std::forward<Parts>(parts)...));
}

inline void require(bool holds, const Sentence& otherwise) {
  if (!holds) bad_input(otherwise);
}

/// "path: reason".
[[noreturn]] inline void bad_file(const std::string& path, Sentence reason) {
  bad_input("%1: %2", path, std::move(reason));
}
template <class First, class... Parts>
[[noreturn]] void bad_file(const std::string& path, const char* pattern, First&& first,
                           Parts&&... parts) {
  bad_file(path, say(pattern, std::forward<First>(first), std::forward<Parts>(parts)...));
}

}  // namespace trivet
