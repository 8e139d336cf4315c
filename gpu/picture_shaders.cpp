#include "gpu/picture_shaders.h"

namespace trivet::picture_shaders {
namespace {

const std::string kVersion = "#version 330 core\n";
const std::string kSeeThrough = "#define SEE_THROUGH\n";

/// A threshold in (0, 1) that differs from pixel to pixel and from object to object, and whose
/// values over the views are spread evenly.
const char* const kThreshold = R"(
uniform uint seed;   // of the object
uniform uint view;   // of the sub-pixel view or of the light
uniform ivec2 tile;  // first pixel of the tile

uint scramble(uint x) {  // integer hash by xor-shifts and odd factors
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

float threshold(uint layer) {
  uvec2 pixel = uvec2(ivec2(gl_FragCoord.xy) + tile);
  uint h = scramble(pixel.x ^ scramble(pixel.y ^ scramble(2u * seed + layer)));
  // Golden ratio steps in 32-bit fixed point.
  return (float((h + view * 2654435769u) >> 8) + 0.5) / 16777216.0;
}
)";

const char* const kSurfaceVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 face_normal;
layout(location = 3) in uint material;
uniform mat4 frame_from_object;
uniform mat3 frame_from_normal;
uniform mat4 clip_from_frame;
uniform vec3 eye;
out vec3 from_eye;
out vec3 shading_normal;
flat out vec3 flat_normal;
flat out uint material_id;

void main() {
  vec4 p = frame_from_object * vec4(position, 1.0);
  from_eye = p.xyz - eye;
  shading_normal = frame_from_normal * normal;
  flat_normal = frame_from_normal * face_normal;
  material_id = material;
  gl_Position = clip_from_frame * p;
}
)";

// G-buffer: x shading normal, y face normal and roughness, z base colour and metallic,
// w distance from the eye; 0 where there is nothing.
const char* const kSurfaceFragment = R"(
uniform samplerBuffer materials;
uniform vec4 highlight;
in vec3 from_eye;
in vec3 shading_normal;
flat in vec3 flat_normal;
flat in uint material_id;
layout(location = 0) out uvec4 surface;

vec2 octahedron(vec3 n) {  // unit vector -> unit square
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  return clamp((n.z < 0.0 ? folded : n.xy) * 0.5 + 0.5, 0.0, 1.0);
}

uint pack_normal(vec3 n, uint bits) {
  uvec2 q = uvec2(octahedron(n) * float((1u << bits) - 1u) + 0.5);
  return q.x | (q.y << bits);
}

void main() {
  vec4 base = texelFetch(materials, 2 * int(material_id));
  vec4 finish = texelFetch(materials, 2 * int(material_id) + 1);
#ifdef SEE_THROUGH
  if (base.a <= threshold(gl_FrontFacing ? 0u : 1u)) discard;
#endif
  // Both sides are seen: normals look at the viewer, and the smooth one agrees with the face.
  vec3 face = dot(flat_normal, flat_normal) > 0.0 ? normalize(flat_normal) : normalize(-from_eye);
  if (dot(face, from_eye) > 0.0) face = -face;
  float squared = dot(shading_normal, shading_normal);
  vec3 smooth_normal = squared > 1e-12 ? shading_normal * inversesqrt(squared) : face;
  if (dot(smooth_normal, face) < 0.0) smooth_normal = -smooth_normal;
  vec3 colour = mix(base.rgb, highlight.rgb, highlight.a);
  uvec4 b = uvec4(vec4(sqrt(colour), finish.y) * 255.0 + 0.5);
  surface.x = pack_normal(smooth_normal, 16u);
  surface.y = pack_normal(face, 12u) | (uint(finish.x * 255.0 + 0.5) << 24);
  surface.z = b.r | (b.g << 8) | (b.b << 16) | (b.a << 24);
  surface.w = floatBitsToUint(max(length(from_eye), 1e-20));
}
)";

