#include "gpu/zlist/shaders.h"

namespace trivet::zlist_shaders {
namespace {

// Drivers' built-in functions may be off by 1e-4; these by 2e-7.
// @see [Abramowitz 1964] 4.4.46, 4.4.49
const char* const kAngles = R"(
const float kHalfTurn = 3.14159265, kTurn = 6.28318531;
const float kAngleError = 6e-6;

float arc_cosine(float x) {
  float t = min(abs(x), 1.0);
  float p = -0.0012624911;
  p = p * t + 0.0066700901;
  p = p * t - 0.0170881256;
  p = p * t + 0.0308918810;
  p = p * t - 0.0501743046;
  p = p * t + 0.0889789874;
  p = p * t - 0.2145988016;
  p = p * t + 1.5707963050;
  p *= sqrt(1.0 - t);
  return x < 0.0 ? kHalfTurn - p : p;
}

float angle_of(vec2 v) {
  vec2 s = abs(v);
  float large = max(s.x, s.y);
  if (large == 0.0) return 0.0;
  float t = min(s.x, s.y) / large, q = t * t;
  float p = 0.0028662257;
  p = p * q - 0.0161657367;
  p = p * q + 0.0429096138;
  p = p * q - 0.0752896400;
  p = p * q + 0.1065626393;
  p = p * q - 0.1420889944;
  p = p * q + 0.1999355085;
  p = p * q - 0.3333314528;
  p = (p * q + 1.0) * t;
  if (s.y > s.x) p = 0.5 * kHalfTurn - p;
  if (v.x < 0.0) p = kHalfTurn - p;
  return v.y < 0.0 ? -p : p;
}

float wrapped(float angle) { return angle - kTurn * floor(angle / kTurn + 0.5); }

float sine(float angle) {
  float x = wrapped(angle);
  if (abs(x) > 0.5 * kHalfTurn) x = (x < 0.0 ? -kHalfTurn : kHalfTurn) - x;
  float q = x * x, p = -1.0 / 39916800.0;
  p = p * q + 1.0 / 362880.0;
  p = p * q - 1.0 / 5040.0;
  p = p * q + 1.0 / 120.0;
  p = p * q - 1.0 / 6.0;
  return (p * q + 1.0) * x;
}

vec2 direction_at(float angle) { return vec2(sine(angle + 0.5 * kHalfTurn), sine(angle)); }
)";

// Corners: x y across the axis, z along it. The image: radius and z.
const char* const kFace = R"(
struct Face {
  vec3 a, b, c;
  ivec4 box;
  vec3 corner_radii;
  vec2 radii, heights;  // lowest and highest
  vec2 arc;             // angles that contain the face; a whole turn or at most 3
  float bulge;          // largest inward offset of the image from the straight one
  vec3 normal;          // unit
  float normal_angle;   // of its part across the axis,
  float across;         // and how long that part is
  float level;          // normal . point
  float level_error;    // of a point of the face; negative: the plane is not used
};

// Distance of an edge from the axis.
float edge_radius(vec2 p, vec2 q) {
  vec2 e = q - p;
  float squared = dot(e, e);
  return length(p + (squared > 0.0 ? clamp(-dot(p, e) / squared, 0.0, 1.0) : 0.0) * e);
}

vec2 arc_of(Face f, float nearest) {
  if (nearest < 1e-3) return vec2(0.0, kTurn);
  float first = angle_of(f.a.xy);
  float to_b = wrapped(angle_of(f.b.xy) - first), to_c = wrapped(angle_of(f.c.xy) - first);
  vec2 arc = vec2(min(0.0, min(to_b, to_c)), max(0.0, max(to_b, to_c)));
  return arc.y - arc.x > 3.0 ? vec2(0.0, kTurn) : first + arc;
}

bool is_turn(vec2 arc) { return arc.y - arc.x > 6.0; }

void set_plane(inout Face f) {
  vec3 n = cross(f.b - f.a, f.c - f.a);
  vec3 extent = max(f.a, max(f.b, f.c)) - min(f.a, min(f.b, f.c));
  float area = length(n), squared = dot(extent, extent);
  f.level_error = -1.0;
  f.across = 0.0;
  if (squared <= 0.0 || area * kFlattest < squared) return;
  f.normal = n / area;
  f.across = length(f.normal.xy);
  f.normal_angle = angle_of(f.normal.xy);
  f.level = dot(f.normal, f.a);
  f.level_error = 20.0 * kRound * squared / area * sqrt(squared) +
                  16.0 * kRound * (f.radii.y + max(abs(f.heights.x), abs(f.heights.y)));
}

// Rows that a face may cover, lowest and highest.
vec2 rows_of(vec3 a, vec3 b, vec3 c) {
  return vec2(min(a.z, min(b.z, c.z)) - blur, max(a.z, max(b.z, c.z)) + blur);
}

Face make_face(vec3 a, vec3 b, vec3 c) {
  Face f;
  f.a = a, f.b = b, f.c = c;
  f.corner_radii = vec3(length(a.xy), length(b.xy), length(c.xy));
  float farthest = max(f.corner_radii.x, max(f.corner_radii.y, f.corner_radii.z));
  farthest *= 1.0 + 4.0 * kRound;
  float nearest = min(edge_radius(a.xy, b.xy), min(edge_radius(b.xy, c.xy), edge_radius(c.xy, a.xy)));
  nearest = max(0.0, nearest - 8.0 * kRound * farthest);
  f.arc = arc_of(f, nearest);
  float half_arc = 0.5 * (f.arc.y - f.arc.x) + kAngleError;
  f.bulge = min(farthest, 0.5 * farthest * half_arc * half_arc);
  f.radii = vec2(is_turn(f.arc) ? 0.0 : nearest, farthest);
  f.heights = vec2(min(a.z, min(b.z, c.z)), max(a.z, max(b.z, c.z)));
  f.box = pixels(vec2(f.radii.x - first_radius, f.heights.x) - blur,
                 vec2(f.radii.y - first_radius, f.heights.y) + blur);
  set_plane(f);
  return f;
}
)";

