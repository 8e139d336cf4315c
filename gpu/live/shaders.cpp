#include "gpu/live/shaders.h"

#include "gpu/picture/shaders.h"

namespace trivet::live_shaders {
namespace {

const char* const kShadow = R"(
uniform sampler2DShadow shadow_map;
uniform mat4 map_from_frame;
uniform vec3 light;  // towards the light
uniform float texel;  // of the shadow map, frame
uniform float map_px, texture_px;  // sides in texels; a part of the texture is used
uniform int shadows;  // 0, 1, or 2: with softer edges

// Fraction of the key light that reaches p: a few samples, each blended between four texels, so
// that edges are soft. The point is lifted off its face as in pictures.
float reaches(vec3 p, vec3 face) {
  if (shadows == 0) return 1.0;
  vec3 q = place_in_map(map_from_frame, light, p, face, texel, vec2(0.4, 1.6), 0.0);
  if (any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0)))) return 1.0;
  q.z = min(q.z, 1.0);
  q.xy *= map_px / texture_px;
  if (shadows == 1) return texture(shadow_map, q);
  float lit = 0.0, step = 1.1 / texture_px;
  lit += texture(shadow_map, vec3(q.xy + step * vec2(-0.4, -1.0), q.z));
  lit += texture(shadow_map, vec3(q.xy + step * vec2(1.0, -0.4), q.z));
  lit += texture(shadow_map, vec3(q.xy + step * vec2(0.4, 1.0), q.z));
  lit += texture(shadow_map, vec3(q.xy + step * vec2(-1.0, 0.4), q.z));
  return 0.25 * lit;
}
)";

const char* const kObjectVertex = R"(
uniform mat4 frame_from_object;
uniform mat3 frame_from_normal;
uniform mat4 clip_from_frame;
out vec3 at;
out vec3 shading_normal;
flat out vec3 flat_normal;
flat out uint material_id;

void main() {
  vec4 p = frame_from_object * vec4(position, 1.0);
  at = p.xyz;
  shading_normal = frame_from_normal * normal;
  flat_normal = frame_from_normal * face_normal;
  material_id = material;
#ifdef TEXTURED
  pass_details(mat3(frame_from_object));
#endif
  gl_Position = clip_from_frame * p;
}
)";

const char* const kObjectFragment = R"(
uniform samplerBuffer materials;
uniform vec4 tint;  // linear; alpha: strength
uniform float opacity;
uniform float exposure;
uniform vec4 eye;  // w = 0: xyz is the direction to it
in vec3 at;
in vec3 shading_normal;
flat in vec3 flat_normal;
flat in uint material_id;
layout(location = 0) out vec4 colour;

void main() {
  vec4 base = texelFetch(materials, 2 * int(material_id));
  vec2 finish = texelFetch(materials, 2 * int(material_id) + 1).xy;
  vec3 own_light = vec3(0.0);
#ifdef TEXTURED
  base = textured_base(base);
  if (is_discarded(base.a)) discard;
  if (cutoff <= 1.0 && cutoff >= 0.0) base.a = 1.0;
  finish = textured_polish(finish);
  own_light = textured_emission() * (1.0 - tint.a);
#endif
  base.rgb = mix(base.rgb, tint.rgb, tint.a);
  vec3 to_eye = normalize(eye.xyz - eye.w * at);
  // Two-sided shading: normals face the viewer, and the smooth one agrees with the face.
  vec3 face = dot(flat_normal, flat_normal) > 0.0 ? normalize(flat_normal) : to_eye;
  if (dot(face, to_eye) < 0.0) face = -face;
  vec3 n = dot(shading_normal, shading_normal) > 1e-12 ? normalize(shading_normal) : face;
  if (dot(n, face) < 0.0) n = -n;
#ifdef TEXTURED
  n = bent_normal(n, face, dot(flat_normal, face) < 0.0);
#endif

  float key = max(dot(n, light), 0.0);
  if (key > 0.0) key *= reaches(at, face);
  vec3 sky = mix(vec3(0.30, 0.29, 0.28), vec3(0.50, 0.53, 0.57), 0.5 + 0.5 * n.z);
  // A weak headlight shapes surfaces in the key light's shadow.
  float head = 0.12 * max(dot(n, to_eye), 0.0);
  vec3 diffuse = base.rgb * (1.0 - 0.8 * finish.y);
  vec3 shine = mix(vec3(0.04), base.rgb, finish.y);
  float rough = clamp(finish.x, 0.08, 1.0);
  float power = 2.0 / (rough * rough * rough * rough) - 2.0;
  vec3 halfway = normalize(light + to_eye);
  float spot = (power + 8.0) * 0.04 * pow(max(dot(n, halfway), 0.0), min(power, 400.0));
  float mirrored = 0.30 + 0.45 * smoothstep(-0.3, 0.9, reflect(-to_eye, n).z);
  float rim = pow(1.0 - max(dot(n, to_eye), 0.0), 4.0) * (1.0 - rough);
  vec3 seen = diffuse * (sky + head + key * 0.68) + shine * min(spot, 4.0) * key +
              (shine + rim * 0.4) * mirrored * (1.0 - 0.6 * rough) + own_light;
  colour = vec4(srgb_from_linear(film(exposure * seen)), base.a * opacity);
}
)";

const char* const kCutFragment = R"(
uniform samplerBuffer materials;
flat in uint material_id;

void main() {
  if (is_discarded(textured_base(texelFetch(materials, 2 * int(material_id))).a)) discard;
}
)";

