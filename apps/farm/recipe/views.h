// Cameras and images that are wanted of each scene: "views" of a recipe.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/farm/recipe/look.h"
#include "core/picture/camera_dome.h"
#include "ops/files/json/text.h"
#include "ops/files/labels/label_json.h"

namespace trivet::farm {

/// Cameras of a dome beyond DomeOptions.
struct DomeRanges {
  std::optional<Interval> radius;      // metres; none: so that all is seen
  Interval fov_deg{30, 30}, roll_deg;  // degrees; roll: the picture's turn
  bool around_targets = false;         // the box of the targets, not of the scene
};

struct Views {
  int width = 640, height = 360;   // pixels
  std::vector<LabelView> cameras;  // the same in all scenes; empty: a dome around each
  DomeOptions dome;  // its seed is drawn, scene by scene; its radius and fov are below
  DomeRanges ranges;
  std::optional<LookRanges> look;  // none: the studio's
  int samples = 16, bounces = 3;   // of pictures by rays
  double depth_unit = 0.001;       // metres per unit of depth images
  bool picture = true, depth = true, instances = true, classes = false, normals = false;

  bool any_labels() const { return depth || instances || classes || normals; }
};

/// The value of a recipe's "views". Strictly: what recipe.schema.json does not have is an error.
/// @throws Error (BadInput) naming the place, the value and what is accepted.
Views read_view_wishes(const JsonPlace& place);

/// Calls `rename` with each environment's path, and puts its result there.
/// @param views  the value of "views".
void rename_environments(nlohmann::json& views,
                         const std::function<std::string(const std::string&)>& rename);

/// Views of a file: {"views": ...}, or a recipe with them; as text, keys sorted.
/// @throws Error (BadInput), also for a file without.
std::string views_text(const std::string& text, const std::string& file);

}  // namespace trivet::farm
