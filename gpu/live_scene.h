// What a live view draws, as plain values: objects, cameras, colours, and overlays over them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/types.h"
#include "core/io/model.h"
#include "gpu/picture.h"

namespace trivet {

/// sRGB and straight alpha, 0 to 1.
using LiveColour = std::array<float, 4>;

struct LiveObject {
  std::shared_ptr<const Model> model;  // sent to the graphics memory once, while somebody has it
  Affine world_from_object;
  LiveColour tint{};      // mixed into its own colour by its alpha
  float opacity = 1;      // below 1 a ghost: seen through, without shadow
  bool outlined = false;  // its outline is drawn, through what hides it too
  bool moving = false;    // in a draft, drawn anew over a kept picture of all that stands still
};

/// How overlays and objects hide each other.
enum class Hidden {
  Cut,    // drawn where nothing is before it
  Faint,  // where something is, weakly
  Shown,  // everywhere alike
};

struct LiveLine {
  Vec3 from, to;
  LiveColour colour{0, 0, 0, 1};
  float width_px = 1.5f;
  Hidden hidden = Hidden::Faint;
};

/// A round point.
struct LivePoint {
  Vec3 at;
  LiveColour colour{0, 0, 0, 1};
  float radius_px = 4;
  Hidden hidden = Hidden::Faint;
};

struct LiveTriangle {
  Triangle corners;
  LiveColour colour{0, 0, 0, 1};
  Hidden hidden = Hidden::Faint;
};

struct LiveOverlay {
  std::vector<LiveTriangle> triangles;  // drawn first, in order
  std::vector<LiveLine> lines;          // then these
  std::vector<LivePoint> points;

  /// A convex polygon, its corners in order.
  void add_polygon(const std::vector<Vec3>& corners, const LiveColour& colour,
                   Hidden hidden = Hidden::Faint);
  /// The outline of corners in order.
  void add_loop(const std::vector<Vec3>& corners, const LiveColour& colour, float width_px,
                Hidden hidden = Hidden::Faint);
  /// The twelve edges of a box.
  void add_box(const Aabb& box, const LiveColour& colour, float width_px,
               Hidden hidden = Hidden::Faint);
  void append(const LiveOverlay& other);
};

struct LiveScene {
  std::vector<LiveObject> objects;
  bool floor = true;  // at z = 0, with a grid in metres
  LiveOverlay overlay;
};

/// A perspective camera or, with a height, an orthographic one.
struct LiveCamera : Camera {
  std::optional<double> height;  // metres from the lower to the upper edge
};

/// Colours of all that is not an object.
struct LiveTheme {
  LiveColour background_top, background_bottom;
  LiveColour floor, grid, axis_x, axis_y;  // alpha: how much of it
  LiveColour outline;
  float exposure = 1;            // of the objects
  float shadow_on_floor = 0.5f;  // how much of the floor's light the key light is

  static LiveTheme light();
  static LiveTheme dark();
};

struct LiveOptions {
  int width = 640, height = 360;  // pixels, 1 to 16384
  double pixel_ratio = 1;         // widths of overlays are in pixels of 1 / this
  LiveTheme theme = LiveTheme::dark();
  bool shadows = true;
  bool draft = false;  // something is dragged: be quick. No anti-aliasing, and where the camera and
                       // all that is not `moving` are those of the last draft, only the rest anew
  bool coarse = false;  // with `draft`, while the camera moves: in scenes that are too large to be
                        // drawn quickly, what looks small is drawn as its box
  int view = 0;         // which of several views this is, for what is kept from draft to draft
};

/// Metres that a pixel is wide at a point.
double metres_per_pixel(const Vec3& world, const LiveCamera& camera, double height);

/// Moved along its view until it holds the whole box.
LiveCamera framed(const LiveCamera& camera, const Aabb& box, double aspect);

}  // namespace trivet
