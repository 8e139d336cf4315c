// One operation again and again among many objects.
#pragma once

#include <string>

#include "ops/operations/operations.h"
#include "ops/session/session.h"
#include "perf/report.h"
#include "perf/result_hash.h"

namespace trivet::perf {

/// Metres; the same at all sizes: the default grows with the scene, and with it the work of a
/// contact.
inline constexpr double kScaleClearance = 2e-6;
SettleOptions scale_options();

/// Along x.
PushOperation push_of(const std::string& name, double distance);

/// Runs the operation repeatedly from the same scene. @throws std::runtime_error if it is refused.
Samples repeated(Scene& scene, const Operation& operation, ResultHash& hash);
/// Pushes the object by 1 cm and undoes that, repeatedly; the pushes are timed.
Samples session_steps(Session& session, const std::string& name);
Row check_row(const Scene& scene);

}  // namespace trivet::perf
