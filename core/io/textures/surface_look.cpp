#include "core/io/textures/surface_look.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/io/gltf/instances.h"
#include "core/io/look.h"
#include "core/io/textures/surface_materials.h"

namespace trivet {
namespace {

using Corners2 = std::array<Eigen::Vector2f, 3>;
using Corners4 = std::array<Eigen::Vector4f, 3>;

bool adds_something(const SurfaceLook& look) {
  return !look.colours.empty() ||
         std::any_of(look.finishes.begin(), look.finishes.end(), [](const SurfaceFinish& f) {
           return f.has_texture() || f.transparency == Transparency::Cut ||
                  f.emitted != std::array<float, 3>{} || f.glass.share > 0;
         });
}

/// Walks the triangles of an appearance in the model's order.
class LookReader {
 public:
  explicit LookReader(const Model& model)
      : m_model(model), m_document(*model.appearance->document), m_materials(m_document) {}

  /// Null: the appearance adds nothing, or has not the model's triangles.
  std::unique_ptr<SurfaceLook> read() {
    m_look = std::make_unique<SurfaceLook>();
    for (const GltfInstance& instance :
         gltf_tree(m_document.json, m_model.appearance->roots).instances)
      read_mesh(instance);
    m_look->materials = std::move(m_materials.materials);
    m_look->finishes = std::move(m_materials.finishes);
    if (m_look->face_material.size() != m_model.mesh.triangles.size()) return nullptr;
    drop_unused();
    return adds_something(*m_look) ? std::move(m_look) : nullptr;
  }

  const std::vector<std::pair<size_t, bool>>& images() const { return m_materials.images; }

 private:
  void read_mesh(const GltfInstance& instance) {
    m_mirrored = mirrors(instance.object_from_mesh);
    const GltfJson& node = m_document.json["nodes"][static_cast<size_t>(instance.node)];
    for (const GltfJson& primitive :
         member(element(m_document.json, "meshes", node["mesh"]), "primitives"))
      read_primitive(primitive);
  }

  void read_primitive(const GltfJson& primitive) {
    const GltfJson& attributes = member(primitive, "attributes");
    const GltfJson& positions = member(attributes, "POSITION");
    if (positions.is_null()) return;
    const GltfJson& accessor = element(m_document.json, "accessors", positions);
    auto faces = gltf_triangles(m_document, primitive, index_from(member(accessor, "count")));
    if (faces.empty()) return;
    if (m_mirrored)  // as the importer turns them
      for (auto& face : faces) std::swap(face[1], face[2]);
    const Material plain = m_model.materials.empty() ? Material() : m_model.materials.front();
    const Index material = m_materials.add(primitive, plain);
    m_look->face_material.insert(m_look->face_material.end(), faces.size(), material);
    for (size_t set = 0; set < 2; ++set)
      append(values(attributes, set == 0 ? "TEXCOORD_0" : "TEXCOORD_1"), faces,
             m_look->coordinates[set]);
    append(values(attributes, "COLOR_0"), faces, m_look->colours);
    m_is_coloured |= !member(attributes, "COLOR_0").is_null();
  }

  GltfValues values(const GltfJson& attributes, const char* name) const {
    const GltfJson& id = member(attributes, name);
    return id.is_null() ? GltfValues() : gltf_values(m_document, id);
  }

  template <class Corner>
  static void append(const GltfValues& from, const std::vector<std::array<std::uint32_t, 3>>& faces,
                     std::vector<std::array<Corner, 3>>& out) {
    for (const auto& face : faces) {
      auto& corners = out.emplace_back();
      for (size_t k = 0; k < 3; ++k) corners[k] = corner(from, face[k], Corner());
    }
  }
  static Eigen::Vector2f corner(const GltfValues& from, size_t i, const Eigen::Vector2f&) {
    if (from.num_components != 2 || i >= from.size()) return Eigen::Vector2f::Zero();
    const Eigen::Vector2f at(from.values[2 * i], from.values[2 * i + 1]);
    return at.allFinite() ? at : Eigen::Vector2f::Zero();
  }
  static Eigen::Vector4f corner(const GltfValues& from, size_t i, const Eigen::Vector4f&) {
    Eigen::Vector4f out = Eigen::Vector4f::Ones();
    if (from.num_components < 3 || i >= from.size()) return out;
    for (int c = 0; c < from.num_components; ++c) {
      const float value = from.values[i * static_cast<size_t>(from.num_components) + c];
      out[c] = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 1.0f;
    }
    return out;
  }

