#include "gpu/zlist/shaders.h"

namespace trivet::zlist_shaders {
namespace {

// Parameters of a face and its view: uniforms, or set for each face.
const char* const kInputs = R"(
QUALIFIER vec4 rows[3];        // pixels from object
QUALIFIER float blur;          // largest distance of a true point from its computed place, pixels
QUALIFIER float depth_blur;    // the same along a translation
QUALIFIER uint first_face;     // number of the body's first face in the query
QUALIFIER ivec2 size;          // of the image
QUALIFIER float first_radius;  // of the image of a turn, pixels
QUALIFIER float sample_error;  // less certain samples are rejected
QUALIFIER float period;        // of depth: a whole turn, or 0
QUALIFIER float first_depth;   // origin of angles
)";

// Each error bound counts roundings of at most kRound, relative; the factors leave a margin.
const char* const kCommon = R"(
const float kRound = 1.2e-7;     // twice the guarantee of float32: drivers may be slightly worse
const float kFlattest = 64.0;    // squared extent over area up to which a face's plane is used

// Depths of a face in a pixel: intervals that contain all of them, and samples: intervals that
// contain the depth of one of its points, on the line through the pixel's centre.
struct Cell {
  int num_spans, num_samples;
  vec2 span[2], sample_at[2];
};

vec3 place(vec3 p) {
  return vec3(dot(rows[0].xyz, p) + rows[0].w, dot(rows[1].xyz, p) + rows[1].w,
              dot(rows[2].xyz, p) + rows[2].w);
}

// First and last pixel, x y x y; empty if the first is behind the last.
ivec4 pixels(vec2 low, vec2 high) {
  vec2 top = vec2(size);
  return ivec4(max(ivec2(floor(clamp(low, vec2(-1.0), top))), ivec2(0)),
               min(ivec2(floor(clamp(high, vec2(-1.0), top))), size - 1));
}

bool is_empty(ivec4 box) { return box.x > box.z || box.y > box.w; }

// Offset to a fixed face's depths that makes them the next ones not wholly behind `rear`.
float next_turn(float high, float rear) {
  return period > 0.0 ? period * ceil((rear - high) / period - 1e-6) : 0.0;
}

bool is_behind(float high, float rear) { return period == 0.0 && high < rear; }

float below(float gap) { return gap - 2e-6 * abs(gap); }  // reduced by its rounding error

// A time by which two samples have met; false if they do not meet.
bool meet(vec2 fixed_sample, float moving_low, out float time) {
  float passed = moving_low + 2.0 * sample_error;
  float shift = period > 0.0 ? period * ceil((passed - fixed_sample.x) / period) : 0.0;
  time = fixed_sample.y + shift - moving_low;
  time += 2e-6 * abs(time);
  return fixed_sample.x + shift >= passed;
}

// True if the line through an edge separates the face from the rectangle about `centre`.
bool keeps_apart(vec2 p, vec2 q, vec2 third, vec2 centre, vec2 half_size) {
  vec2 e = q - p, d = centre - p, o = third - p;
  float at_centre = e.x * d.y - e.y * d.x, at_third = e.x * o.y - e.y * o.x;
  float wide = half_size.x * abs(e.y) + half_size.y * abs(e.x) +
               8.0 * kRound * (abs(e.x * d.y) + abs(e.y * d.x) + abs(e.x * o.y) + abs(e.y * o.x));
  return at_centre - wide > max(at_third, 0.0) || at_centre + wide < min(at_third, 0.0);
}

bool misses(vec2 a, vec2 b, vec2 c, vec2 centre, vec2 half_size) {
  return keeps_apart(a, b, c, centre, half_size) || keeps_apart(b, c, a, centre, half_size) ||
         keeps_apart(c, a, b, centre, half_size);
}
)";

// x y: image, z: depth.
const char* const kTranslation = R"(
struct Face {
  vec3 a, b, c;
  ivec4 box;
  vec2 depths;        // lowest and highest
  vec2 slope;         // of its plane
  float slope_error;  // of each component; negative: the plane is of no use
};

// Rows that a face may cover, lowest and highest.
vec2 rows_of(vec3 a, vec3 b, vec3 c) {
  return vec2(min(a.y, min(b.y, c.y)) - blur, max(a.y, max(b.y, c.y)) + blur);
}

Face make_face(vec3 a, vec3 b, vec3 c) {
  Face f;
  f.a = a, f.b = b, f.c = c;
  vec3 low = min(a, min(b, c)), high = max(a, max(b, c));
  f.box = pixels(low.xy - blur, high.xy + blur);
  f.depths = vec2(low.z, high.z);
  f.slope = vec2(0.0);
  f.slope_error = -1.0;
  vec3 u = b - a, v = c - a;
  vec2 extent = (high - low).xy;
  float area = u.x * v.y - u.y * v.x, squared = dot(extent, extent);
  if (squared > 0.0 && abs(area) * kFlattest >= squared) {
    float flatness = squared / abs(area);
    f.slope = vec2(u.z * v.y - v.z * u.y, u.x * v.z - v.x * u.z) / area;
    f.slope_error = 30.0 * kRound * flatness * flatness * (high.z - low.z) / sqrt(squared);
  }
  return f;
}

// True if a point is inside an edge by `margin`.
bool surely_inside(vec2 p, vec2 q, vec2 third, vec2 at, float margin) {
  vec2 e = q - p, d = at - p, o = third - p;
  float side = (e.x * d.y - e.y * d.x) * (e.x * o.y - e.y * o.x < 0.0 ? -1.0 : 1.0);
  return side > margin * (abs(e.x) + abs(e.y)) +
                    8.0 * kRound * (abs(e.x * d.y) + abs(e.y * d.x));
}

Cell look(Face f, ivec2 pixel) {
  Cell cell;
  cell.num_spans = cell.num_samples = 0;
  vec2 centre = vec2(pixel) + 0.5;
  float reach = 0.5 + blur;
  vec2 a = f.a.xy, b = f.b.xy, c = f.c.xy;
  if (misses(a, b, c, centre, vec2(reach))) return cell;
  vec2 depths = f.depths;
  if (f.slope_error >= 0.0) {
    vec2 d = centre - a, step = f.slope * d;
    float depth = f.a.z + step.x + step.y;
    float error = f.slope_error * (abs(d.x) + abs(d.y) + 2.0 * reach) +
                  6.0 * kRound * (abs(f.a.z) + abs(step.x) + abs(step.y));
    float steepness = abs(f.slope.x) + abs(f.slope.y);
    float half_range = 1.00001 * steepness * reach + error;
    depths = vec2(max(depths.x, depth - half_range), min(depths.y, depth + half_range));
    if (depths.x > depths.y) return cell;
    float off = error + blur * steepness + depth_blur;
    if (off <= sample_error && surely_inside(a, b, c, centre, blur) &&
        surely_inside(b, c, a, centre, blur) && surely_inside(c, a, b, centre, blur)) {
      cell.num_samples = 1;
      cell.sample_at[0] = vec2(depth - off, depth + off);
    }
  }
  cell.num_spans = 1;
  cell.span[0] = vec2(depths.x - depth_blur, depths.y + depth_blur);
  return cell;
}
)";

}  // namespace

std::string inputs(const char* qualifier) {
  return std::string("#define QUALIFIER ") + qualifier + "\n" + kInputs;
}

std::string model(Motion::Kind kind) {
  return kCommon + (kind == Motion::Kind::Translation ? kTranslation : rotation_model());
}

}  // namespace trivet::zlist_shaders
