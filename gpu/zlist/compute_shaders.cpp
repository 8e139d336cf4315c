#include "gpu/zlist/shaders.h"
#include "gpu/zlist/structs.h"

namespace trivet::zlist_shaders {
namespace {

// Maps floats to integers in the same order, for atomic minimum and maximum.
const char* const kOrdered = R"(
uint ordered(float x) {
  uint bits = floatBitsToUint(x);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float unordered(uint key) {
  return uintBitsToFloat((key & 0x80000000u) != 0u ? key & 0x7fffffffu : ~key);
}
)";

// All views of a batch are layers of one image. An instance is a body in a view.
const char* const kBuffers = R"(
layout(std430, binding = 0) readonly buffer Vertices { float vertices[]; };
layout(std430, binding = 1) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 4) writeonly buffer Entries { Entry entries[]; };
layout(std430, binding = 5) buffer Large { uvec2 large[]; };  // instance, face
layout(std430, binding = 6) readonly buffer Instances { Instance instances[]; };
layout(std430, binding = 7) buffer Layers { Layer layers[]; };

uniform uint num_layers, layer_pixels;
uint layer;

void load_view(uint i) {
  layer = i;
  size = layers[i].size;
  first_radius = layers[i].first_radius;
  sample_error = layers[i].sample_error;
  period = layers[i].period;
  first_depth = layers[i].first_depth;
}

void load_instance(uint i) {
  rows = instances[i].rows;
  blur = instances[i].blur;
  depth_blur = instances[i].depth_blur;
  first_face = instances[i].first_face;
  load_view(instances[i].layer);
}

uint pixel_number(ivec2 pixel) {
  return layer * layer_pixels + uint(pixel.y * size.x + pixel.x);
}
)";

// Planes of ordered floats: 0 moving faces' front, 1 their rear, 2 a sample of them, 3 the nearest
// fixed face.
const char* const kStorage = R"(
layout(std430, binding = 2) buffer Image { uint image[]; };

uint at(uint plane, ivec2 pixel) { return plane * num_layers * layer_pixels + pixel_number(pixel); }
bool has_moving(ivec2 pixel) { return image[at(0u, pixel)] != 0u; }
float front_at(ivec2 pixel) { return unordered(image[at(0u, pixel)]); }
float rear_at(ivec2 pixel) { return unordered(image[at(1u, pixel)]); }
bool has_nearest(ivec2 pixel) { return image[at(3u, pixel)] != 0xffffffffu; }
float nearest_at(ivec2 pixel) { return unordered(image[at(3u, pixel)]); }
)";

const char* const kFramebuffers = R"(
uniform sampler2DArray moving, nearest;

ivec3 texel(ivec2 pixel) { return ivec3(pixel, int(layer)); }
float front_at(ivec2 pixel) { return texelFetch(moving, texel(pixel), 0).x; }
float rear_at(ivec2 pixel) { return -texelFetch(moving, texel(pixel), 0).y; }
bool has_nearest(ivec2 pixel) { return !is_none(texelFetch(nearest, texel(pixel), 0).x); }
float nearest_at(ivec2 pixel) { return -texelFetch(nearest, texel(pixel), 0).x; }
)";

std::string struct_of(const char* name, const char* fields) {
  return std::string("struct ") + name + " { " + fields + " };\n";
}

std::string buffers(Depths depths) {
  return struct_of("Instance", glsl::kInstanceFields) + struct_of("Layer", glsl::kLayerFields) +
         struct_of("Entry", glsl::kEntryFields) + "layout(std430, binding = 3) buffer Counters { " +
         glsl::kCountersFields + " };\n" + kBuffers +
         (depths == Depths::Storage ? kStorage : empty_texels() + kFramebuffers);
}

const char* const kDoubtful = R"(
bool is_doubtful(ivec2 pixel) {
  if (!has_nearest(pixel)) return false;
  return below(nearest_at(pixel) - front_at(pixel)) <= unordered(layers[layer].upper);
}
)";

