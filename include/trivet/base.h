// Vectors, poses and errors.
//
// Conventions of all headers: metres, z up, gravity along -z, right-handed, degrees; quaternions
// w x y z. A name with two frames has the target first: world_from_object.
#pragma once

#include <exception>
#include <string>

#include "trivet/version.h"

#define TRIVET_API __attribute__((visibility("default")))
// The library's own sources see this interface beside the types behind it.
#ifdef TRIVET_IMPLEMENTATION
#define TRIVET_BEGIN \
  namespace trivet { \
  namespace v0 {
#else
#define TRIVET_BEGIN \
  namespace trivet { \
  inline namespace v0 {
#endif
#define TRIVET_END \
  }                \
  }

TRIVET_BEGIN

struct Vec2 {
  double x = 0, y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// A quaternion has any length but zero where it is given, of unit length where it comes back.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// world = position + rotation applied to the object's frame.
struct Pose {
  Vec3 position;
  Quaternion rotation;
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// Axis-aligned box; empty: lower is above upper.
struct Box {
  Vec3 lower, upper;
};

/// Invalid input, or trouble with the environment; the message has the cause, the value and what is
/// accepted. A refused operation is no error but a Result.
class TRIVET_API Error : public std::exception {
 public:
  enum class Kind {
    BadInput,     // a model, a layout or an argument
    Environment,  // a file that cannot be written, no memory, a missing program
  };

  Error(Kind kind, const std::string& message);
  ~Error() override;
  [[nodiscard]] Kind kind() const { return m_kind; }
  [[nodiscard]] const char* what() const noexcept override { return m_message.c_str(); }

 private:
  Kind m_kind;
  std::string m_message;
};

/// Version of the library that is linked: "0.9.0".
[[nodiscard]] TRIVET_API const char* version();

TRIVET_END
