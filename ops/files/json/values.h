// Private. Values of operations in JSON, without their ranges: those are of
// find_invalid_argument().
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/tessellation.h"
#include "core/motion/pose.h"
#include "ops/files/json/text.h"

namespace trivet {

Vec2 read_vec2(const JsonPlace& place);
Vec3 read_vec3(const JsonPlace& place);
/// Corners of a convex polygon, counter-clockwise, within kMaxLength; of a rectangle from two.
std::vector<Vec2> read_region(const JsonPlace& place);
/// Within kMaxLength.
Vec3 read_position(const JsonPlace& place);
/// [w, x, y, z] of any length but zero.
Rotation read_rotation(const JsonPlace& place);

/// "position" and "rotation" (optional, the identity) of an object. See unit_rotation().
Pose read_pose(const JsonPlace& place);
/// Inverse of read_pose().
void write_pose(const Pose& pose, nlohmann::ordered_json& json);
/// "y" or "z".
UpAxis read_up(const JsonPlace& place);
/// "chord" and "facet_angle_deg" of a model; refused for formats of triangles.
Tessellation read_tessellation(const JsonPlace& place, const std::string& model);
/// Inverse of read_tessellation(): values that are not the default.
void write_tessellation(const Tessellation& tessellation, nlohmann::ordered_json& json);

}  // namespace trivet
