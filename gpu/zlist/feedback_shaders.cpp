// Lists by transform feedback, with OpenGL 3.3.
#include "gpu/zlist/shaders.h"

namespace trivet::zlist_shaders {
namespace {

std::string feedback_source(const std::string& body) {
  return "#version 330 core\n" + inputs("uniform") + body;
}

const char* const kListVertex = R"(
layout(location = 0) in vec3 position;
out vec3 placed;
flat out int run;

void main() {
  placed = place(position);
  run = gl_InstanceID;
  gl_Position = vec4(0.0);
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
uniform sampler2DArray moving, nearest;
uniform int layer;
flat out uvec4 record;

)";

const char* const kMovingWanted = R"(
bool is_wanted(vec2 span, ivec2 pixel) {
  return below(-texelFetch(nearest, ivec3(pixel, layer), 0).x - span.y) <= upper;
}
)";

const char* const kFixedWanted = R"(
bool is_wanted(vec2 span, ivec2 pixel) {
  vec4 other = texelFetch(moving, ivec3(pixel, layer), 0);
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

std::string list_vertex(Motion::Kind kind) { return feedback_source(model(kind) + kListVertex); }

std::string list_geometry(Motion::Kind kind, Pass pass) {
  const std::string size = "#define MAX_RECORDS " + std::to_string(kRecordsPerRun) + "\n";
  return feedback_source(size + model(kind) + kListGeometry +
                         (pass == Pass::MovingLists ? kMovingWanted : kFixedWanted) + kListMain);
}

}  // namespace trivet::zlist_shaders
