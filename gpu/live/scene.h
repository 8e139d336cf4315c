// Contents of a live view as plain values: objects, cameras, colours, overlays.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/types.h"
#include "core/model/model.h"
#include "gpu/picture/picture.h"

namespace trivet {

/// sRGB and straight alpha, 0 to 1.
using LiveColour = std::array<float, 4>;

struct LiveObject {
  std::shared_ptr<const Model> model;  // uploaded once, as long as a user holds it
  Affine world_from_object;
  LiveColour tint{};      // mixed into the object's colour by its alpha
  float opacity = 1;      // below 1, a ghost: see-through, without shadow
  bool outlined = false;  // outline drawn, also where hidden
  bool moving = false;    // redrawn in drafts, over a cached picture of the static objects
};

/// Ways in which objects hide overlays.
enum class Hidden {
  Cut,    // drawn only where visible
  Faint,  // drawn faintly where hidden
  Shown,  // drawn everywhere alike
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

  /// A convex polygon, corners in order.
  void add_polygon(const std::vector<Vec3>& corners, const LiveColour& colour,
                   Hidden hidden = Hidden::Faint);
  /// The outline of these corners in order.
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
  std::optional<double> cut;  // metres along the view from the eye: objects and the floor are cut
                              // away where they are nearer, overlays are not
};

/// Colours of everything but objects.
struct LiveTheme {
  LiveColour background_top, background_bottom;
  LiveColour floor, grid, axis_x, axis_y;  // alpha: strength
  LiveColour outline;
  float exposure = 1;            // of the objects
  float shadow_on_floor = 0.5f;  // the key light's share of the light on the floor

  static LiveTheme light();
  static LiveTheme dark();
};

struct LiveOptions {
  int width = 640, height = 360;  // pixels, 1 to 16384
  double pixel_ratio = 1;         // widths of overlays are in units of 1 / this pixels
  LiveTheme theme = LiveTheme::dark();
  bool shadows = true;
  bool draft = false;   // for drags: fast, without anti-aliasing; if the camera and
                        // all objects not `moving` equal those of the last draft, only the rest is
                        // redrawn
  bool coarse = false;  // with `draft`, while the camera moves: in scenes too large to be
                        // drawn quickly, small objects are drawn as boxes
  int view = 0;         // id of the view, for caches from draft to draft
};

/// Width of a pixel at a point, in metres.
double metres_per_pixel(const Vec3& world, const LiveCamera& camera, double height);

/// Moves the camera along its view until it holds the whole box.
LiveCamera framed(const LiveCamera& camera, const Aabb& box, double aspect);

}  // namespace trivet
