#include "core/io/textures/gltf_values.h"

#include <array>
#include <cmath>
#include <cstring>

#include "core/base/bad_input.h"
#include "core/io/gltf/component_types.h"

namespace trivet {
namespace {

constexpr int kTriangles = 4, kStrip = 5, kFan = 6;

int bytes_of_component(int component) {
  switch (component) {
    case gltf::kByte:
    case gltf::kUnsignedByte:
      return 1;
    case gltf::kShort:
    case gltf::kUnsignedShort:
      return 2;
    case gltf::kUnsignedInt:
    case gltf::kFloat:
      return 4;
    default:
      bad_input("an accessor has the component type %1", component);
  }
}

int components_of_type(const GltfJson& type) {
  constexpr const char* kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  for (int i = 0; i < 4; ++i)
    if (type == kTypes[i]) return i + 1;
  bad_input("an accessor is no scalar and no vector");
}

template <class T>
T loaded(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Position of an accessor's items within the buffer.
struct Items {
  const char* first;
  size_t count, stride;
  int component, num_components;
  bool normalised;
};

size_t index_or_zero(const GltfJson& value) { return value.is_null() ? 0 : index_from(value); }

Items items_of(const GltfDocument& document, const GltfJson& id) {
  const GltfJson& accessor = element(document.json, "accessors", id);
  if (accessor.contains("sparse")) bad_input("an accessor is sparse");
  const GltfJson& view = element(document.json, "bufferViews", member(accessor, "bufferView"));
  Items out{};
  out.component = static_cast<int>(index_from(member(accessor, "componentType")));
  out.num_components = components_of_type(member(accessor, "type"));
  out.normalised = member(accessor, "normalized") == true;
  out.count = index_from(member(accessor, "count"));
  const size_t item = static_cast<size_t>(bytes_of_component(out.component)) *
                      static_cast<size_t>(out.num_components);
  out.stride = index_or_zero(member(view, "byteStride"));
  if (out.stride == 0) out.stride = item;
  const size_t begin = index_or_zero(member(view, "byteOffset"));
  const size_t length = index_from(member(view, "byteLength"));
  const size_t offset = index_or_zero(member(accessor, "byteOffset"));
  const size_t size = document.binary.size();
  const bool view_fits = begin <= size && length <= size - begin;
  const bool fits = out.count == 0 || (offset <= length && item <= length - offset &&
                                       (length - offset - item) / out.stride >= out.count - 1);
  if (!view_fits || !fits) bad_input("an accessor extends beyond its buffer");
  out.first = document.binary.data() + begin + offset;
  return out;
}

float component_at(const char* at, const Items& items) {
  const auto scaled = [&](float value, float by) {
    return items.normalised ? std::max(value / by, -1.0f) : value;
  };
  switch (items.component) {
    case gltf::kByte:
      return scaled(loaded<std::int8_t>(at), 127);
    case gltf::kUnsignedByte:
      return scaled(loaded<std::uint8_t>(at), 255);
    case gltf::kShort:
      return scaled(loaded<std::int16_t>(at), 32767);
    case gltf::kUnsignedShort:
      return scaled(loaded<std::uint16_t>(at), 65535);
    case gltf::kUnsignedInt:
      return static_cast<float>(loaded<std::uint32_t>(at));
    default:
      return loaded<float>(at);
  }
}

std::vector<std::uint32_t> indices_of(const GltfDocument& document, const GltfJson& primitive,
                                      size_t num_vertices) {
  std::vector<std::uint32_t> out;
  if (!primitive.contains("indices")) {
    out.reserve(num_vertices);
    for (size_t i = 0; i < num_vertices; ++i) out.push_back(static_cast<std::uint32_t>(i));
    return out;
  }
  const Items items = items_of(document, primitive["indices"]);
  out.reserve(items.count);
  for (size_t i = 0; i < items.count; ++i) {
    const char* const at = items.first + i * items.stride;
    out.push_back(items.component == gltf::kUnsignedByte    ? loaded<std::uint8_t>(at)
                  : items.component == gltf::kUnsignedShort ? loaded<std::uint16_t>(at)
                                                            : loaded<std::uint32_t>(at));
    if (out.back() >= num_vertices) bad_input("a primitive refers to a vertex that it has not");
  }
  return out;
}

}  // namespace

GltfValues gltf_values(const GltfDocument& document, const GltfJson& accessor) {
  const Items items = items_of(document, accessor);
  const int bytes = bytes_of_component(items.component);
  GltfValues out;
  out.num_components = items.num_components;
  out.values.reserve(items.count * static_cast<size_t>(items.num_components));
  for (size_t i = 0; i < items.count; ++i)
    for (int c = 0; c < items.num_components; ++c)
      out.values.push_back(component_at(items.first + i * items.stride + c * bytes, items));
  return out;
}

// Turned as assimp does it, so that the triangles are those of the model.
std::vector<std::array<std::uint32_t, 3>> gltf_triangles(const GltfDocument& document,
                                                         const GltfJson& primitive,
                                                         size_t num_vertices) {
  const GltfJson& given = member(primitive, "mode");
  const auto mode = given.is_null() ? kTriangles : static_cast<int>(index_from(given));
  std::vector<std::array<std::uint32_t, 3>> out;
  if (mode < kTriangles || mode > kFan) return out;
  const std::vector<std::uint32_t> ids = indices_of(document, primitive, num_vertices);
  if (mode == kTriangles) {
    out.reserve(ids.size() / 3);
    for (size_t i = 0; i + 2 < ids.size(); i += 3) out.push_back({ids[i], ids[i + 1], ids[i + 2]});
    return out;
  }
  out.reserve(ids.size());
  for (size_t i = 0; i + 2 < ids.size(); ++i) {
    if (mode == kFan)
      out.push_back({ids[0], ids[i + 1], ids[i + 2]});
    else if (i % 2 == 0)
      out.push_back({ids[i], ids[i + 1], ids[i + 2]});
    else
      out.push_back({ids[i + 1], ids[i], ids[i + 2]});
  }
  return out;
}

float number_or(const GltfJson& value, float otherwise) {
  if (!value.is_number()) return otherwise;
  const auto number = static_cast<float>(value.get<double>());
  return std::isfinite(number) ? number : otherwise;
}

}  // namespace trivet