// A ring of rectangular section about the axis that bounds points of a face.
const char* const kRing = R"(
struct Ring {
  vec2 radii, heights;
};

// Distance from the axis along the normal to the plane's points in the ring, over the length of the
// normal across the axis.
vec2 reach_of_plane(Face f, Ring ring) {
  vec2 levels = (vec2(f.level) - f.normal.z * ring.heights) / f.across;
  return vec2(min(levels.x, levels.y), max(levels.x, levels.y)) +
         f.level_error / f.across * vec2(-1.0, 1.0);
}

// Cosines of the angles from the normal to the points of the plane in the ring.
vec2 cosines(Face f, Ring ring) {
  vec2 reach = reach_of_plane(f, ring);
  float low, high;
  if (ring.radii.x < 1e-3) {
    low = reach.x < 0.0 ? -2.0 : reach.x / ring.radii.y;
    high = reach.y > 0.0 ? 2.0 : reach.y / ring.radii.y;
  } else {
    low = reach.x / (reach.x < 0.0 ? ring.radii.x : ring.radii.y);
    high = reach.y / (reach.y < 0.0 ? ring.radii.y : ring.radii.x);
  }
  return vec2(low, high) + vec2(-1e-6, 1e-6);
}

// The common part of an arc and the face's; empty if the first is larger than the second.
vec2 common_arc(vec2 arc, vec2 own) {
  if (is_turn(own)) return arc;
  if (arc.y - arc.x > 3.2) return own;  // otherwise they have at most one part in common
  arc += kTurn * ceil((own.x - arc.y - kAngleError) / kTurn);
  return vec2(max(arc.x, own.x - kAngleError), min(arc.y, own.y + kAngleError));
}

// True if the line through an edge separates the face from a ball.
bool edge_excludes(Face f, vec3 p, vec3 q, vec3 centre, float radius) {
  vec3 e = q - p;
  vec3 inward = cross(f.normal, e) / max(length(e), 1e-30);
  return dot(inward, centre - p) < -radius;
}

bool face_excludes(Face f, vec3 centre, float radius) {
  return edge_excludes(f, f.a, f.b, centre, radius) || edge_excludes(f, f.b, f.c, centre, radius) ||
         edge_excludes(f, f.c, f.a, centre, radius);
}

// The image of a face is bent towards the axis by at most `bulge`.
bool image_excludes(Face f, Ring ring) {
  vec2 low = vec2(ring.radii.x, ring.heights.x), high = vec2(ring.radii.y, ring.heights.y);
  high.x += f.bulge;
  vec2 rounding = 4.0 * kRound * vec2(f.radii.y, abs(high.y));
  return misses(vec2(f.corner_radii.x, f.a.z), vec2(f.corner_radii.y, f.b.z),
                vec2(f.corner_radii.z, f.c.z), 0.5 * (low + high),
                1.00001 * (0.5 * (high - low) + rounding));
}

