// Answers as sentences with numbers, for agents: what happened, and what to do next.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/mcp/messages.h"
#include "core/scene/scene.h"
#include "ops/files/foreign/findings.h"

namespace trivet::mcp {

/// "(0.1, 0.2, 0.75)".
std::string point_text(const Vec3& p);

/// An object in a line: its state, what carries it, where it is, how large.
std::string object_line(const Scene& scene, ObjectId id, const LoadSupport& supports);
/// The same as data.
Json object_data(const Scene& scene, ObjectId id, const LoadSupport& supports);

/// An operation's answer of a session. @param what  "put \"cup\"".
std::string outcome_text(const std::string& what, const Json& answer, const Scene& scene);
/// Advice after a refusal of this cause; empty causes are those of bad arguments.
std::string next_step(const std::string& cause);

/// The answers to "mend" and "settle".
std::string repair_text(const std::string& what, const Json& answer);
/// The answer to "move_joint".
std::string joint_text(const Json& answer);
/// A joint, its value and limits.
std::string joint_line(const Json& joint);

/// The verdict with what to do about it.
std::string advice_on(const SceneVerdict& verdict);

}  // namespace trivet::mcp
