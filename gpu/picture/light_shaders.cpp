#include "core/picture/lights.h"
#include "gpu/picture/shaders.h"

namespace trivet::picture_shaders {
namespace {

const char* const kWholeTargetVertex = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// The point is lifted off its face by what the depth of a slanted plane changes within half the
// diagonal of a texel: `lift` of a face towards the light and of one that it grazes; and by what
// float32 loses.
const char* const kShadowLookup = R"(
vec3 place_in_map(mat4 map_from_frame, vec3 to_light, vec3 p, vec3 face, float texel, vec2 lift,
                  float rounding) {
  float c = dot(face, to_light);
  float slant = sqrt(max(0.0, 1.0 - c * c));
  vec3 lifted = p + face * (texel * (lift.x + lift.y * slant) + rounding);
  return (map_from_frame * vec4(lifted, 1.0)).xyz;
}
)";

const char* const kTone = R"(
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
)";

const char* const kShadows = R"(
uniform sampler2DArray shadow_maps;
uniform float floor_z;
uniform float floor_extent;  // half the side of the square of floor light

// [0] key, then the sky's, then those from below.
uniform mat4 map_from_frame[kNumLights];
uniform vec3 direction[kNumLights];
uniform vec3 irradiance[kNumLights];
uniform float texel[kNumLights];
uniform float casts[kNumLights];  // 1: look at its shadow map, 0: everything is lit
uniform float map_size[kNumLights];

// 1 where the light reaches p.
float reaches(int i, vec3 p, vec3 face, float rounding) {
  vec3 q = place_in_map(map_from_frame[i], direction[i], p, face, texel[i], vec2(0.15, 0.75),
                        rounding);
  vec2 at = q.xy * map_size[i];
  if (casts[i] == 0.0 || any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(map_size[i]))))
    return 1.0;
  // Clamps points beyond all casters to the largest depth.
  return min(q.z, 1.0) <= texelFetch(shadow_maps, ivec3(ivec2(at), i), 0).r ? 1.0 : 0.0;
}

)";

// Light on the floor relative to that in the open, in a square around the scene: the ratio of x and
// y. Coarse: used only for light reflected by the floor.
const char* const kFloorLight = R"(
layout(location = 0) out vec4 sum;
uniform float floor_light_px;

void main() {
  vec2 square = gl_FragCoord.xy / floor_light_px * 2.0 - 1.0;
  vec3 p = vec3(square * floor_extent, floor_z), up = vec3(0, 0, 1);
  vec2 sky = vec2(0.0);
  for (int i = 1; i < kFirstFloorLight; ++i)
    sky += irradiance[i].g * direction[i].z * vec2(reaches(i, p, up, 0.0), 1.0);
  vec2 key = irradiance[0].g * direction[0].z * vec2(reaches(0, p, up, 0.0), 1.0);
  sum = vec4(key + sky, 0.0, 0.0);
}
)";

const char* const kLightHead = R"(
uniform usampler2D surfaces;
#ifdef EMITS
uniform sampler2D emission;  // radiance
#endif
uniform sampler2D floor_light;
uniform vec4 ndc_from_pixel;  // scale, offset
uniform vec3 eye, forward, right, up;
uniform int has_floor;
uniform vec2 floor_fade;    // radii at its start and end
uniform vec2 sky_radiance;  // as reflected: at the horizon, at the zenith
layout(location = 0) out vec4 sum;

const float kPi = 3.14159265;
const float kFloorAlbedo = 0.62;
const float kDimGround = 0.30;       // radiance from below without a floor
const float kFromNeighbours = 0.14;  // fraction of the sky's light reflected where the sky is hidden
const float kBelowTolerance = 2e-4;  // objects up to this far below the floor still hide it