// Tests a ball around the part of the ring in an arc against the face's edges.
bool arc_excludes(Face f, Ring ring, vec2 arc) {
  float middle = 0.5 * (ring.radii.x + ring.radii.y), turn = 0.5 * (arc.y - arc.x) + kAngleError;
  vec3 centre = vec3(middle * direction_at(0.5 * (arc.x + arc.y)),
                     0.5 * (ring.heights.x + ring.heights.y));
  vec3 half_size = vec3(0.5 * (ring.radii.y - ring.radii.x), ring.radii.y * turn,
                        0.5 * (ring.heights.y - ring.heights.x));
  return face_excludes(f, centre, 1.0001 * length(half_size) + 2.0 * f.level_error);
}
)";

const char* const kLook = R"(
// Shifted by whole turns so that it begins in the first one.
vec2 normalised(vec2 span) { return span - kTurn * floor((span.x - first_depth) / kTurn); }

void add_span(inout Cell cell, vec2 arc, float wide) {
  vec2 span = arc + vec2(-wide, wide);
  if (span.y - span.x >= kTurn) span = first_depth + vec2(0.0, kTurn);
  cell.span[cell.num_spans++] = normalised(span);
}

void add_sample(inout Cell cell, Face f, float angle, vec2 at, float off) {
  vec3 p = vec3(at.x * direction_at(angle), at.y);
  if (face_excludes(f, p, -(2.0 * blur + 2.0 * f.level_error + kAngleError * at.x))) return;
  cell.sample_at[cell.num_samples++] = normalised(angle + vec2(-off, off));
}

void add_samples(inout Cell cell, Face f, vec2 at) {
  float c = (f.level - f.normal.z * at.y) / (f.across * at.x);
  if (abs(c) > 0.95) return;
  float off = 2.0 * (2.0 * blur + f.level_error) / (f.across * at.x * sqrt(1.0 - c * c)) +
              kAngleError;
  if (off > sample_error) return;
  float turn = arc_cosine(c);
  add_sample(cell, f, f.normal_angle + turn, at, off);
  add_sample(cell, f, f.normal_angle - turn, at, off);
}

void add_arc(inout Cell cell, Face f, Ring ring, vec2 arc, float wide) {
  vec2 own = common_arc(arc, f.arc);
  if (own.x > own.y || (f.level_error >= 0.0 && arc_excludes(f, ring, own))) return;
  add_span(cell, own, wide);
}

Cell look(Face f, ivec2 pixel) {
  Cell cell;
  cell.num_spans = cell.num_samples = 0;
  Ring ring;
  vec2 corner = vec2(first_radius + float(pixel.x), float(pixel.y));
  float rough = blur + 4.0 * kRound * corner.x;
  ring.radii = vec2(max(corner.x - rough, f.radii.x), min(corner.x + 1.0 + rough, f.radii.y));
  ring.heights = vec2(max(corner.y - rough, f.heights.x), min(corner.y + 1.0 + rough, f.heights.y));
  if (ring.radii.x > ring.radii.y || ring.heights.x > ring.heights.y) return cell;
  float wide = kAngleError + (rough < 0.5 * ring.radii.x ? 1.05 * rough / ring.radii.x : kHalfTurn);
  if (image_excludes(f, ring)) return cell;
  if (f.across < 1e-4) {
    add_arc(cell, f, ring, f.arc, wide);
    return cell;
  }
  vec2 c = cosines(f, ring);
  if (c.x > 1.0 || c.y < -1.0) return cell;
  vec2 turn = vec2(c.y < 1.0 ? arc_cosine(c.y) : 0.0, c.x > -1.0 ? arc_cosine(c.x) : kHalfTurn);
  turn += vec2(-kAngleError, kAngleError);
  if (turn.x <= 0.0) {
    add_arc(cell, f, ring, f.normal_angle + turn.y * vec2(-1.0, 1.0), wide);
  } else if (turn.y >= kHalfTurn) {
    add_arc(cell, f, ring, f.normal_angle + vec2(turn.x, kTurn - turn.x), wide);
  } else {
    add_arc(cell, f, ring, f.normal_angle + turn, wide);
    add_arc(cell, f, ring, f.normal_angle - turn.yx, wide);
  }
  if (f.across > 0.05 && corner.x > 0.0) add_samples(cell, f, corner + 0.5);
  return cell;
}
)";

}  // namespace

std::string rotation_model() { return std::string(kAngles) + kFace + kRing + kLook; }

}  // namespace trivet::zlist_shaders
