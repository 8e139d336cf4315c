#include <algorithm>
#include <cmath>

#include "core/io/animation.h"
#include "core/io/export.h"
#include "core/io/gltf/builder.h"
#include "core/io/gltf/component_types.h"
#include "core/io/writers.h"
#include "core/model/exported_floats.h"
#include "core/motion/pose.h"

namespace trivet {
namespace {

struct NodeTransform {
  std::array<float, 3> translation;
  std::array<float, 4> rotation;  // x y z w
  float scale;
};

NodeTransform transform_of(const NodeMatrix& rows) {
  Mat3 linear;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) linear(r, c) = rows[r][c];
  const double scale = linear.col(0).norm();
  const Rotation q = Rotation::from_matrix(scale > 0 ? Mat3(linear / scale) : Mat3::Identity());
  return {{rows[0][3], rows[1][3], rows[2][3]},
          {float(q.x), float(q.y), float(q.z), float(q.w)},
          float(scale)};
}

// Adds what moves to the JSON of a scene that stands still.
class AnimationWriter {
 public:
  explicit AnimationWriter(GltfDocument& document) : m_document(document) {}

  void add(const AnimatedObject& animated, size_t node, const Vec3& origin) {
    if (animated.keys.size() < 2) return;
    const Vec3 centre =
        export_centre(animated.object.model.get(), animated.object.model->mesh.box());
    std::vector<float> times, translations, rotations, scales;
    std::optional<NodeTransform> last;
    bool hides = false;
    for (const AnimationKey& key : shown_always(animated.keys)) {
      ExportObject placed = relative_to(origin, animated.object);
      placed.world_from_object = relative_to(origin, key.world_from_file);
      NodeTransform now = transform_of(node_matrix(placed, centre));
      if (last) turn_the_short_way(*last, now);
      const float least = times.empty() ? 0 : std::nextafter(times.back(), INFINITY);
      times.push_back(std::max(float(key.time), least));  // ascending in float32, too
      translations.insert(translations.end(), now.translation.begin(), now.translation.end());
      rotations.insert(rotations.end(), now.rotation.begin(), now.rotation.end());
      scales.insert(scales.end(), 3, key.hidden ? 0.0f : now.scale);
      hides |= key.hidden;
      last = now;
    }
    set_node(node, translations, rotations, scales);
    const size_t input = add_times(times);
    add_channel(node, "translation", "LINEAR", input, add_values(translations, "VEC3", 3));
    add_channel(node, "rotation", "LINEAR", input, add_values(rotations, "VEC4", 4));
    if (hides) add_channel(node, "scale", "STEP", input, add_values(scales, "VEC3", 3));
  }

  void finish() {
    if (m_channels.empty()) return;
    m_document.json["animations"] =
        GltfJson::array({{{"name", "motion"}, {"channels", m_channels}, {"samplers", m_samplers}}});
  }

 private:
  // Hidden objects wait where they will be seen next, or were seen last.
  static std::vector<AnimationKey> shown_always(std::vector<AnimationKey> keys) {
    for (size_t i = keys.size() - 1; i-- > 0;)
      if (keys[i].hidden) keys[i].world_from_file = keys[i + 1].world_from_file;
    for (size_t i = 1; i < keys.size(); ++i)
      if (keys[i].hidden && !keys[i - 1].hidden)
        keys[i].world_from_file = keys[i - 1].world_from_file;
    return keys;
  }

  static void turn_the_short_way(const NodeTransform& from, NodeTransform& to) {
    float dot = 0;
    for (int k = 0; k < 4; ++k) dot += from.rotation[k] * to.rotation[k];
    if (dot < 0)
      for (float& x : to.rotation) x = 0.0f - x;
  }

  // Animated nodes have no matrix. Where the animation begins.
  void set_node(size_t node, const std::vector<float>& t, const std::vector<float>& r,
                const std::vector<float>& s) {
    GltfJson& json = m_document.json["nodes"][node];
    json.erase("matrix");
    json["translation"] = {t[0], t[1], t[2]};
    json["rotation"] = {r[0], r[1], r[2], r[3]};
    json["scale"] = {s[0], s[1], s[2]};
  }

  size_t add_values(const std::vector<float>& values, const char* type, size_t components) {
    std::string& binary = m_document.binary;
    binary.resize((binary.size() + 3) / 4 * 4);
    GltfJson& views = m_document.json["bufferViews"];
    GltfJson& accessors = m_document.json["accessors"];
    accessors.push_back({{"bufferView", views.size()},
                         {"componentType", gltf::kFloat},
                         {"count", values.size() / components},
                         {"type", type}});
    views.push_back({{"buffer", 0},
                     {"byteOffset", binary.size()},
                     {"byteLength", values.size() * sizeof(float)}});
    for (const float value : values) append_bytes(binary, value);
    return accessors.size() - 1;
  }
  size_t add_times(const std::vector<float>& times) {
    const size_t id = add_values(times, "SCALAR", 1);
    m_document.json["accessors"][id]["min"] = {times.front()};
    m_document.json["accessors"][id]["max"] = {times.back()};
    return id;
  }
  void add_channel(size_t node, const char* path, const char* interpolation, size_t input,
                   size_t output) {
    m_channels.push_back(
        {{"sampler", m_samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
    m_samplers.push_back({{"input", input}, {"interpolation", interpolation}, {"output", output}});
  }

  GltfDocument& m_document;
  GltfJson m_channels = GltfJson::array(), m_samplers = GltfJson::array();
};

// Nodes of the objects, in their order.
std::vector<int> object_nodes(const GltfDocument& document, const AnimatedScene& scene) {
  std::vector<int> roots = scene.objects.empty() ? std::vector<int>() : scene_roots(document.json);
  if (scene.origin.isZero(0) || roots.empty()) return roots;
  std::vector<int> children;
  const GltfJson root(static_cast<unsigned>(roots.front()));
  const GltfJson& nodes = element(document.json, "nodes", root)["children"];
  children.reserve(nodes.size());
  for (const GltfJson& child : nodes) children.push_back(static_cast<int>(index_from(child)));
  return children;
}

}  // namespace

std::string animated_glb(const AnimatedScene& scene) {
  ExportScene still;
  still.origin = scene.origin;
  still.objects.reserve(scene.objects.size());
  for (const AnimatedObject& animated : scene.objects) still.objects.push_back(animated.object);
  GltfDocument document = gltf_document(still);
  const std::vector<int> nodes = object_nodes(document, scene);
  AnimationWriter writer(document);
  for (size_t i = 0; i < scene.objects.size(); ++i)
    writer.add(scene.objects[i], static_cast<size_t>(nodes[i]), scene.origin);
  writer.finish();
  return glb_bytes(std::move(document));
}

}  // namespace trivet
