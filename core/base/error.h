// Errors of the environment and of the user: an unreadable file, an option out of range, no EGL.
// Thrown where found, caught once in main. Hard geometry is never an Error but a status.
#pragma once

#include <memory>
#include <stdexcept>
#include <utility>

#include "core/base/sentence.h"

namespace trivet {

/// Sentence with the cause, the value and the accepted values; what() is its English. The kind
/// decides the exit status.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    BadInput,     // invalid model, layout or argument: exit status 2
    Environment,  // unwritable file, no EGL, no memory: exit status 3
  };

  Error(Kind kind, Sentence sentence)
      : std::runtime_error(in_english(sentence)),
        m_kind(kind),
        m_sentence(std::make_shared<const Sentence>(std::move(sentence))) {}
  template <class First, class... Parts>
  Error(Kind kind, const char* pattern, First&& first, Parts&&... parts)
      : Error(kind, say(pattern, std::forward<First>(first), std::forward<Parts>(parts)...)) {}

  Kind kind() const { return m_kind; }
  const Sentence& sentence() const { return *m_sentence; }

 private:
  Kind m_kind;
  std::shared_ptr<const Sentence> m_sentence;  // shared: copies of an exception throw nothing
};

}  // namespace trivet
