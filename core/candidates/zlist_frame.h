// Image plane of a query's z-lists: shared by GPU and software before the first pixel.
//
// A motion is a shift of depth, seen along it. Image coordinates (column, row) and depth:
// - translation: (u, v) across the direction and w along it, all in pixels; time = depth x pixel;
// - rotation: radius and height about the axis, in pixels, and the angle in radians;
//   time = tan(angle / 2).
// Depth 0 is the rear of the moving bodies. Their faces have depths in [0, moving_depth] at the
// start; a moving and a fixed face come into contact on a line of sight when the moving depth has
// grown by their difference. A turn is cut open at depth 0: a moving face is given its angle in
// [0, 2 pi), from the lower end on, a fixed face every angle + 2 pi k that meets
// [0, moving_depth + reach]. So nothing else needs to know that the circle closes.
//
// Pairs stop at a distance: a stage has to grow the moving faces by `growth` pixels in the image,
// and in depth by depth_growth(). Then, where two faces stop, they share a line of sight.
#pragma once

#include "core/contact/first_contact.h"

namespace trivet {

/// Two bodies, as indices into the query's spans, whose boxes meet during the motion.
struct BodyPair {
  Index moving, fixed;
};

struct ZListFrame {
  Motion::Kind kind = Motion::Kind::Translation;
  std::vector<BodyPair> pairs;         // stage 1; by moving, then by fixed
  std::vector<Index> moving, fixed;    // bodies that are in some pair, ascending
  int width = 0, height = 0;           // of the image, in pixels; 0: nothing can touch
  double pixel = 0;                    // metres
  double growth = 0;                   // pixels, of moving faces, any direction
  double moving_depth = 0, reach = 0;  // pixels or radians; reach: of the horizon
  Mat3 image_from_world =
      Mat3::Identity();        // rows u, v, w; rotation: two across the axis, the axis
  Vec3 origin = Vec3::Zero();  // world; goes to (0, 0, 0); rotation: on the axis
  double first_radius = 0;     // pixels, at column 0 of a rotation

  bool empty() const { return width == 0; }

  /// Translation: (column, row, depth). Rotation: (x, y, row) with column = |(x, y)| -
  /// first_radius and depth = the angle of (x, y). In pixels; composed and recentred in double,
  /// so that results near the image have few digits and fit float32.
  Affine pixels_from_object(const Body& body) const;

  /// Upper bound of the change in a moving face's depths that its growth causes.
  /// @param smallest_radius  pixels; rotation only: of the part of the fixed face in question.
  double depth_growth(double smallest_radius) const;

  /// A time that is certainly not later, or not earlier, than that of a difference of depths.
  double time_before(double depth) const;
  double time_after(double depth) const;
};

/// Stage 1, and the image: the overlap of what the paired bodies' boxes cover, so that the
/// projection volume follows the moving bodies.
/// @param horizon     contacts later than this do not matter.
/// @param resolution  pixels along the longer side of the image, > 0; fewer when pixels would be
///   smaller than the clearance, or too small for float32.
ZListFrame make_zlist_frame(const FirstContactQuery& query, double horizon, int resolution);

/// The resolution at which a processor draws and pairs the query's faces fastest. (Graphics
/// hardware likes smaller pixels: it draws for nearly nothing, and pairs cost it the same.)
int zlist_resolution_of_processors(const FirstContactQuery& query);

}  // namespace trivet