struct Surface {
  vec3 position, normal, face;
  vec3 lifted;  // start of its shadow rays
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

// Fraction of uniform surroundings that is reflected. @see [Karis 2014]
vec3 mirrored_share(Surface s, float nv) {
  vec4 r = s.roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
  return specular_colour(s) * ab.x + ab.y;
}

// Fraction of its full light on the floor in the direction of light i.
float floor_brightness(int i, vec3 p) {
  vec3 foot = p - direction[i] * ((p.z - floor_z) / direction[i].z);
  vec2 light = texture(floor_light, foot.xy / floor_extent * 0.5 + 0.5).xy;
  return light.x / max(light.y, 1e-6);
}

vec3 shade(Surface s, vec3 to_eye, float rounding) {
  vec3 diffuse = s.base * (1.0 - s.metallic) / kPi;
  float key = max(dot(s.normal, direction[0]), 0.0) * reaches(0, s.lifted, s.face, rounding);
  vec3 result = key * irradiance[0] * (diffuse + highlight_of_key(s, to_eye));

  // Sky: diffuse from each light, specular from a smooth gradient with the same occlusion.
  float seen = 0.0;
  for (int i = 1; i < kFirstFloorLight; ++i) {
    float cosine = max(dot(s.normal, direction[i]), 0.0);
    float free = reaches(i, s.lifted, s.face, rounding);
    result += cosine * irradiance[i] * diffuse * mix(s.base * kFromNeighbours, vec3(1.0), free);
    seen += cosine * free;
  }
  float open = 3.0 * 0.25 * (1.0 + s.normal.z) + 0.15;  // value of `seen` without casters
  float nv = max(dot(s.normal, to_eye), 0.0);
  vec3 mirrored = reflect(-to_eye, s.normal);
  float width = 0.15 + s.roughness;
  float above = smoothstep(-width, width, mirrored.z);
  float sky = mix(sky_radiance.x, sky_radiance.y, max(mirrored.z, 0.0)) * min(seen / open, 1.5);

  // Floor light from below.
  float ground = 0.0;
  for (int i = kFirstFloorLight; i < kNumLights; ++i) {
    float cosine = max(dot(s.normal, direction[i]), 0.0);
    float radiance = has_floor != 0 ? kFloorAlbedo * floor_brightness(i, s.position) : kDimGround;
    float free = reaches(i, s.lifted, s.face, rounding);
    result += cosine * irradiance[i] * diffuse * radiance * mix(s.base * 0.35, vec3(1.0), free);
    ground += 0.5 * radiance * mix(0.35, 1.0, free);
  }
  result += mirrored_share(s, nv) * mix(ground, sky, above);
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
  vec3 own_light = vec3(0.0);
  if (on_floor) {
    s.normal = s.face = vec3(0, 0, 1);
    s.base = vec3(kFloorAlbedo);
    s.lifted = s.position;
    s.roughness = 0.9;
    s.metallic = 0.0;
    coverage = 1.0 - smoothstep(floor_fade.x, floor_fade.y, length(s.position.xy));
    if (coverage <= 0.0) discard;
  } else {
    s.normal = unpack_normal(packed_surface.x, 16u);
    s.face = unpack_normal(packed_surface.y, 10u);
    float lift = float(packed_surface.y >> 20) / 4095.0;
    s.lifted = s.position + s.normal * (lift * lift * kMaxBulge);
    vec3 colour = vec3((uvec3(packed_surface.z) >> uvec3(0, 8, 16)) & 255u) / 255.0;
    s.base = colour * colour;
    s.roughness = float((packed_surface.z >> 24) & 15u) / 15.0;
    s.metallic = float(packed_surface.z >> 28) / 15.0;
#ifdef EMITS
    own_light = texelFetch(emission, ivec2(gl_FragCoord.xy), 0).rgb;
#endif
  }
  sum = vec4((shade(s, -ray, rounding) + own_light) * coverage, coverage);
}
)";

const char* const kDevelop = R"(
uniform sampler2D sums;
uniform float num_views;
uniform vec4 background;  // sRGB, alpha
uniform float exposure;
layout(location = 0) out vec4 developed;

vec3 linear_from_srgb(vec3 x) {
  return mix(x / 12.92, pow((x + 0.055) / 1.055, vec3(2.4)), greaterThan(x, vec3(0.04045)));
}

// Adds up to half an 8-bit step either way, to hide banding.
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

std::string shadows() {
  return "const int kFirstFloorLight = " + std::to_string(1 + kNumSkyLights) +
         ", kNumLights = " + std::to_string(kLightsPerView) + ";\n" + kShadowLookup + kShadows;
}

}  // namespace

std::string shadow_lookup() { return kShadowLookup; }
std::string tone() { return kTone; }
std::string whole_target_vertex() { return version() + kWholeTargetVertex; }
std::string floor_light_fragment() { return version() + shadows() + kFloorLight; }
std::string light_fragment(bool emits) {
  return version() + (emits ? "#define EMITS\n" : "") + max_bulge() + shadows() + kLightHead +
         kLightBody;
}
std::string develop_fragment() { return version() + kTone + kDevelop; }

}  // namespace trivet::picture_shaders