const char* const kVisitMoving = R"(
const bool kOnlyDoubtful = false;

void visit(Face face, ivec2 pixel, uint id) {
  Cell cell = look(face, pixel);
  for (int i = 0; i < cell.num_spans; ++i) {
    uint front = ordered(cell.span[i].y), rear = ordered(cell.span[i].x);
    if (image[at(0u, pixel)] < front) atomicMax(image[at(0u, pixel)], front);
    if (image[at(1u, pixel)] > rear) atomicMin(image[at(1u, pixel)], rear);
  }
  for (int i = 0; i < cell.num_samples; ++i)
    atomicMax(image[at(2u, pixel)], ordered(cell.sample_at[i].x));
}
)";

const char* const kVisitFixed = R"(
const bool kOnlyDoubtful = false;

void meet_sample(vec2 fixed_sample, uint moving_key) {
  float time;
  if (moving_key == 0u || !meet(fixed_sample, unordered(moving_key), time)) return;
  if (layers[layer].upper > ordered(time)) atomicMin(layers[layer].upper, ordered(time));
}

void visit(Face face, ivec2 pixel, uint id) {
  if (!has_moving(pixel)) return;
  Cell cell = look(face, pixel);
  float rear = rear_at(pixel);
  for (int i = 0; i < cell.num_spans; ++i) {
    float shift = next_turn(cell.span[i].y, rear);
    if (is_behind(cell.span[i].y, rear)) continue;
    uint nearest = ordered(cell.span[i].x + shift);
    if (image[at(3u, pixel)] > nearest) atomicMin(image[at(3u, pixel)], nearest);
  }
  for (int i = 0; i < cell.num_samples; ++i)
    meet_sample(cell.sample_at[i], image[at(2u, pixel)]);
}
)";

const char* const kAddEntry = R"(
uniform uint max_entries;

void add_entry(ivec2 pixel, vec2 span, uint face) {
  uint i = atomicAdd(num_entries, 1u);
  if (i >= max_entries) return;
  entries[i] = Entry(pixel_number(pixel), span.x, span.y, face);
}
)";

const char* const kVisitMovingLists = R"(
const bool kOnlyDoubtful = true;

void visit(Face face, ivec2 pixel, uint id) {
  if (!is_doubtful(pixel)) return;
  Cell cell = look(face, pixel);
  float near = nearest_at(pixel);
  for (int i = 0; i < cell.num_spans; ++i)
    if (below(near - cell.span[i].y) <= unordered(layers[layer].upper))
      add_entry(pixel, cell.span[i], first_face + id);
}
)";

const char* const kVisitFixedLists = R"(
const bool kOnlyDoubtful = true;

void visit(Face face, ivec2 pixel, uint id) {
  if (!is_doubtful(pixel)) return;
  Cell cell = look(face, pixel);
  float front = front_at(pixel), rear = rear_at(pixel);
  for (int i = 0; i < cell.num_spans; ++i) {
    float shift = next_turn(cell.span[i].y, rear);
    if (is_behind(cell.span[i].y, rear)) continue;
    if (below(cell.span[i].x + shift - front) <= unordered(layers[layer].upper))
      add_entry(pixel, cell.span[i], first_face + id);
  }
}
)";

// One thread per face and instance; faces over many pixels are left to a second dispatch, with one
// group each.
const char* const kMain = R"(
layout(local_size_x = 64) in;
uniform uint num_faces, first_instance, group_per_face, max_large;

vec3 corner(uint face, uint k) {
  uint v = 3u * corners[3u * face + k];
  return place(vec3(vertices[v], vertices[v + 1u], vertices[v + 2u]));
}

ivec4 cropped(ivec4 box) {
  if (!kOnlyDoubtful) return box;
  Layer b = layers[layer];
  return ivec4(max(box.xy, ivec2(b.low_x, b.low_y)), min(box.zw, ivec2(b.high_x, b.high_y)));
}

