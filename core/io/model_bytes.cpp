#include "core/io/model_bytes.h"

#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/io/gltf/document.h"
#include "core/io/look.h"
#include "core/io/sentence_json.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

constexpr std::string_view kModelMagic = "TRIVET-MODEL-1\n";
enum class Content : std::uint8_t { Model, Error };
constexpr double kMaxReadCoordinate = 1e30;  // as read_model() accepts

void put(std::string& out, std::string_view text) {
  append_bytes(out, std::uint64_t{text.size()});
  out += text;
}

template <class T>
void put_list(std::string& out, const std::vector<T>& items) {
  static_assert(std::is_trivially_copyable_v<T> || sizeof(T) % sizeof(float) == 0);
  append_bytes(out, std::uint64_t{items.size()});
  out.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
}

void put_look(std::string& out, const Appearance& look) {
  const GltfDocument& document = *look.document;
  put(out, document.json.dump(-1, ' ', false, GltfJson::error_handler_t::replace));
  put(out, document.binary);
  append_bytes(out, std::uint64_t{document.images.size()});
  for (const SharedBytes& image : document.images) {
    append_bytes(out, std::uint8_t{image != nullptr});
    put(out, image ? std::string_view(*image) : std::string_view());
  }
  put_list(out, look.roots);
}

void put_polygonisation(std::string& out, const Polygonisation& p) {
  append_bytes(out, p.chord);
  append_bytes(out, p.deviation);
  for (const int count : {p.num_faces, p.num_failed_faces, p.num_edges})
    append_bytes(out, std::int32_t{count});
}

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : m_rest(bytes) {}

  template <class T>
  T get() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view text() { return take(get<std::uint64_t>()); }

  template <class T>
  std::vector<T> list() {
    const auto count = get<std::uint64_t>();
    if (count > m_rest.size() / sizeof(T)) fail();
    const std::string_view bytes = take(count * sizeof(T));
    std::vector<T> out(count);
    if (count > 0) std::memcpy(static_cast<void*>(out.data()), bytes.data(), bytes.size());
    return out;
  }
  /// Number of items of at least one byte each.
  std::uint64_t count() {
    const auto value = get<std::uint64_t>();
    if (value > m_rest.size()) fail();
    return value;
  }
  std::string_view take(std::uint64_t size) {
    if (size > m_rest.size()) fail();
    const std::string_view out = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    return out;
  }
  void expect(bool condition) const {
    if (!condition) fail();
  }
  bool at_end() const { return m_rest.empty(); }

 private:
  [[noreturn]] static void fail() {
    throw Error(Error::Kind::BadInput, "the importer's answer is incomplete");
  }
  std::string_view m_rest;
};

void get_mesh(ByteReader& in, const ImportLimits& limits, Mesh& mesh) {
  mesh.vertices = in.list<Vec3>();
  mesh.triangles = in.list<Index3>();
  for (const Vec3& p : mesh.vertices)
    in.expect(p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxReadCoordinate);
  in.expect(!mesh.triangles.empty() &&
            static_cast<std::int64_t>(mesh.triangles.size()) <= limits.max_triangles);
  for (const Index3& triangle : mesh.triangles)
    for (const Index v : triangle)
      in.expect(v >= 0 && static_cast<size_t>(v) < mesh.vertices.size());
}

void get_appearance(ByteReader& in, Model& model) {
  const std::uint64_t num_materials = in.count();
  for (std::uint64_t i = 0; i < num_materials; ++i) {
    Material material;
    material.name = in.text();
    material.base_colour = in.get<std::array<float, 4>>();
    material.metallic = in.get<float>();
    material.roughness = in.get<float>();
    for (const float value : material.base_colour) in.expect(std::isfinite(value));
    in.expect(std::isfinite(material.metallic) && std::isfinite(material.roughness));
    model.materials.push_back(std::move(material));
  }
  model.face_material = in.list<Index>();
  const size_t num_faces = model.mesh.triangles.size();
  in.expect(!model.materials.empty() && model.face_material.size() == num_faces);
  for (const Index id : model.face_material)
    in.expect(id >= 0 && static_cast<size_t>(id) < model.materials.size());
  model.corner_normals = in.list<std::array<Eigen::Vector3f, 3>>();
  in.expect(model.corner_normals.empty() || model.corner_normals.size() == num_faces);
  for (const auto& face : model.corner_normals)
    for (const Eigen::Vector3f& n : face) in.expect(n.allFinite());
}

