// Labels of one view as JSON: camera, boxes, visible shares; cameras from JSON. Private.
#pragma once

#include <nlohmann/json.hpp>

#include "ops/files/json/text.h"
#include "ops/files/labels/labelled_scene.h"
#include "raster/labels/labels.h"

namespace trivet {

using OrderedJson = nlohmann::ordered_json;

/// A view with a name for files.
struct LabelView {
  std::string name;
  PinholeCamera camera;
};

/// {"convention", "width", "height", "K": 3 x 3, "camera_from_world": 4 x 4, rows; metres}.
OrderedJson camera_json(const PinholeCamera& camera);

/// Four rows: camera coordinates of a point of the object's frame; metres.
OrderedJson pose_json(const PinholeCamera& camera, const Pose& world_from_object);

/// A view of each item: of each "name", "width", "height" as wanted; and either "eye", "target"
/// and, if wanted, "up" and "fov_deg"; or "K" (3 x 3) and "camera_from_world" (3 or 4 rows of 4),
/// as camera_json() writes them. Names are 1 to 64 of a-z, A-Z, 0-9, _ and -; without they are
/// 000000, 000001, ...
/// @param width, height  where an item has none, pixels.
/// @throws Error (BadInput) naming the place, the value and what is accepted.
std::vector<LabelView> read_views(const JsonPlace& list, int width, int height);
/// A side of a picture. @throws Error (BadInput).
int read_pixels(const JsonPlace& place);

/// x, y, width, height, where pixel (i, j) covers [i, i + 1] x [j, j + 1], as COCO counts; null if
/// empty.
OrderedJson visible_box_json(const LabelBox& box);
OrderedJson whole_box_json(const LabelBox& box);

/// {"view", "camera", "classes", "objects": [{"name", "instance", "class", "class_id", "target",
///  "model_id", "attributes", "position", "rotation", "camera_from_object", "box_visible",
///  "box_whole", "pixels_visible", "pixels_alone", "visible_share"}]}. Poses as in layouts: the
/// world's frame, rotation w, x, y, z; of targets "model_id" from 1.
/// @param visibility  the last two were counted.
OrderedJson labels_json(const LabelledScene& scene, const LabelView& view, const Labels& labels,
                        bool visibility);

/// The number of the class of each pixel's object; 0: nothing or the floor.
std::vector<std::uint16_t> class_mask(const LabelledScene& scene, const Labels& labels);

/// Depths in whole units, rounded; 0: nothing, or beyond 65535 units, which are counted.
struct DepthImage {
  std::vector<std::uint16_t> units;
  std::int64_t num_beyond = 0;
};
DepthImage depth_in_units(const Labels& labels, double unit);

/// Normals as three unsigned numbers: round((n + 1) / 2 * 65534), so that 32767 is 0; all 0: none.
std::vector<std::uint16_t> packed_normals(const Labels& labels);

}  // namespace trivet