bool left_to_a_group(uvec2 face) {
  uint i = atomicAdd(num_large, 1u);
  if (i >= max_large) return false;
  large[i] = face;
  atomicMax(large_groups[0], i + 1u);
  return true;
}

uvec2 instance_and_face() {
  if (group_per_face != 0u) return large[gl_WorkGroupID.x];
  uint row = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  return uvec2(first_instance + gl_GlobalInvocationID.z, row + gl_GlobalInvocationID.x);
}

void main() {
  uvec2 id = instance_and_face();
  if (id.y >= num_faces) return;
  load_instance(id.x);
  if (kOnlyDoubtful && layers[layer].num_doubtful <= layers[layer].most_handed_over) return;
  Face face = make_face(corner(id.y, 0u), corner(id.y, 1u), corner(id.y, 2u));
  ivec4 box = cropped(face.box);
  if (is_empty(box)) return;
  uint width = uint(box.z - box.x + 1), count = width * uint(box.w - box.y + 1);
  bool in_group = group_per_face != 0u;
  if (!in_group && count > 64u && left_to_a_group(id)) return;
  uint first = in_group ? gl_LocalInvocationIndex : 0u, step = in_group ? 64u : 1u;
  for (uint i = first; i < count; i += step)
    visit(face, box.xy + ivec2(i % width, i / width), id.y);
}
)";

// With framebuffers, bounds of the time are in the pixels of the fixed faces.
const char* const kUpperBounds = R"(
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  load_view(gl_GlobalInvocationID.z);
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, size))) return;
  float time = texelFetch(nearest, texel(pixel), 0).y;
  if (is_none(time)) return;
  uint key = ordered(-time);
  if (layers[layer].upper > key) atomicMin(layers[layer].upper, key);
}
)";

const char* const kReduce = R"(
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  load_view(gl_GlobalInvocationID.z);
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, size))) return;
  if (!has_nearest(pixel)) return;
  atomicAdd(layers[layer].num_pixels, 1u);
  uint gap = ordered(below(max(0.0, nearest_at(pixel) - front_at(pixel))));
  if (layers[layer].lower > gap) atomicMin(layers[layer].lower, gap);
  if (!is_doubtful(pixel)) return;
  uint before = atomicAdd(layers[layer].num_doubtful, 1u);
  atomicMin(layers[layer].low_x, uint(pixel.x));
  atomicMin(layers[layer].low_y, uint(pixel.y));
  atomicMax(layers[layer].high_x, uint(pixel.x));
  atomicMax(layers[layer].high_y, uint(pixel.y));
  if (before < layers[layer].most_handed_over) add_entry(pixel, vec2(0.0), 0xffffffffu);
}
)";

const char* visit_of(Pass pass) {
  switch (pass) {
    case Pass::Moving:
      return kVisitMoving;
    case Pass::Fixed:
      return kVisitFixed;
    case Pass::MovingLists:
      return kVisitMovingLists;
    default:
      return kVisitFixedLists;
  }
}

std::string compute_source(const std::string& body) {
  return "#version 430 core\n" + inputs("") + body;
}

std::string over_pixels(Depths depths, const std::string& body) {
  return compute_source(model(Motion::Kind::Translation) + kOrdered + buffers(depths) + body);
}

}  // namespace

std::string compute(Motion::Kind kind, Pass pass, Depths depths) {
  // Passes that list need room for entries and know the doubtful pixels; all share the rest.
  const bool lists = pass == Pass::MovingLists || pass == Pass::FixedLists;
  return compute_source(model(kind) + kOrdered + buffers(depths) +
                        (lists ? std::string(kDoubtful) + kAddEntry : std::string()) +
                        visit_of(pass) + kMain);
}

std::string upper_bounds() { return over_pixels(Depths::Framebuffers, kUpperBounds); }

std::string reduction(Depths depths) {
  return over_pixels(depths, std::string(kDoubtful) + kAddEntry + kReduce);
}

}  // namespace trivet::zlist_shaders