const char* const kShadowVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 3) in uint material;
uniform mat4 frame_from_object;
uniform mat4 clip_from_frame;
flat out uint material_id;

void main() {
  material_id = material;
  gl_Position = clip_from_frame * (frame_from_object * vec4(position, 1.0));
}
)";

const char* const kShadowFragment = R"(
uniform samplerBuffer materials;
flat in uint material_id;

void main() {
#ifdef SEE_THROUGH
  if (texelFetch(materials, 2 * int(material_id)).a <= threshold(gl_FrontFacing ? 0u : 1u)) discard;
#endif
}
)";

const char* const kWholeTargetVertex = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const char* const kLightHead = R"(
uniform usampler2D surfaces;
uniform sampler2DArray shadow_maps;
uniform vec4 ndc_from_pixel;  // scale, offset
uniform vec3 eye, forward, right, up;

uniform int has_floor;
uniform float floor_z;
uniform vec2 floor_fade;  // radii where it begins and ends

// [0] key, [1..3] sky, [4] from below.
uniform mat4 map_from_frame[5];
uniform vec3 direction[5];
uniform vec3 irradiance[5];
uniform float texel[5];
uniform float casts[5];  // 1: look at its shadow map, 0: everything is lit
uniform vec2 sky_radiance;  // at the horizon, at the zenith
uniform float map_size;
uniform float key_share;  // of the light that falls on an open floor

layout(location = 0) out vec4 sum;

const float kPi = 3.14159265;
const float kFloorAlbedo = 0.62;
const float kDimGround = 0.30;      // radiance from below where there is no floor
const float kFromNeighbours = 0.14;  // of the sky's light that comes back where the sky is hidden
const float kBelowTolerance = 2e-4;  // objects that much below the floor are in front of it

struct Surface {
  vec3 position, normal, face;
  vec3 base;
  float roughness, metallic;
};

vec3 unpack_normal(uint bits, uint count) {
  float top = float((1u << count) - 1u);
  uint mask = (1u << count) - 1u;
  vec2 f = vec2(bits & mask, (bits >> count) & mask) / top * 2.0 - 1.0;
  vec3 n = vec3(f, 1.0 - abs(f.x) - abs(f.y));
  float t = max(-n.z, 0.0);
  n.xy -= vec2(n.x < 0.0 ? -t : t, n.y < 0.0 ? -t : t);
  return normalize(n);
}

// 1 where the light reaches p. The point is lifted off the surface by what the depth of a slanted
// plane changes within half the diagonal of a texel, and by what float32 loses.
float reaches(int i, vec3 p, vec3 face, float rounding) {
  float c = dot(face, direction[i]);
  float slant = sqrt(max(0.0, 1.0 - c * c));
  vec3 lifted = p + face * (texel[i] * (0.15 + 0.75 * slant) + rounding);
  vec3 q = (map_from_frame[i] * vec4(lifted, 1.0)).xyz;
  vec2 at = q.xy * map_size;
  if (casts[i] == 0.0 || any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(map_size))))
    return 1.0;
  return q.z <= texelFetch(shadow_maps, ivec3(ivec2(at), i), 0).r ? 1.0 : 0.0;
}

// Fades the light out where the smooth normal still sees it and the face no longer does.
// @see [Chiang, Li, Burley 2019], Taming the shadow terminator
float terminator(vec3 normal, vec3 face, vec3 light) {
  float g = dot(face, light) / max(dot(normal, light) * dot(normal, face), 1e-6);
  g = clamp(g, 0.0, 1.0);
  return g * (1.0 + g * (1.0 - g));
}
)";

const char* const kLightBody = R"(
vec3 specular_colour(Surface s) { return mix(vec3(0.04), s.base, s.metallic); }

