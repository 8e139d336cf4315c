#include <draco/compression/decode.h>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/gltf/compressed.h"

namespace trivet::gltf {
namespace {

constexpr int kMostComponents = 4;

float scaled(std::int32_t value, float scale) {
  const auto out = static_cast<float>(value);
  return scale == 0 ? out : std::max(out / scale, -1.0f);
}

// As the attribute has them: floats, or integers to be scaled.
bool read_value(const draco::PointAttribute& attribute, draco::AttributeValueIndex at, float scale,
                float* out) {
  const auto n = static_cast<std::int8_t>(attribute.num_components());
  if (attribute.data_type() == draco::DT_FLOAT32) return attribute.ConvertValue<float>(at, n, out);
  std::array<std::int32_t, kMostComponents> integers{};
  if (!attribute.ConvertValue<std::int32_t>(at, n, integers.data())) return false;
  for (size_t c = 0; c < static_cast<size_t>(n); ++c) out[c] = scaled(integers[c], scale);
  return true;
}

GltfValues values_of(const draco::Mesh& mesh, const DracoAttribute& wanted) {
  const draco::PointAttribute* const attribute = mesh.GetAttributeByUniqueId(wanted.id);
  if (!attribute || attribute->num_components() < 1 ||
      attribute->num_components() > kMostComponents)
    bad_input("its Draco data has no attribute %1", wanted.id);
  GltfValues out;
  out.num_components = attribute->num_components();
  const auto width = static_cast<size_t>(out.num_components);
  out.values.resize(mesh.num_points() * width);
  for (std::uint32_t p = 0; p < mesh.num_points(); ++p) {
    const draco::AttributeValueIndex at = attribute->mapped_index(draco::PointIndex(p));
    if (at.value() >= attribute->size() ||
        !read_value(*attribute, at, wanted.scale, &out.values[p * width]))
      bad_input("its Draco data is damaged: a point without a value");
  }
  return out;
}

}  // namespace

DracoMesh decoded_draco(std::string_view bytes, const std::vector<DracoAttribute>& wanted) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
    bad_input("its Draco data is damaged: %1", printable(decoded.status().error_msg_string()));
  const draco::Mesh& mesh = *decoded.value();
  DracoMesh out;
  out.indices.reserve(3 * static_cast<size_t>(mesh.num_faces()));
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
    for (const draco::PointIndex& point : mesh.face(draco::FaceIndex(f))) {
      if (point.value() >= mesh.num_points())
        bad_input("its Draco data is damaged: a face without a point");
      out.indices.push_back(point.value());
    }
  for (const DracoAttribute& attribute : wanted)
    out.attributes.emplace(attribute.id, values_of(mesh, attribute));
  return out;
}

}  // namespace trivet::gltf
