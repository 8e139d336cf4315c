// Poses and contacts as tables, for numpy, pandas and spreadsheets, and as layouts for Isaac Lab
// Arena.
//
//   poses     a row per object: name, model, state, fixed, x, y, z, qw, qx, qy, qz, scale, up,
//             m00 ... m23, com_x, com_y, com_z, stability_margin, least_friction, material,
//             friction, density, restitution
//   contacts  a row per contact point, of both objects that touch: object, with, contact, type,
//             x, y, z, nx, ny, nz, gap
//
// World: metres, z up. x y z and the unit quaternion place the model's own coordinates: world =
// position + rotation x up x scale x file; m is the same as three rows of a matrix. `com` is the
// centre of mass. `material` is a preset's name or empty. `contact` counts the contacts of an
// object, whose points have rows of their own; the normal points to `object`; gap is of the point,
// metres; `with` may be "floor". Numbers have as many digits as give them back, 17 at most. Empty
// (JSON: null): an object that is not in the scene has no pose, a fixed one no margin; what is
// infinite is "inf" (JSON: null). In NumPy's arrays the columns are fields, and what is empty is
// NaN.
//
// A layout of Arena is a line of JSON, the poses of free objects by their names:
// {"variations": {"scene.relation_placement": {"layout_id", "source", "poses": {NAME:
// {"position_xyz": [x, y, z], "rotation_xyzw": [x, y, z, w]}}}}}. Lines of several scenes with the
// same objects make a file of layouts.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace trivet {

enum class Table { Poses, Contacts, Arena };

/// RFC 4180, first the names of the columns.
std::string table_csv(const Scene& scene, Table table);
/// A JSON object per line, with the columns as keys.
std::string table_json_lines(const Scene& scene, Table table);

/// NumPy's format: an array of records, a row each.
std::string table_npy(const Scene& scene, Table table);
/// @param id  of the layout. @throws Error (BadInput) if no free object is placed.
std::string arena_line(const Scene& scene, const std::string& id);

/// By extension, .csv, .jsonl or .npy, atomically.
/// @throws Error (BadInput): a layout of Arena elsewhere than in .jsonl; as
/// write_file_atomically().
void write_table(const Scene& scene, Table table, const std::string& path);
bool is_table_extension(const std::string& extension);

}  // namespace trivet