const char* const kFloorVertex = R"(
uniform mat4 clip_from_frame;
uniform vec3 floor_centre;
uniform float floor_radius;
out vec3 at;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  at = floor_centre + vec3(corner * floor_radius, 0.0);
  gl_Position = clip_from_frame * vec4(at, 1.0);
}
)";

const char* const kFloorFragment = R"(
uniform vec3 floor_centre;
uniform float floor_radius;
uniform vec2 grid_origin;  // frame: position of x = y = 0
uniform float cell;        // frame: size of the finest cells; ten times coarser ones in between
uniform float fine;        // strength of the finest lines
uniform vec4 floor_colour, grid_colour, axis_x, axis_y;
uniform float shadow_on_floor;
in vec3 at;
layout(location = 0) out vec4 colour;

// Coverage of a pixel by lines one pixel wide at every multiple of `size`.
float lines(vec2 p, float size, vec2 width) {
  vec2 near_line = abs(fract(p / size + 0.5) - 0.5) * size / width;
  vec2 covered = clamp(1.0 - near_line, 0.0, 1.0) * clamp(size / (4.0 * width) - 0.5, 0.0, 1.0);
  return max(covered.x, covered.y);
}

void main() {
  vec2 p = at.xy - grid_origin;
  vec2 width = max(fwidth(p), vec2(1e-9));
  float distance_out = length(at.xy - floor_centre.xy) / floor_radius;
  float seen = 1.0 - smoothstep(0.35, 1.0, distance_out);
  if (seen <= 0.0) discard;
  float lit = reaches(at, vec3(0, 0, 1));
  vec3 ground = floor_colour.rgb * (1.0 - shadow_on_floor * (1.0 - lit));
  float grid = max(max(fine * 0.45 * lines(p, cell, width), 0.75 * lines(p, 10.0 * cell, width)),
                   lines(p, 100.0 * cell, width));
  ground = mix(ground, grid_colour.rgb, grid * grid_colour.a);
  vec2 axis = clamp(1.2 - abs(p.yx) / width.yx, 0.0, 1.0);
  ground = mix(ground, axis_x.rgb, axis.x * axis_x.a);
  ground = mix(ground, axis_y.rgb, axis.y * axis_y.a);
  colour = vec4(ground, seen * floor_colour.a);
}
)";

const char* const kBackdropFragment = R"(
uniform vec4 top, bottom;
uniform float height;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(mix(bottom.rgb, top.rgb, gl_FragCoord.y / height), 1.0); }
)";

const char* const kMaskFragment = R"(
layout(location = 0) out vec4 colour;
void main() { colour = vec4(1.0); }
)";

const char* const kOutlineFragment = R"(
uniform sampler2D mask;
uniform vec4 outline;
uniform float reach;  // px
layout(location = 0) out vec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy), last = textureSize(mask, 0) - 1;
  if (texelFetch(mask, p, 0).r > 0.5) discard;
  float near_it = 0.0;
  for (int i = 0; i < 12; ++i) {
    float turn = 0.5235988 * float(i);
    vec2 aside = vec2(cos(turn), sin(turn)) * (i % 2 == 0 ? reach : 0.6 * reach);
    near_it += texelFetch(mask, clamp(p + ivec2(floor(aside + 0.5)), ivec2(0), last), 0).r;
  }
  if (near_it <= 0.0) discard;
  colour = vec4(outline.rgb, outline.a * clamp(near_it / 3.0, 0.0, 1.0));
}
)";

const char* const kOverlayVertex = R"(
layout(location = 0) in vec4 position;  // clip
layout(location = 1) in vec4 tone;
layout(location = 2) in vec3 spread;  // px from the middle, and from there to the edge
out vec4 overlay_colour;
noperspective out vec3 beside;
void main() {
  overlay_colour = tone;
  beside = spread;
  gl_Position = position;
}
)";

const char* const kOverlayFragment = R"(
in vec4 overlay_colour;
noperspective in vec3 beside;
layout(location = 0) out vec4 colour;
void main() {
  float covered = clamp(beside.z + 0.5 - length(beside.xy), 0.0, 1.0);
  if (covered <= 0.0) discard;
  colour = vec4(overlay_colour.rgb, overlay_colour.a * covered);
}
)";

using picture_shaders::mesh_inputs;
using picture_shaders::shadow_lookup;
using picture_shaders::surface_details;
using picture_shaders::Surfaces;
using picture_shaders::tone;
using picture_shaders::version;

}  // namespace

std::string object_vertex(Surfaces surfaces) {
  return version() + mesh_inputs(surfaces) + kObjectVertex;
}
std::string object_fragment(Surfaces surfaces) {
  const bool textured = surfaces == Surfaces::Textured;
  return version() + (textured ? "#define TEXTURED\n" + surface_details() : "") + shadow_lookup() +
         kShadow + tone() + kObjectFragment;
}
std::string empty_fragment() { return version() + "void main() {}\n"; }
std::string cut_fragment() { return version() + surface_details() + kCutFragment; }
std::string floor_vertex() { return version() + kFloorVertex; }
std::string floor_fragment() { return version() + shadow_lookup() + kShadow + kFloorFragment; }
std::string backdrop_fragment() { return version() + kBackdropFragment; }
std::string mask_fragment() { return version() + kMaskFragment; }
std::string outline_fragment() { return version() + kOutlineFragment; }
std::string overlay_vertex() { return version() + kOverlayVertex; }
std::string overlay_fragment() { return version() + kOverlayFragment; }

}  // namespace trivet::live_shaders