// GGX with Smith's visibility in Hammon's approximation and Schlick's Fresnel term.
vec3 highlight_of_key(Surface s, vec3 to_eye) {
  vec3 h = normalize(direction[0] + to_eye);
  float nl = max(dot(s.normal, direction[0]), 1e-4), nv = max(dot(s.normal, to_eye), 1e-4);
  float nh = max(dot(s.normal, h), 0.0), lh = max(dot(direction[0], h), 0.0);
  float a = max(s.roughness * s.roughness, 0.02), a2 = a * a;
  float d = nh * nh * (a2 - 1.0) + 1.0;
  float spread = a2 / (kPi * d * d);
  float masking = 0.5 / mix(2.0 * nl * nv, nl + nv, a);
  vec3 f0 = specular_colour(s);
  return min(spread * masking, 50.0) * (f0 + (1.0 - f0) * pow(1.0 - lh, 5.0));
}

// The share of a uniform surrounding that is mirrored. @see [Karis 2014], Physically based shading
// on mobile
vec3 mirrored_share(Surface s, float nv) {
  vec4 r = s.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
  return specular_colour(s) * ab.x + ab.y;
}

// How much of its full light the floor below p has, seen from p towards the light from below.
float floor_brightness(vec3 p, float rounding) {
  vec3 foot = p - direction[4] * ((p.z - floor_z) / direction[4].z);
  float key = reaches(0, foot, vec3(0, 0, 1), rounding);
  float sky = reaches(1, foot, vec3(0, 0, 1), rounding);
  return mix(sky, key, key_share);
}

vec3 shade(Surface s, vec3 to_eye, float rounding) {
  vec3 diffuse = s.base * (1.0 - s.metallic) / kPi;
  float key = max(dot(s.normal, direction[0]), 0.0) * reaches(0, s.position, s.face, rounding) *
              terminator(s.normal, s.face, direction[0]);
  vec3 result = key * irradiance[0] * (diffuse + highlight_of_key(s, to_eye));

  // The sky: diffuse by each light, mirrored from a smooth gradient and hidden as they are.
  float seen = 0.0;
  for (int i = 1; i < 4; ++i) {
    float cosine = max(dot(s.normal, direction[i]), 0.0);
    float free = reaches(i, s.position, s.face, rounding) *
                 terminator(s.normal, s.face, direction[i]);
    result += cosine * irradiance[i] * diffuse * mix(s.base * kFromNeighbours, vec3(1.0), free);
    seen += cosine * free;
  }
  float open = 3.0 * 0.25 * (1.0 + s.normal.z) + 0.15;  // what `seen` is without any caster
  float nv = max(dot(s.normal, to_eye), 0.0);
  vec3 mirrored = reflect(-to_eye, s.normal);
  float width = 0.15 + s.roughness;
  float above = smoothstep(-width, width, mirrored.z);
  float sky = mix(sky_radiance.x, sky_radiance.y, max(mirrored.z, 0.0)) * min(seen / open, 1.5);

  // From below.
  float cosine = max(dot(s.normal, direction[4]), 0.0);
  float ground = has_floor != 0 ? kFloorAlbedo * floor_brightness(s.position, rounding) : kDimGround;
  float free = reaches(4, s.position, s.face, rounding);
  result += cosine * irradiance[4] * diffuse * ground * mix(s.base * 0.35, vec3(1.0), free);
  result += mirrored_share(s, nv) * mix(ground * mix(0.35, 1.0, free), sky, above);
  return result;
}