void get_polygonisation(ByteReader& in, Model& model) {
  if (!in.get<std::uint8_t>()) return;
  Polygonisation& p = model.polygonised.emplace();
  p.chord = in.get<double>();
  p.deviation = in.get<double>();
  for (int* const count : {&p.num_faces, &p.num_failed_faces, &p.num_edges})
    *count = in.get<std::int32_t>();
  in.expect(std::isfinite(p.chord) && std::isfinite(p.deviation));
}

// Copied as from a file, which validates every reference.
std::shared_ptr<const Appearance> get_look(ByteReader& in) {
  GltfDocument document;
  document.json = parse_gltf_json("importer", std::string(in.text()));
  document.binary = in.text();
  const std::uint64_t num_images = in.count();
  for (std::uint64_t i = 0; i < num_images; ++i) {
    const bool present = in.get<std::uint8_t>() != 0;
    const std::string_view bytes = in.text();
    document.images.push_back(present ? std::make_shared<const std::string>(bytes) : nullptr);
  }
  std::vector<Sentence> ignored;
  return appearance_of_gltf(document, in.list<int>(), ignored);
}

Model get_model(ByteReader& in, const ImportLimits& limits) {
  Model model;
  model.format = in.text();
  get_mesh(in, limits, model.mesh);
  get_appearance(in, model);
  model.up = in.get<std::uint8_t>() ? UpAxis::Y : UpAxis::Z;
  model.up_from_format = in.get<std::uint8_t>() != 0;
  const auto metres = in.get<double>();
  if (metres > 0 && std::isfinite(metres)) model.metres_per_unit = metres;
  model.num_nodes = in.get<std::int32_t>();
  const std::uint64_t num_notes = in.count();
  for (std::uint64_t i = 0; i < num_notes; ++i)
    model.notes.push_back(sentence_from_json(std::string(in.text())));
  get_polygonisation(in, model);
  if (in.get<std::uint8_t>()) model.appearance = get_look(in);
  model.rounded_appearance = in.get<std::uint8_t>() != 0;
  in.expect(in.at_end());
  return model;
}

}  // namespace

std::string bytes_of_model(const Model& model) {
  std::string out(kModelMagic);
  append_bytes(out, Content::Model);
  put(out, model.format);
  put_list(out, model.mesh.vertices);
  put_list(out, model.mesh.triangles);
  append_bytes(out, std::uint64_t{model.materials.size()});
  for (const Material& material : model.materials) {
    put(out, material.name);
    append_bytes(out, material.base_colour);
    append_bytes(out, material.metallic);
    append_bytes(out, material.roughness);
  }
  put_list(out, model.face_material);
  put_list(out, model.corner_normals);
  append_bytes(out, std::uint8_t{model.up == UpAxis::Y});
  append_bytes(out, std::uint8_t{model.up_from_format});
  append_bytes(out, model.metres_per_unit.value_or(0.0));
  append_bytes(out, std::int32_t{model.num_nodes});
  append_bytes(out, std::uint64_t{model.notes.size()});
  for (const Sentence& note : model.notes) put(out, to_json(note));
  append_bytes(out, std::uint8_t{model.polygonised.has_value()});
  if (model.polygonised) put_polygonisation(out, *model.polygonised);
  append_bytes(out, std::uint8_t{model.appearance != nullptr});
  if (model.appearance) put_look(out, *model.appearance);
  append_bytes(out, std::uint8_t{model.rounded_appearance});
  return out;
}

std::string bytes_of_error(Error::Kind kind, const Sentence& sentence) {
  std::string out(kModelMagic);
  append_bytes(out, Content::Error);
  append_bytes(out, std::uint8_t{kind == Error::Kind::Environment});
  put(out, to_json(sentence));
  return out;
}

Model model_from_bytes(std::string_view bytes, const std::string& path,
                       const ImportLimits& limits) {
  ByteReader in(bytes);
  in.expect(in.take(std::min(bytes.size(), kModelMagic.size())) == kModelMagic);
  if (in.get<Content>() == Content::Error) {
    const bool environment = in.get<std::uint8_t>() != 0;
    throw Error(environment ? Error::Kind::Environment : Error::Kind::BadInput,
                sentence_from_json(std::string(in.text())));
  }
  Model model = get_model(in, limits);
  model.path = path;
  return model;
}

}  // namespace trivet
