// Depths per pixel by framebuffers, with OpenGL 3.3: one quad per face, over the pixels it may
// cover.
#include "gpu/zlist/shaders.h"

namespace trivet::zlist_shaders {
namespace {

// The structs of structs.h as texels; there are no storage buffers before OpenGL 4.3.
const char* const kLoad = R"(
uniform usamplerBuffer instances, layers;
int layer;

void load_instance(int i) {
  for (int k = 0; k < 3; ++k) rows[k] = uintBitsToFloat(texelFetch(instances, 4 * i + k));
  uvec4 body = texelFetch(instances, 4 * i + 3);
  blur = uintBitsToFloat(body.x);
  depth_blur = uintBitsToFloat(body.y);
  first_face = body.z;
  layer = int(body.w);
  uvec4 view = texelFetch(layers, 4 * layer), depths = texelFetch(layers, 4 * layer + 1);
  size = ivec2(view.xy);
  first_radius = uintBitsToFloat(view.z);
  sample_error = uintBitsToFloat(view.w);
  period = uintBitsToFloat(depths.x);
  first_depth = uintBitsToFloat(depths.y);
}
)";

const char* const kFaceVertex = R"(
layout(location = 0) in vec3 position;
uniform int first_instance;
out vec3 placed;
flat out int instance;

void main() {
  instance = first_instance + gl_InstanceID;
  load_instance(instance);
  placed = place(position);
  gl_Position = vec4(0.0);
}
)";

// Edges of the quad lie between pixels, so that rounding in the rasteriser is harmless.
const char* const kQuadGeometry = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;
in vec3 placed[];
flat in int instance[];
uniform ivec2 target_size;
flat out vec3 corner_a, corner_b, corner_c;
flat out int body;

void emit(int x, int y) {
  corner_a = placed[0], corner_b = placed[1], corner_c = placed[2];
  body = instance[0];
  gl_Layer = layer;
  gl_Position = vec4(2.0 * vec2(x, y) / vec2(target_size) - 1.0, 0.0, 1.0);
  EmitVertex();
}

void main() {
  load_instance(instance[0]);
  ivec4 box = make_face(placed[0], placed[1], placed[2]).box;
  if (is_empty(box)) return;
  emit(box.x, box.y);
  emit(box.z + 1, box.y);
  emit(box.x, box.w + 1);
  emit(box.z + 1, box.w + 1);
  EndPrimitive();
}
)";

const char* const kFragment = R"(
flat in vec3 corner_a, corner_b, corner_c;
flat in int body;
uniform sampler2DArray moving;

Cell look_at(ivec2 pixel) { return look(make_face(corner_a, corner_b, corner_c), pixel); }
)";

const char* const kMovingMain = R"(
out vec4 depths;

void main() {
  load_instance(body);
  Cell cell = look_at(ivec2(gl_FragCoord.xy));
  if (cell.num_spans == 0) discard;
  depths = vec4(kNone);
  for (int i = 0; i < cell.num_spans; ++i)
    depths.xy = max(depths.xy, vec2(cell.span[i].y, -cell.span[i].x));
  for (int i = 0; i < cell.num_samples; ++i) depths.z = max(depths.z, cell.sample_at[i].x);
}
)";

const char* const kFixedMain = R"(
out vec2 depths;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  load_instance(body);
  vec4 other = texelFetch(moving, ivec3(pixel, layer), 0);
  if (is_none(other.x)) discard;
  Cell cell = look_at(pixel);
  depths = vec2(kNone);
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

std::string framebuffer_source(Motion::Kind kind, const std::string& body) {
  return "#version 330 core\n" + inputs("") + model(kind) + kLoad + empty_texels() + body;
}

}  // namespace

std::string empty_texels() {
  return "const float kNone = -1e30;\nbool is_none(float x) { return x < -1e29; }\n";
}

std::string face_vertex(Motion::Kind kind) { return framebuffer_source(kind, kFaceVertex); }

std::string quad_geometry(Motion::Kind kind) { return framebuffer_source(kind, kQuadGeometry); }

std::string depth_fragment(Motion::Kind kind, Pass pass) {
  const char* main = pass == Pass::Moving ? kMovingMain : kFixedMain;
  return framebuffer_source(kind, std::string(kFragment) + main);
}

}  // namespace trivet::zlist_shaders
