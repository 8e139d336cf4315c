// The steps of the verdict, on bodies whose contacts are known.
#pragma once

#include "ops/stability/free_bodies.h"

namespace trivet {

/// Parts of a verdict that are asked for: all; without margins and reserves; who topples alone.
enum class Wanted { Verdict, ForcesAlone, Findings };

/// Verdict whether these bodies stand; see stability(). Those of the whole scene, or with all that
/// contacts connect with them.
Stability checked(const Scene& scene, const StabilityOptions& options, FreeBodies bodies,
                  Wanted wanted = Wanted::Verdict);

/// Metres, that the verdict counts with.
double checked_clearance(const Scene& scene, const StabilityOptions& options);

}  // namespace trivet