  void drop_unused() {
    std::array<bool, 2> used{};
    for (const SurfaceFinish& f : m_look->finishes)
      for (const TextureUse* use : {&f.base_colour, &f.metallic_roughness, &f.normal, &f.emission})
        if (*use) used[static_cast<size_t>(use->set)] = true;
    for (size_t set = 0; set < 2; ++set)
      if (!used[set]) m_look->coordinates[set] = {};
    if (!m_is_coloured) m_look->colours = {};
  }

  const Model& m_model;
  const GltfDocument& m_document;
  SurfaceMaterials m_materials;
  std::unique_ptr<SurfaceLook> m_look;
  bool m_is_coloured = false, m_mirrored = false;
};

/// Broken looks are none: the importer has noted them.
std::unique_ptr<SurfaceLook> undecoded_look(const Model& model,
                                            std::vector<std::pair<size_t, bool>>& images) {
  if (!model.appearance) return nullptr;
  try {
    LookReader reader(model);
    auto look = reader.read();
    images = reader.images();
    return look;
  } catch (const Error&) {
    return nullptr;
  } catch (const GltfJson::exception&) {
    return nullptr;
  }
}

SharedBytes bytes_of_image(const Model& model, size_t image) {
  const auto& images = model.appearance->document->images;
  return image < images.size() ? images[image] : nullptr;
}

std::string name_of_image(const Model& model, size_t image) {
  const GltfJson& json = member(model.appearance->document->json, "images");
  const std::string name = image < json.size() ? printable(name_of(json[image]), 100) : "";
  return name.empty() ? "number " + std::to_string(image) : name;
}

std::shared_ptr<const TextureImage> decoded(const SharedBytes& bytes, bool srgb) {
  if (!bytes) return nullptr;
  try {
    return std::make_shared<TextureImage>(make_texture_image(decode_image(*bytes), srgb));
  } catch (const Error&) {
    return nullptr;
  }
}

// False: nothing can be dropped.
bool drop_finest(SurfaceLook& look) {
  bool dropped = false;
  for (auto& image : look.images) {
    if (!image || image->levels.size() < 2) continue;
    auto smaller = std::make_shared<TextureImage>(*image);
    smaller->levels.erase(smaller->levels.begin());
    image = std::move(smaller);
    dropped = true;
  }
  return dropped;
}

// Uses of images that could not be decoded become none.
void drop_undecoded(SurfaceLook& look) {
  for (SurfaceFinish& f : look.finishes)
    for (TextureUse* use : {&f.base_colour, &f.metallic_roughness, &f.normal, &f.emission})
      if (*use && !look.images[static_cast<size_t>(use->image)]) *use = {};
}

// Materials whose alpha is the same everywhere are drawn by that number: glass, or opaque.
void settle_transparency(SurfaceLook& look) {
  const bool see_through_corners =
      std::any_of(look.colours.begin(), look.colours.end(), [](const Corners4& face) {
        return std::any_of(face.begin(), face.end(), [](const auto& c) { return c[3] < 1; });
      });
  for (size_t m = 0; m < look.finishes.size(); ++m) {
    SurfaceFinish& f = look.finishes[m];
    const bool by_image =
        f.base_colour && look.images[static_cast<size_t>(f.base_colour.image)]->has_alpha;
    if (by_image || see_through_corners) continue;
    if (f.transparency == Transparency::Blend || look.materials[m].base_colour[3] >= 1)
      f.transparency = Transparency::None;
  }
}

// From the derivatives of positions by texture coordinates; per face, as they are for maps that no
// tangents came with.
Eigen::Vector4f tangent_of(const Triangle& triangle, const Corners2& corners,
                           const TextureUse& use) {
  std::array<Vec2, 3> at;
  for (size_t k = 0; k < 3; ++k)
    for (int r = 0; r < 2; ++r) {
      const auto& row = use.transform[static_cast<size_t>(r)];
      at[k][r] = double(row[0]) * corners[k].x() + double(row[1]) * corners[k].y() + row[2];
    }
  const Vec3 e1 = triangle[1] - triangle[0], e2 = triangle[2] - triangle[0];
  const Vec2 d1 = at[1] - at[0], d2 = at[2] - at[0];
  const double area = d1.x() * d2.y() - d2.x() * d1.y();
  const Vec3 right = (area < 0 ? -1.0 : 1.0) * (e1 * d2.y() - e2 * d1.y());
  const double length = right.norm();
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0, 1};
  const Eigen::Vector3f unit = (right / length).cast<float>();
  // v runs down: an image that is not mirrored has its corners clockwise in (u, v).
  return {unit.x(), unit.y(), unit.z(), area < 0 ? 1.0f : -1.0f};
}

void add_tangents(const Mesh& mesh, SurfaceLook& look) {
  if (std::none_of(look.finishes.begin(), look.finishes.end(),
                   [](const SurfaceFinish& f) { return bool(f.normal); }))
    return;
  look.tangents.assign(look.face_material.size(), Eigen::Vector4f(0, 0, 0, 1));
  for (size_t f = 0; f < look.tangents.size(); ++f) {
    const TextureUse& use = look.finishes[static_cast<size_t>(look.face_material[f])].normal;
    if (use)
      look.tangents[f] = tangent_of(mesh.triangle(static_cast<Index>(f)),
                                    look.coordinates[static_cast<size_t>(use.set)][f], use);
  }
}

}  // namespace

