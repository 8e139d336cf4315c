#include "gpu/picture/shaders.h"

namespace trivet::picture_shaders {
namespace {

const std::string kSeeThrough = "#define SEE_THROUGH\n";

/// Dither threshold in [0, 1): evenly spread over views and neighbouring pixels, independent
/// between triangles, so that stacked triangles show by the product of their transmissions.
const char* const kThreshold = R"(
uniform uint seed;   // of the object
uniform uint view;   // of the sub-pixel view or of the light
uniform ivec2 tile;  // first pixel of the tile

uint scramble(uint x) {  // integer hash by xor-shifts and odd factors
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

uint reversed(uint x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

// Every bit depends only on the bits below it. @see [Laine 2011]
uint mix_upwards(uint x, uint key) {
  x += key;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  return x ^ (x * 0x8d22f6e6u);
}

// The van der Corput sequence, shuffled and scrambled per triangle, and shifted from pixel to pixel
// so that neighbours complement each other. @see [Burley 2020], [Jimenez 2014]
float threshold() {
  vec2 pixel = vec2(ivec2(gl_FragCoord.xy) + tile);
  float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  uint key = scramble(uint(gl_PrimitiveID) ^ scramble(seed));
  uint index = reversed(mix_upwards(reversed(view), key));
  uint value = reversed(mix_upwards(index, scramble(key)));
  return fract(noise + float(value >> 8) / 16777216.0);
}
)";

const char* const kMeshInputs = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 face_normal;
layout(location = 3) in uint material;
#ifdef TEXTURED
layout(location = 4) in vec4 corner_coordinates;
layout(location = 5) in vec4 corner_colour;
layout(location = 6) in vec4 corner_tangent;
out vec4 coordinates;
out vec4 vertex_colour;
out vec3 image_right, image_up;

void pass_details(mat3 frame_from_mesh) {
  coordinates = corner_coordinates;
  vertex_colour = corner_colour;
  image_right = frame_from_mesh * corner_tangent.xyz;
  image_up = frame_from_mesh * (sign(corner_tangent.w) * cross(normal, corner_tangent.xyz));
}
#endif
)";

const char* const kSurfaceVertex = R"(
uniform mat4 frame_from_object;
uniform mat3 frame_from_normal;
uniform mat4 clip_from_frame;
uniform vec3 eye;
out vec3 from_eye;
out vec3 shading_normal;
flat out vec3 flat_normal;
flat out uint material_id;
out vec3 object_position;
out vec3 weights;

void main() {
  object_position = position;
  weights = vec3(equal(ivec3(gl_VertexID % 3), ivec3(0, 1, 2)));
  vec4 p = frame_from_object * vec4(position, 1.0);
  from_eye = p.xyz - eye;
  shading_normal = frame_from_normal * normal;
  flat_normal = frame_from_normal * face_normal;
  material_id = material;
#ifdef TEXTURED
  pass_details(mat3(frame_from_object));
#endif
  gl_Position = clip_from_frame * p;
}
)";

// G-buffer: x shading normal, y face normal and bulge, z base colour, roughness and metallic, w
// distance from the eye; 0 for background.
const char* const kSurfaceFragment = R"(
uniform samplerBuffer materials;
uniform usamplerBuffer corners;
uniform int first_triangle;
uniform mat4 frame_from_object;
uniform vec4 highlight;
in vec3 from_eye;
in vec3 shading_normal;
flat in vec3 flat_normal;
flat in uint material_id;
in vec3 object_position;
in vec3 weights;
layout(location = 0) out uvec4 surface;
#ifdef TEXTURED
layout(location = 1) out vec4 emission;
#endif

vec2 octahedron(vec3 n) {  // unit vector -> unit square
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  return clamp((n.z < 0.0 ? folded : n.xy) * 0.5 + 0.5, 0.0, 1.0);
}

uint pack_normal(vec3 n, uint bits) {
  uvec2 q = uvec2(octahedron(n) * float((1u << bits) - 1u) + 0.5);
  return q.x | (q.y << bits);
}

vec3 stored_normal(uvec2 bits) {
  ivec3 n = ivec3(int(bits.x << 16) >> 16, int(bits.x) >> 16, int(bits.y << 16) >> 16);
  return vec3(n) / 32767.0;
}

// Distance by which the smooth surface implied by the corner normals lies outside the triangle.
// Shadow rays start there; otherwise a coarse sphere would be shaded smoothly and shadowed by its
// facets. @see [Hanika 2021]
float bulge(float side) {
  int corner = 6 * (first_triangle + gl_PrimitiveID);
  vec3 lift = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    uvec4 low = texelFetch(corners, corner + 2 * i), high = texelFetch(corners, corner + 2 * i + 1);
    vec3 normal = side * stored_normal(uvec2(low.w, high.x));
    float below = dot(object_position - uintBitsToFloat(low.xyz), normal);
    lift -= weights[i] * min(below, 0.0) * normal;
  }
  float height = length(mat3(frame_from_object) * lift);
  // Larger values indicate normals bent over a fold, not a surface: limit them.
  return height > kMaxBulge ? kMaxBulge * kMaxBulge / height : height;
}