void main() {
  vec2 ndc = gl_FragCoord.xy * ndc_from_pixel.xy + ndc_from_pixel.zw;
  vec3 ray = normalize(forward + ndc.x * right + ndc.y * up);
  uvec4 packed_surface = texelFetch(surfaces, ivec2(gl_FragCoord.xy), 0);
  float distance_to_object = uintBitsToFloat(packed_surface.w);
  bool on_object = packed_surface.w != 0u;
  bool sees_floor = has_floor != 0 && eye.z > floor_z && ray.z < -1e-6;
  bool on_floor = sees_floor && (!on_object || eye.z + distance_to_object * ray.z <
                                                   floor_z - kBelowTolerance);
  if (!on_object && !on_floor) discard;

  Surface s;
  float along = on_floor ? (floor_z - eye.z) / ray.z : distance_to_object;
  s.position = eye + along * ray;
  float rounding = 4e-7 * (1.0 + along);
  float coverage = 1.0;
  if (on_floor) {
    s.normal = s.face = vec3(0, 0, 1);
    s.base = vec3(kFloorAlbedo);
    s.roughness = 0.9;
    s.metallic = 0.0;
    coverage = 1.0 - smoothstep(floor_fade.x, floor_fade.y, length(s.position.xy));
    if (coverage <= 0.0) discard;
  } else {
    s.normal = unpack_normal(packed_surface.x, 16u);
    s.face = unpack_normal(packed_surface.y, 12u);
    vec4 b = vec4((uvec4(packed_surface.z) >> uvec4(0, 8, 16, 24)) & 255u) / 255.0;
    s.base = b.rgb * b.rgb;
    s.roughness = float(packed_surface.y >> 24) / 255.0;
    s.metallic = b.a;
  }
  sum = vec4(shade(s, -ray, rounding) * coverage, coverage);
}
)";

const char* const kDevelop = R"(
uniform sampler2D sums;
uniform float num_views;
uniform vec4 background;  // sRGB, alpha
uniform float exposure;
layout(location = 0) out vec4 developed;

// Straight up to kKnee, then bent so that white is reached slowly.
const float kKnee = 0.6;
vec3 film(vec3 x) {
  vec3 bent = 1.0 - (1.0 - kKnee) * exp(-max(x - kKnee, 0.0) / (1.0 - kKnee));
  return mix(x, bent, greaterThan(x, vec3(kKnee)));
}

vec3 srgb_from_linear(vec3 x) {
  return mix(12.92 * x, 1.055 * pow(max(x, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055,
             greaterThan(x, vec3(0.0031308)));
}

vec3 linear_from_srgb(vec3 x) {
  return mix(x / 12.92, pow((x + 0.055) / 1.055, vec3(2.4)), greaterThan(x, vec3(0.04045)));
}

// Half a step of 8 bits up or down, so that smooth shading shows no steps.
float dither() {
  uvec2 p = uvec2(gl_FragCoord.xy);
  uint h = (p.x * 1973u + p.y * 9277u + 26699u) | 1u;
  h = (h ^ (h >> 15)) * 0x846ca68bu;
  h ^= h >> 16;
  return (float(h & 65535u) / 65535.0 - 0.5) / 255.0;
}

void main() {
  vec4 s = texelFetch(sums, ivec2(gl_FragCoord.xy), 0) / num_views;
  developed = background;
  if (s.a <= 0.0) return;
  float alpha = min(s.a, 1.0) + background.a * (1.0 - min(s.a, 1.0));
  vec3 drawn = film(exposure * s.rgb / s.a);
  vec3 over = mix(linear_from_srgb(background.rgb) * background.a, drawn, min(s.a, 1.0)) / alpha;
  developed = vec4(clamp(srgb_from_linear(over) + dither(), 0.0, 1.0), alpha);
}
)";

}  // namespace

std::string surface_vertex() { return kVersion + kSurfaceVertex; }
std::string surface_fragment(bool see_through) {
  return kVersion + (see_through ? kSeeThrough + kThreshold : "") + kSurfaceFragment;
}
std::string shadow_vertex() { return kVersion + kShadowVertex; }
std::string shadow_fragment(bool see_through) {
  return kVersion + (see_through ? kSeeThrough + kThreshold : "") + kShadowFragment;
}
std::string whole_target_vertex() { return kVersion + kWholeTargetVertex; }
std::string light_fragment() { return kVersion + kLightHead + kLightBody; }
std::string develop_fragment() { return kVersion + kDevelop; }

}  // namespace trivet::picture_shaders
