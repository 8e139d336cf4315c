// Cloths and cables judged again where they lie, among what is there now.
#pragma once

#include <vector>

#include "core/flex/judge.h"
#include "core/scene/scene.h"
#include "ops/base/outcome.h"

namespace trivet {

/// Things that came near after it had come to rest do not press on it.
/// @param id  of an object that is `flexible` and in the scene.
flex::Judgement judge_draped(const Scene& scene, ObjectId id);

/// Names in result.unsupported the cloths and cables that no longer rest on what an operation
/// touched.
/// @param touched  objects, perhaps gone.
void name_disturbed(const Scene& scene, const std::vector<ObjectId>& touched,
                    OperationResult& result);

}  // namespace trivet
