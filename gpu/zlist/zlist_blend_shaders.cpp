#include "gpu/zlist/zlist_shaders.h"

namespace trivet::zlist_shaders {
namespace {

std::string with_version(const std::string& body) {
  return "#version 330 core\n" + inputs("uniform") + body;
}

const char* const kFaceVertex = R"(
layout(location = 0) in vec3 position;
out vec3 placed;
flat out int run;

void main() {
  placed = place(position);
  run = gl_InstanceID;
  gl_Position = vec4(0.0);
}
)";

// Edges of the quad lie between pixels, so that rounding in the rasteriser is harmless.
const char* const kQuadGeometry = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;
in vec3 placed[];
flat out vec3 corner_a, corner_b, corner_c;

void emit(int x, int y) {
  corner_a = placed[0], corner_b = placed[1], corner_c = placed[2];
  gl_Position = vec4(2.0 * vec2(x, y) / vec2(size) - 1.0, 0.0, 1.0);
  EmitVertex();
}

void main() {
  ivec4 box = make_face(placed[0], placed[1], placed[2]).box;
  if (is_empty(box)) return;
  emit(box.x, box.y);
  emit(box.z + 1, box.y);
  emit(box.x, box.w + 1);
  emit(box.z + 1, box.w + 1);
  EndPrimitive();
}
)";

// Blends maxima, so minima are negated. Moving: front, -rear, sample. Fixed: -nearest, -bound of
// the time. kNone: empty.
const char* const kFragment = R"(
flat in vec3 corner_a, corner_b, corner_c;
uniform sampler2D moving;
out vec4 depths;
const float kNone = -1e30;
bool is_none(float x) { return x < -1e29; }
)";

const char* const kMovingMain = R"(
void main() {
  Cell cell = look(make_face(corner_a, corner_b, corner_c), ivec2(gl_FragCoord.xy));
  if (cell.num_spans == 0) discard;
  depths = vec4(kNone);
  for (int i = 0; i < cell.num_spans; ++i)
    depths.xy = max(depths.xy, vec2(cell.span[i].y, -cell.span[i].x));
  for (int i = 0; i < cell.num_samples; ++i) depths.z = max(depths.z, cell.sample_at[i].x);
}
)";

const char* const kFixedMain = R"(
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 other = texelFetch(moving, pixel, 0);
  if (is_none(other.x)) discard;
  Cell cell = look(make_face(corner_a, corner_b, corner_c), pixel);
  depths = vec4(kNone);
  for (int i = 0; i < cell.num_spans; ++i) {
    float shift = next_turn(cell.span[i].y, -other.y);
    if (!is_behind(cell.span[i].y, -other.y))
      depths.x = max(depths.x, -(cell.span[i].x + shift));
  }
  if (is_none(depths.x)) discard;
  float time;
  for (int i = 0; i < cell.num_samples; ++i)
    if (!is_none(other.z) && meet(cell.sample_at[i], other.z, time)) depths.y = max(depths.y, -time);
}
)";

// The doubtful pixels come row by row. A run that exceeds its entry limit ends with an entry whose
// pixel is kTooMany.
const char* const kListGeometry = R"(
layout(triangles) in;
layout(points, max_vertices = MAX_RECORDS) out;
const uint kTooMany = 0xffffffffu;
in vec3 placed[];
flat in int run[];
uniform usamplerBuffer doubtful;  // x y
uniform int num_doubtful, pixels_per_run;
uniform float upper;
uniform sampler2D moving, nearest;
flat out uvec4 record;

)";

const char* const kMovingWanted = R"(
bool is_wanted(vec2 span, ivec2 pixel) {
  return below(-texelFetch(nearest, pixel, 0).x - span.y) <= upper;
}
)";

const char* const kFixedWanted = R"(
bool is_wanted(vec2 span, ivec2 pixel) {
  vec4 other = texelFetch(moving, pixel, 0);
  float shift = next_turn(span.y, -other.y);
  if (is_behind(span.y, -other.y)) return false;
  return below(span.x + shift - other.x) <= upper;
}
)";

const char* const kListMain = R"(
int num_records = 0;

void write(uint pixel, vec2 span) {
  record = uvec4(pixel, floatBitsToUint(span.x), floatBitsToUint(span.y),
                 first_face + uint(gl_PrimitiveIDIn));
  EmitVertex();
  EndPrimitive();
  ++num_records;
}

void list_pixel(Face face, ivec2 pixel) {
  if (any(lessThan(pixel, face.box.xy)) || any(greaterThan(pixel, face.box.zw))) return;
  Cell cell = look(face, pixel);
  for (int i = 0; i < cell.num_spans; ++i)
    if (is_wanted(cell.span[i], pixel)) write(uint(pixel.y * size.x + pixel.x), cell.span[i]);
}

void main() {
  int first = run[0] * pixels_per_run, last = min(first + pixels_per_run, num_doubtful) - 1;
  vec2 range = rows_of(placed[0], placed[1], placed[2]);
  if (range.y < float(texelFetch(doubtful, first).y) ||
      range.x > float(texelFetch(doubtful, last).y) + 1.0)
    return;
  Face face = make_face(placed[0], placed[1], placed[2]);
  if (is_empty(face.box)) return;
  for (int i = first; i <= last && num_records <= MAX_RECORDS - 3; ++i)
    list_pixel(face, ivec2(texelFetch(doubtful, i).xy));
  if (num_records > MAX_RECORDS - 3) write(kTooMany, vec2(0.0));
}
)";

}  // namespace

std::string face_vertex(Motion::Kind kind) { return with_version(model(kind) + kFaceVertex); }

std::string quad_geometry(Motion::Kind kind) { return with_version(model(kind) + kQuadGeometry); }

std::string depth_fragment(Motion::Kind kind, Pass pass) {
  return with_version(model(kind) + kFragment + (pass == Pass::Moving ? kMovingMain : kFixedMain));
}

std::string list_geometry(Motion::Kind kind, Pass pass) {
  const std::string size = "#define MAX_RECORDS " + std::to_string(kRecordsPerRun) + "\n";
  return with_version(size + model(kind) + kListGeometry +
                      (pass == Pass::MovingLists ? kMovingWanted : kFixedWanted) + kListMain);
}

}  // namespace trivet::zlist_shaders
