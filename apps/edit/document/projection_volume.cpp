#include "apps/edit/document/projection_volume.h"

#include <algorithm>
#include <cmath>

#include "core/candidates/zlist_frame.h"

namespace trivet::edit {
namespace {

constexpr int kPixels = 1024;
constexpr double kLongestChord = 0.15;  // radians, of arcs

/// Corner of the image: column, row and depth as in ZListFrame.
Vec3 corner(const ZListFrame& frame, double column, double row, double depth) {
  Vec3 at(column, row, depth);
  if (frame.kind == Motion::Kind::Rotation) {
    const double radius = frame.first_radius + column;
    at = Vec3(radius * std::cos(depth), radius * std::sin(depth), row);
  }
  return frame.origin + frame.image_from_world.transpose() * (frame.pixel * at);
}

/// Straight, or the arc of a turn.
void add_depth_edge(const ZListFrame& frame, double column, double row, ProjectionVolume& out) {
  const bool turns = frame.kind == Motion::Kind::Rotation;
  const int parts =
      turns ? std::max(1, static_cast<int>(std::ceil(frame.moving_depth / kLongestChord))) : 1;
  for (int i = 0; i < parts; ++i)
    out.push_back({corner(frame, column, row, frame.moving_depth * i / parts),
                   corner(frame, column, row, frame.moving_depth * (i + 1) / parts)});
}

}  // namespace

ProjectionVolume projection_volume(std::span<const Body> moving, const Motion& motion) {
  ProjectionVolume out;
  if (moving.empty()) return out;
  FirstContactQuery query;
  query.moving = query.fixed = moving;  // the whole of them is in the image
  query.motion = motion;
  const ZListFrame frame = make_zlist_frame(query, 0, kPixels);
  if (frame.empty()) return out;
  const double columns = frame.width, rows = frame.height;
  out.reserve(64);
  for (const double row : {0.0, rows})
    for (const double column : {0.0, columns}) add_depth_edge(frame, column, row, out);
  for (const double depth : {0.0, frame.moving_depth}) {
    for (const double row : {0.0, rows})
      out.push_back({corner(frame, 0, row, depth), corner(frame, columns, row, depth)});
    for (const double column : {0.0, columns})
      out.push_back({corner(frame, column, 0, depth), corner(frame, column, rows, depth)});
  }
  return out;
}

}  // namespace trivet::edit
