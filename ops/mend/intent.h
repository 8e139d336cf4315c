// Intent: what was meant by poses that interpenetrate and float: what stands on what, and in what.
#pragma once

#include <optional>
#include <vector>

#include "ops/arrange/shape_facts.h"
#include "ops/base/deadline.h"
#include "ops/mend/columns.h"

namespace trivet {

/// A support that an object was meant to have.
struct IntendedSupport {
  Support on;
  double share = 0;         // of the object's underside near the first contact
  bool either_way = false;  // poses do not tell which of the two lies on the other
};

struct ObjectIntent {
  ObjectId id;
  std::vector<IntendedSupport> on;  // the largest share first; none: it hangs in the air
  std::optional<ObjectId> inside;   // container that it stands in
  double gap = 0;                   // metres from its underside to its supports; negative: sunk
  Pose level;  // as it was meant to lie: turned to the nearest stable attitude, where that is near
  bool is_level = false;  // such an attitude was near
  Pose upright;           // turned to that attitude, near or not
  double tilt_deg = 0;    // from it, as given
};

struct Intent {
  double tolerance = 0;               // metres: how far poses are from what was meant
  double most_tilt_deg = 0;           // of objects that are taken to have been meant level
  std::vector<ObjectIntent> objects;  // free ones; what is below before what is above
  const ObjectIntent* find(ObjectId id) const;
};

/// From shapes, poses and what is fixed alone; nothing moves. Columns along gravity tell.
/// @param tolerance  metres; nothing: found from the gaps.
Intent infer_intent(const Scene& scene, std::optional<double> tolerance = {});
/// The same, for callers that ask for more of the shapes.
/// @param is_over  asked before each object: what comes then is of no use.
Intent infer_intent(const Scene& scene, std::optional<double> tolerance, ShapeFacts& facts,
                    const IsOver& is_over = {});

}  // namespace trivet