void main() {
  vec4 base = texelFetch(materials, 2 * int(material_id));
  vec4 finish = texelFetch(materials, 2 * int(material_id) + 1);
#ifdef TEXTURED
  base = textured_base(base);
  finish.xy = textured_polish(finish.xy);
  emission = vec4(textured_emission() * (1.0 - highlight.a), 1.0);
  if (is_discarded(base.a)) discard;
  if (cutoff >= 0.0 && cutoff <= 1.0) base.a = 1.0;
#endif
#ifdef SEE_THROUGH
  // Like glass: at grazing angles, more reflection and less transmission.
  float slant = 1.0 - abs(dot(normalize(from_eye), normalize(shading_normal)));
  if (mix(base.a, 1.0, 0.7 * pow(slant, 4.0)) <= threshold()) discard;
#endif
  // Two-sided shading: normals face the viewer, and the smooth one agrees with the face.
  vec3 face = dot(flat_normal, flat_normal) > 0.0 ? normalize(flat_normal) : normalize(-from_eye);
  if (dot(face, from_eye) > 0.0) face = -face;
  float squared = dot(shading_normal, shading_normal);
  vec3 smooth_normal = squared > 1e-12 ? shading_normal * inversesqrt(squared) : face;
  float side = dot(smooth_normal, face) < 0.0 ? -1.0 : 1.0;
#ifdef TEXTURED
  vec3 shown_normal = bent_normal(side * smooth_normal, face, dot(flat_normal, face) < 0.0);
#else
  vec3 shown_normal = side * smooth_normal;
#endif
  uint lift = uint(sqrt(min(bulge(side) / kMaxBulge, 1.0)) * 4095.0 + 0.5);
  uvec3 colour = uvec3(sqrt(mix(base.rgb, highlight.rgb, highlight.a)) * 255.0 + 0.5);
  uvec2 rough_metal = uvec2(finish.xy * 15.0 + 0.5);
  surface.x = pack_normal(shown_normal, 16u);
  surface.y = pack_normal(face, 10u) | (lift << 20);
  surface.z = colour.r | (colour.g << 8) | (colour.b << 16) | (rough_metal.x << 24) |
              (rough_metal.y << 28);
  surface.w = floatBitsToUint(max(length(from_eye), 1e-20));
}
)";

const char* const kShadowVertex = R"(
uniform mat4 frame_from_object;
uniform mat4 clip_from_frame;
flat out uint material_id;

void main() {
  material_id = material;
#ifdef TEXTURED
  pass_details(mat3(frame_from_object));
#endif
  gl_Position = clip_from_frame * (frame_from_object * vec4(position, 1.0));
}
)";

const char* const kShadowFragment = R"(
uniform samplerBuffer materials;
flat in uint material_id;

