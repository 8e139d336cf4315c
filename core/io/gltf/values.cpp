#include "core/io/gltf/values.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/bad_input.h"
#include "core/io/gltf/component_types.h"

namespace trivet {
namespace {

constexpr int kPoints = 0, kLines = 1, kLineLoop = 2, kTriangles = 4, kStrip = 5, kFan = 6;
// Zeros take no bytes of a file.
constexpr size_t kMostWithoutData = size_t{1} << 24;

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

/// Rows of an accessor within the buffer; the first is null where there is no data.
struct Items {
  const char* first = nullptr;
  size_t count = 0, stride = 0;
  int component = 0, num_components = 0;
  bool normalised = false;

  size_t row_bytes() const {
    return static_cast<size_t>(bytes_of_component(component)) * static_cast<size_t>(num_components);
  }
};

size_t index_or_zero(const GltfJson& value) { return value.is_null() ? 0 : index_from(value); }

// `place` has the view and an offset in it: an accessor, or a part of a sparse one.
void find_rows(const GltfDocument& document, const GltfJson& place, Items& items) {
  const GltfJson& view = element(document.json, "bufferViews", member(place, "bufferView"));
  const size_t row = items.row_bytes();
  items.stride = index_or_zero(member(view, "byteStride"));
  if (items.stride == 0) items.stride = row;
  if (items.stride < row)
    bad_input("a stride of %1 bytes is less than an item of %2", items.stride, row);
  const size_t begin = index_or_zero(member(view, "byteOffset"));
  const size_t length = index_from(member(view, "byteLength"));
  const size_t offset = index_or_zero(member(place, "byteOffset"));
  const size_t size = document.binary.size();
  const bool view_fits = begin <= size && length <= size - begin;
  const bool fits = items.count == 0 || (offset <= length && row <= length - offset &&
                                         (length - offset - row) / items.stride >= items.count - 1);
  if (!view_fits || !fits) bad_input("an accessor extends beyond its buffer");
  items.first = document.binary.data() + begin + offset;
}

Items items_of(const GltfDocument& document, const GltfJson& accessor) {
  Items out;
  out.component = static_cast<int>(index_from(member(accessor, "componentType")));
  out.num_components = components_of_type(member(accessor, "type"));
  out.normalised = member(accessor, "normalized") == true;
  out.count = index_from(member(accessor, "count"));
  if (accessor.contains("bufferView")) {
    find_rows(document, accessor, out);
  } else if (bytes_of_component(out.component); out.count > kMostWithoutData) {
    bad_input("an accessor has %1 items and no data; accepted: up to %2", out.count,
              kMostWithoutData);
  }
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

std::uint32_t id_at(const char* at, int component) {
  switch (component) {
    case gltf::kUnsignedByte:
      return loaded<std::uint8_t>(at);
    case gltf::kUnsignedShort:
      return loaded<std::uint16_t>(at);
    case gltf::kUnsignedInt:
      return loaded<std::uint32_t>(at);
    default:
      bad_input("indices have the component type %1; accepted: 5121, 5123 and 5125", component);
  }
}

void read_row(const char* at, const Items& items, float* out) {
  const int bytes = bytes_of_component(items.component);
  if (items.component == gltf::kFloat)  // most are
    std::memcpy(out, at, static_cast<size_t>(items.num_components) * sizeof(float));
  else
    for (int c = 0; c < items.num_components; ++c) out[c] = component_at(at + c * bytes, items);
}

// Calls replace(row, bytes of its new value) for each row that a sparse accessor has otherwise.
template <class F>
void for_each_replaced(const GltfDocument& document, const GltfJson& accessor, const Items& items,
                       F replace) {
  const GltfJson& sparse = member(accessor, "sparse");
  if (sparse.is_null()) return;
  Items rows, values = items;
  rows.count = values.count = index_from(member(sparse, "count"));
  rows.component = static_cast<int>(index_from(member(member(sparse, "indices"), "componentType")));
  rows.num_components = 1;
  find_rows(document, member(sparse, "indices"), rows);
  find_rows(document, member(sparse, "values"), values);
  for (size_t i = 0; i < rows.count; ++i) {
    const size_t row = id_at(rows.first + i * rows.stride, rows.component);
    if (row >= items.count)
      bad_input("a sparse accessor of %1 items replaces item %2", items.count, row);
    replace(row, values.first + i * values.stride);
  }
}

std::vector<std::uint32_t> all_ids(size_t count) {
  std::vector<std::uint32_t> out(count);
  for (size_t i = 0; i < count; ++i) out[i] = static_cast<std::uint32_t>(i);
  return out;
}

int mode_of(const GltfJson& primitive) {
  const GltfJson& given = member(primitive, "mode");
  const size_t mode = given.is_null() ? kTriangles : index_from(given);
  if (mode > kFan) bad_input("a primitive has the mode %1; accepted: 0 to 6", mode);
  return static_cast<int>(mode);
}

std::uint64_t num_corners(const GltfJson& root, const GltfJson& primitive) {
  const GltfJson& indices = member(primitive, "indices");
  const GltfJson& positions = member(member(primitive, "attributes"), "POSITION");
  const GltfJson& counted = indices.is_null() ? positions : indices;
  return index_from(member(element(root, "accessors", counted), "count"));
}

}  // namespace

GltfValues gltf_values(const GltfDocument& document, const GltfJson& id) {
  const GltfJson& accessor = element(document.json, "accessors", id);
  const Items items = items_of(document, accessor);
  GltfValues out;
  out.num_components = items.num_components;
  const auto width = static_cast<size_t>(items.num_components);
  out.values.resize(items.count * width);
  for (size_t i = 0; items.first && i < items.count; ++i)
    read_row(items.first + i * items.stride, items, &out.values[i * width]);
  for_each_replaced(document, accessor, items, [&](size_t row, const char* bytes) {
    read_row(bytes, items, &out.values[row * width]);
  });
  return out;
}

std::vector<std::uint32_t> gltf_indices(const GltfDocument& document, const GltfJson& id,
                                        size_t num_vertices) {
  const GltfJson& accessor = element(document.json, "accessors", id);
  const Items items = items_of(document, accessor);
  std::vector<std::uint32_t> out(items.count, 0);
  for (size_t i = 0; items.first && i < items.count; ++i)
    out[i] = id_at(items.first + i * items.stride, items.component);
  for_each_replaced(document, accessor, items, [&](size_t row, const char* bytes) {
    out[row] = id_at(bytes, items.component);
  });
  for (size_t i = 0; i < out.size(); ++i)
    if (out[i] >= num_vertices)
      bad_input("index %1 refers to vertex %2 of %3", i, out[i], num_vertices);
  return out;
}

GltfFaces count_faces(const GltfJson& root, const GltfJson& primitive) {
  const std::uint64_t n = num_corners(root, primitive);
  const int mode = mode_of(primitive);
  GltfFaces out;
  if (mode == kPoints) out.points = n;
  if (mode == kLines) out.lines = n / 2;
  if (mode == kLineLoop) out.lines = n;
  if (mode > kLineLoop && mode < kTriangles) out.lines = n - std::min<std::uint64_t>(n, 1);
  if (mode == kTriangles) out.triangles = n / 3, out.left_over = n % 3;
  if (mode > kTriangles) out.triangles = n - std::min<std::uint64_t>(n, 2);
  return out;
}

std::vector<std::array<std::uint32_t, 3>> gltf_triangles(const GltfDocument& document,
                                                         const GltfJson& primitive,
                                                         size_t num_vertices) {
  const int mode = mode_of(primitive);
  std::vector<std::array<std::uint32_t, 3>> out;
  if (mode < kTriangles) return out;
  const GltfJson& indices = member(primitive, "indices");
  const std::vector<std::uint32_t> ids =
      indices.is_null() ? all_ids(num_vertices) : gltf_indices(document, indices, num_vertices);
  out.reserve(mode == kTriangles ? ids.size() / 3 : ids.size());
  if (mode == kTriangles) {
    for (size_t i = 0; i + 2 < ids.size(); i += 3) out.push_back({ids[i], ids[i + 1], ids[i + 2]});
    return out;
  }
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
