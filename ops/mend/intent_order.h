// Findings on each object while the intent is inferred, and the order to put them in.
// Private.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "ops/mend/columns.h"
#include "ops/mend/intent.h"

namespace trivet {

/// An object and what its columns say.
struct Looked {
  Placement level;
  ObjectIntent intent;
  Columns columns;
  std::set<std::uint32_t> above;   // slots of what it lies above
  std::set<std::uint32_t> unsure;  // slots of those of which that is a guess
};

/// The lowest z of its columns, metres.
double lowest(const Looked& l);

/// The smallest larger object that it stands in; none: its foot is in no such object's box, or that
/// does not reach above its underside.
std::optional<ObjectId> container_of(const Scene& scene, const Looked& l);

/// The lower ones first; a circle loses its weakest support.
std::vector<ObjectIntent> in_order(std::vector<Looked>& looked);

}  // namespace trivet