void main() {
#ifdef SEE_THROUGH
  float alpha = texelFetch(materials, 2 * int(material_id)).a;
#ifdef TEXTURED
  alpha = textured_base(vec4(1.0, 1.0, 1.0, alpha)).a;
  if (is_discarded(alpha)) discard;
  if (cutoff >= 0.0 && cutoff <= 1.0) alpha = 1.0;
#endif
  if (alpha <= threshold()) discard;
#endif
}
)";

// Values from textures, as SurfaceImages binds them: base colour, polish, normal, emission.
const char* const kDetails = R"(
uniform sampler2D base_image, polish_image, normal_image, emission_image;
uniform ivec4 image_used, image_set;
uniform vec3 image_place[8];  // two rows each
uniform vec3 emitted;
uniform float normal_scale;
uniform float cutoff;  // of alpha; below 0: none, above 1: mixed by alpha
in vec4 coordinates;
in vec4 vertex_colour;
in vec3 image_right, image_up;

vec2 place_in_image(int i) {
  vec3 at = vec3(image_set[i] == 0 ? coordinates.xy : coordinates.zw, 1.0);
  return vec2(dot(image_place[2 * i], at), dot(image_place[2 * i + 1], at));
}

vec4 textured_base(vec4 factor) {
  vec4 colour = factor * vertex_colour;
  return image_used[0] != 0 ? colour * texture(base_image, place_in_image(0)) : colour;
}

bool is_discarded(float alpha) { return cutoff > 1.0 ? alpha <= 0.0 : alpha < cutoff; }

vec2 textured_polish(vec2 rough_metal) {
  return image_used[1] != 0 ? rough_metal * texture(polish_image, place_in_image(1)).gb
                            : rough_metal;
}

vec3 textured_emission() {
  return image_used[3] != 0 ? emitted * texture(emission_image, place_in_image(3)).rgb : emitted;
}

// `normal` and `face` are towards the viewer; from behind, bumps are dents.
vec3 bent_normal(vec3 normal, vec3 face, bool from_behind) {
  if (image_used[2] == 0) return normal;
  vec3 mapped = 2.0 * texture(normal_image, place_in_image(2)).rgb - 1.0;
  mapped.xy *= from_behind ? -normal_scale : normal_scale;
  vec3 right = image_right - dot(image_right, normal) * normal;
  vec3 up = image_up - dot(image_up, normal) * normal;
  if (dot(right, right) <= 0.0) return normal;
  right = normalize(right);
  up -= dot(up, right) * right;
  if (dot(up, up) <= 0.0) return normal;
  vec3 bent = mapped.x * right + mapped.y * normalize(up) + mapped.z * normal;
  return dot(bent, face) > 0.0 ? normalize(bent) : normal;
}
)";

std::string defines(bool see_through, Surfaces surfaces) {
  std::string out = surfaces == Surfaces::Textured ? "#define TEXTURED\n" : "";
  if (see_through) out += kSeeThrough + kThreshold;
  return surfaces == Surfaces::Textured ? out + kDetails : out;
}

}  // namespace

std::string mesh_inputs(Surfaces surfaces) {
  return (surfaces == Surfaces::Textured ? "#define TEXTURED\n" : "") + std::string(kMeshInputs);
}
std::string surface_details() { return kDetails; }
std::string surface_vertex(Surfaces surfaces) {
  return version() + mesh_inputs(surfaces) + kSurfaceVertex;
}
std::string surface_fragment(bool see_through, Surfaces surfaces) {
  return version() + max_bulge() + defines(see_through, surfaces) + kSurfaceFragment;
}
std::string shadow_vertex(Surfaces surfaces) {
  return version() + mesh_inputs(surfaces) + kShadowVertex;
}
std::string shadow_fragment(bool see_through, Surfaces surfaces) {
  return version() + defines(see_through, surfaces) + kShadowFragment;
}

}  // namespace trivet::picture_shaders
