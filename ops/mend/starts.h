// Poses at which an object stands or is let go: in contact with its supports, and near. Private.
#pragma once

#include <vector>

#include "ops/mend/intent.h"

namespace trivet {

/// A pose from which an object is let go, and what that costs at least, metres.
struct Start {
  double cost;
  Pose pose;
};

Pose shifted(Pose pose, double x, double y, double z);

/// `pose` lowered or lifted until it is at its first contact with what was meant to carry it,
/// exactly; as it is, if that is not within the tolerance. Supports that are not placed do not
/// count.
/// @param clearance  metres; see FirstContactQuery.
Pose in_contact(const Scene& scene, const ObjectIntent& meant, const Pose& pose, double tolerance,
                double clearance);

/// The nominal pose freed by the shortest shifts, then lifts and rings around it: level, and with
/// the attitude of the given one, which costs a little more. The cheapest first.
std::vector<Start> starts_around(const Scene& scene, const ObjectIntent& meant, const Pose& given,
                                 const Pose& nominal, double tolerance);

/// True if it is another one, or straight above it with the same attitude: it falls to the same
/// place, unless something lies between them.
bool falls_as_another(const Pose& start, const std::vector<Pose>& others);

}  // namespace trivet
