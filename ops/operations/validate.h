// Arguments of operations, checked without a scene: files and programs accept the same.
#pragma once

#include <optional>

#include "core/base/sentence.h"
#include "ops/base/refusal.h"
#include "ops/operations/operations.h"
#include "ops/operations/table.h"

namespace trivet {

/// The first argument that its table does not accept: not finite, beyond the limits of
/// core/base/limits.h, a direction without length, a rotation that is not of unit length. Names are
/// checked against the scene by perform().
std::optional<InvalidArgument> find_invalid_argument(const Operation& operation);

/// The same as a refusal.
std::optional<Refusal> validate(const Operation& operation);

}  // namespace trivet
