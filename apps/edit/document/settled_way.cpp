#include "apps/edit/document/settled_way.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "apps/edit/document/same_pose.h"

namespace trivet::edit {
namespace {

constexpr double kSmallestTurn = 1e-9;  // radians: less is a straight line

Rotation inverse(const Rotation& r) { return {r.w, -r.x, -r.y, -r.z}; }

/// What leads from one rotation to another, the short way.
struct Turn {
  Vec3 axis = Vec3::UnitZ();
  double angle = 0;  // radians, 0 to pi
};

Turn turn_between(const Rotation& from, const Rotation& to) {
  const Rotation d = (to * inverse(from)).normalized();
  const double side = d.w < 0 ? -1 : 1;
  const Vec3 v = side * Vec3(d.x, d.y, d.z);
  const double sine = v.norm();
  if (sine < 0.5 * kSmallestTurn) return {};
  return {v / sine, 2 * std::atan2(sine, side * d.w)};
}

Rotation part_of(const Turn& turn, double part) {
  return Rotation::about_axis(turn.axis, std::tan(0.5 * part * turn.angle));
}

double length_between(const Pose& from, const Pose& to, double radius) {
  return (to.translation - from.translation).norm() +
         radius * turn_between(from.rotation, to.rotation).angle;
}

// Where a PUT or a move began that tells its steps only.
std::optional<Pose> start_of(const Operation& operation, std::span<const SettleStep> steps) {
  const auto* const put = std::get_if<PutOperation>(&operation);
  if (!put) return std::nullopt;
  if (!put->place) return put->start;
  if (steps.empty() || steps.front().kind != SettleStep::Kind::Fall) return std::nullopt;
  Pose start = steps.front().pose_after;
  start.translation.z() += steps.front().energy_drop;
  return start;
}

}  // namespace

std::optional<SettledWay> settled_way(const Scene& scene, const Operation& operation,
                                      const OperationResult& result,
                                      std::span<const SettleStep> steps,
                                      const std::optional<Pose>& from) {
  const auto id = scene.find(object_name(operation));
  const auto start = from ? from : start_of(operation, steps);
  if (!result.ok() || !id || !start || steps.empty()) return std::nullopt;
  const Object& object = scene.at(*id);
  SettledWay way;
  way.size = object.scale * object.shape->box.diagonal();
  way.moved = {*id};
  for (const std::string& name : result.carried)
    if (const auto load = scene.find(name)) way.moved.push_back(*load);
  way.poses = {*start};
  for (const SettleStep& step : steps) way.poses.push_back(step.pose_after);
  if (!same_pose(way.poses.back(), object.pose)) way.poses.push_back(object.pose);
  way.lengths = {0};
  for (size_t i = 1; i < way.poses.size(); ++i)
    way.lengths.push_back(way.lengths.back() +
                          length_between(way.poses[i - 1], way.poses[i], 0.5 * way.size));
  if (!(way.length() > 0)) return std::nullopt;
  return way;
}

Pose pose_on(const SettledWay& way, double part) {
  const double at = std::clamp(part, 0.0, 1.0) * way.length();
  if (at >= way.length()) return way.poses.back();
  const auto next = std::upper_bound(way.lengths.begin(), way.lengths.end(), at);
  const auto i = static_cast<size_t>(next - way.lengths.begin());
  const double before = way.lengths[i - 1];
  return between(way.poses[i - 1], way.poses[i], (at - before) / (way.lengths[i] - before));
}

Pose carried_pose(const Pose& now, const Pose& object_end, const Pose& end) {
  const Rotation turn = (now.rotation * inverse(object_end.rotation)).normalized();
  return {(turn * end.rotation).normalized(),
          Vec3(now.translation + turn.matrix() * (end.translation - object_end.translation))};
}

Pose between(const Pose& from, const Pose& to, double part) {
  const Vec3 way = to.translation - from.translation;
  const Turn turn = turn_between(from.rotation, to.rotation);
  if (turn.angle < kSmallestTurn) return {from.rotation, Vec3(from.translation + part * way)};
  // The fixed axis goes through the point c with R (from - c) = to - c, but for what is along it.
  const Vec3 along = turn.axis.dot(way) * turn.axis;
  const Vec3 across = way - along;
  const Vec3 arm =
      -0.5 * (across + turn.axis.cross(across) / std::tan(0.5 * turn.angle));  // from - c
  const Rotation rotation = part_of(turn, part);
  return {(rotation * from.rotation).normalized(),
          Vec3(from.translation - arm + rotation.matrix() * arm + part * along)};
}

Pose straight_between(const Pose& from, const Pose& to, double part) {
  const Turn turn = turn_between(from.rotation, to.rotation);
  return {(part_of(turn, part) * from.rotation).normalized(),
          Vec3(from.translation + part * (to.translation - from.translation))};
}

}  // namespace trivet::edit
