// Arguments of operations, checked without a scene: files and programs accept the same.
#pragma once

#include <optional>

#include "core/base/sentence.h"
#include "ops/base/refusal.h"
#include "ops/operations/operations.h"

namespace trivet {

/// An argument out of range, by its key in layouts.
struct InvalidArgument {
  std::string key, value;
  Sentence accepted;
};

/// The first argument that is not accepted: not finite, beyond the limits of core/base/limits.h, a
/// direction without length, a rotation that is not of unit length. Names are checked against the
/// scene by perform().
std::optional<InvalidArgument> find_invalid_argument(const Operation& operation);

/// The same as a refusal.
std::optional<Refusal> validate(const Operation& operation);

}  // namespace trivet