size_t SurfaceLook::image_bytes() const {
  size_t sum = 0;
  for (const auto& image : images) sum += image ? image->num_bytes() : 0;
  return sum;
}

std::shared_ptr<const SurfaceLook> surface_look(const Model& model, size_t max_bytes) {
  std::vector<std::pair<size_t, bool>> images;
  std::unique_ptr<SurfaceLook> look = undecoded_look(model, images);
  if (!look) return nullptr;
  look->images.reserve(images.size());
  for (const auto& [image, srgb] : images) {
    look->images.push_back(decoded(bytes_of_image(model, image), srgb));
    while (look->image_bytes() > max_bytes && drop_finest(*look)) {
    }
  }
  drop_undecoded(*look);
  if (!adds_something(*look)) return nullptr;
  settle_transparency(*look);
  add_tangents(model.mesh, *look);
  return look;
}

std::vector<ImageSummary> images_of(const Model& model) {
  std::vector<ImageSummary> out;
  if (!model.appearance) return out;
  const GltfDocument& document = *model.appearance->document;
  out.reserve(document.images.size());
  for (size_t i = 0; i < document.images.size(); ++i) {
    const SharedBytes& bytes = document.images[i];
    ImageSummary image;
    image.name = name_of_image(model, i);
    if (bytes) image.kind = image_kind(*bytes), image.bytes = bytes->size();
    try {
      const DecodedImage texels = decode_image(bytes ? *bytes : std::string());
      image.width = texels.width, image.height = texels.height;
    } catch (const Error&) {
      // The notes of the model say why.
    }
    out.push_back(std::move(image));
  }
  return out;
}

std::vector<Sentence> undrawn_textures(const Model& model) {
  if (!model.appearance || model.appearance->document->images.empty()) return {};
  std::vector<std::pair<size_t, bool>> images;
  undecoded_look(model, images);
  std::set<size_t> seen;
  std::vector<Sentence> notes;
  for (const auto& [image, srgb] : images) {
    const SharedBytes bytes = bytes_of_image(model, image);
    if (!bytes || !seen.insert(image).second) continue;
    try {
      decode_image(*bytes);
    } catch (const Error& error) {
      notes.push_back(
          say("not drawn: the image \"%1\" %2", name_of_image(model, image), error.sentence()));
    }
  }
  return notes;
}

}  // namespace trivet
