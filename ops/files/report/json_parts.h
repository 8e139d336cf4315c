// Pieces of JSON that the report and the scene file share. Doubles are written with as many digits
// as they need to come back to the same bits (17 at most), what is not finite as null.
#pragma once

#include <nlohmann/json.hpp>

#include "core/scene/scene.h"
#include "ops/base/outcome.h"
#include "ops/stability/stability.h"

namespace trivet {

using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const Vec3& v);
/// 16 numbers, row by row.
OrderedJson to_json(const Affine& affine);
/// "floor" or the names, in the order of the scene.
OrderedJson supports_json(const Scene& scene, const LoadSupport::Entry& entry);
/// The scene as a whole.
OrderedJson object_stability_json(const Scene& scene, const ObjectStability& stability);
OrderedJson stability_json(const Scene& scene, const Stability& stability);
/// "ok", "refused", "cancelled" or "out of time".
const char* to_string(OperationResult::Status status);
/// Refusal of an operation: "reason", the sentence; "cause", "objects" and "numbers" for programs.
void add_refusal(const OperationResult& result, OrderedJson& json);
/// Why an operation that was done ended, and what became of others: "ended", "blocked_by", ...
void add_outcome(const OperationResult& result, OrderedJson& json);
/// Contacts of the object.
OrderedJson contacts_json(const Scene& scene, const Object& object);

/// One entry of a report's "objects".
/// @param entry  of this object; nullptr when it is not in the scene.
/// @param model_path  as the report shall have it.
OrderedJson object_json(const Scene& scene, const Object& object, const LoadSupport::Entry* entry,
                        const std::string& model_path);

}  // namespace trivet
