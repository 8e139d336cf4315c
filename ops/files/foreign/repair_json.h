// Meanings of poses, and moves of joints, as JSON.
#pragma once

#include "core/io/json.h"
#include "ops/files/foreign/open_scene.h"
#include "ops/mend/intent.h"

namespace trivet {

/// {"tolerance", "objects": [{"object", "on": [{"object", "share"}], "in", "gap", "level",
/// "tilt_deg"}]}
nlohmann::ordered_json intent_json(const Scene& scene, const Intent& intent);

/// {"joint", "kind", "value", "lower", "upper", "links"}; limits that are not there are null.
nlohmann::ordered_json joint_json(const Scene& scene, const SceneJoint& joint);
/// The same with "end", "carried" and, where it was blocked, "blocked_by" and "blocked_at".
nlohmann::ordered_json joint_move_json(const Scene& scene, double lift, const SceneJoint& joint,
                                       const JointMove& move);

}  // namespace trivet
