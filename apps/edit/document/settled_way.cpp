#include "apps/edit/document/settled_way.h"

#include <algorithm>

#include "core/motion/compose.h"
#include "core/motion/pose_interpolation.h"
#include "ops/operations/put_parts.h"

namespace trivet::edit {

std::optional<SettledWay> settled_way(const Scene& scene, const Operation& operation,
                                      const OperationResult& result,
                                      std::span<const SettleStep> steps,
                                      const std::optional<Pose>& from) {
  const auto id = scene.find(object_name(operation));
  const auto start = from ? from : start_of_put(operation, result, steps);
  if (!result.ok() || !id || !start || steps.empty()) return std::nullopt;
  const Object& object = scene.at(*id);
  SettledWay way;
  way.size = object.scale * object.shape->box.diagonal();
  way.moved = {*id};
  for (const std::string& name : result.carried)
    if (const auto load = scene.find(name)) way.moved.push_back(*load);
  way.poses = {*start};
  for (const SettleStep& step : steps) way.poses.push_back(step.pose_after);
  if (!is_same_pose(way.poses.back(), object.pose)) way.poses.push_back(object.pose);
  way.lengths = {0};
  for (size_t i = 1; i < way.poses.size(); ++i)
    way.lengths.push_back(way.lengths.back() +
                          path_length(way.poses[i - 1], way.poses[i], 0.5 * way.size));
  if (!(way.length() > 0)) return std::nullopt;
  return way;
}

Pose pose_on(const SettledWay& way, double part) {
  const double at = std::clamp(part, 0.0, 1.0) * way.length();
  if (at >= way.length()) return way.poses.back();
  const auto next = std::upper_bound(way.lengths.begin(), way.lengths.end(), at);
  const auto i = static_cast<size_t>(next - way.lengths.begin());
  const double before = way.lengths[i - 1];
  return interpolate_pose(way.poses[i - 1], way.poses[i],
                          (at - before) / (way.lengths[i] - before));
}

}  // namespace trivet::edit
