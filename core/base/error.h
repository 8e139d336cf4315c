// Errors of the environment and of the user: an unreadable file, an option out of range, no EGL.
// Thrown where found, caught once in main. Hard geometry is never an Error but a status.
#pragma once

#include <stdexcept>
#include <string>

namespace trivet {

/// Message with the cause, the value and the accepted values. The kind decides the exit status.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    BadInput,     // invalid model, layout or argument: exit status 2
    Environment,  // unwritable file, no EGL, no memory: exit status 3
  };

  Error(Kind kind, const std::string& message) : std::runtime_error(message), m_kind(kind) {}
  Kind kind() const { return m_kind; }

 private:
  Kind m_kind;
};

}  // namespace trivet
