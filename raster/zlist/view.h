// Drawn part of a frame's image, and the output: rows of pixels with depths.
#pragma once

#include <limits>

#include "core/candidates/zlist_frame.h"

namespace trivet {

inline constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
/// Depth on a line that misses the face.
inline constexpr float kNotMet = std::numeric_limits<float>::quiet_NaN();

/// A window of the image of a frame; pixels of the view may be smaller than the frame's (zoom).
/// Depths are the frame's in every view.
struct View {
  const ZListFrame* frame = nullptr;
  bool moving = false;         // draws moving faces: grown, and each at a single angle
  double column = 0, row = 0;  // lower left corner, in pixels of the frame
  double scale = 1;            // pixels of the view per pixel of the frame
  int width = 0, height = 0;

  static View whole(const ZListFrame& frame, bool moving) {
    return {&frame, moving, 0, 0, 1, frame.width, frame.height};
  }
  /// One pixel of this view, magnified `factor` times.
  View zoomed(int x, int y, int factor) const {
    return {frame, moving, column + x / scale, row + y / scale, scale * factor, factor, factor};
  }
  View of(bool moving_faces) const {
    View out = *this;
    out.moving = moving_faces;
    return out;
  }
  bool turning() const { return frame->kind == Motion::Kind::Rotation; }
  /// In pixels of the view.
  double growth() const { return moving ? frame->growth * scale : 0; }
};

/// Pixels first .. first + count - 1 of a row that a face touches.
struct Span {
  int row, first, count;
  const float *lower, *upper;  // depths of the face within the pixel; lower > upper: not touched
  const float* centre;         // depth on the line through the pixel's centre; or kNotMet
  float centre_error;          // bound of the error of `centre`
};

struct PixelBox {
  int first_row, last_row, first_column, last_column;
};

/// Receives the spans that a rasteriser draws.
class SpanSink {
 public:
  std::uint32_t face = 0;  // face of the following spans

  virtual void span(const Span& span) = 0;
  /// True if spans of a straight face within these pixels and depths would change nothing: they
  /// are left out then.
  virtual bool is_hidden(const PixelBox&, float /*lower*/, float /*upper*/) const { return false; }

 protected:
  ~SpanSink() = default;
};

}  // namespace trivet
