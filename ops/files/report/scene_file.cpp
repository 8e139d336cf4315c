#include "ops/files/report/scene_file.h"

#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/io/export.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/read_model.h"
#include "core/model/exported_floats.h"
#include "ops/files/report/extras.h"
#include "ops/files/report/glb_nodes.h"
#include "ops/files/report/models_of_shapes.h"
#include "ops/files/report/report.h"
#include "ops/files/report/temporary_file.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

ExportScene export_scene(const Scene& scene, const SceneFileOptions& options) {
  std::map<std::uint32_t, const LoadSupport::Entry*> entry_of;
  const LoadSupport list = load_support(scene);
  for (const LoadSupport::Entry& entry : list.entries) entry_of[entry.object.index] = &entry;
  ExportScene out;
  out.origin = export_origin(scene.box());
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    const auto it = entry_of.find(id.index);
    const LoadSupport::Entry* entry = it == entry_of.end() ? nullptr : it->second;
    out.objects.push_back({object.name, object.model, object.world_from_object(),
                           node_extras(scene, object, entry, options)});
  }
  return out;
}

ExportScene whole_export(const Scene& scene, const Layout& layout,
                         const SceneFileOptions& options) {
  const WholeModels whole(scene);
  ExportScene out = export_scene(whole.scene(), options);
  out.extras_json = scene_extras(whole.scene(), layout, options);
  return out;
}

[[noreturn]] void fail_changed(const std::string& path, const Sentence& what) {
  throw Error(Error::Kind::BadInput,
              "%1: %2 since Trivet wrote it; accepted: scenes as Trivet wrote them", path, what);
}

// For every model the first placed object that shows it; nothing for models that none shows.
std::vector<std::string> nodes_of_models(const TrivetExtras& extras) {
  std::vector<std::string> nodes(extras.models.size());
  for (const ExtrasObject& object : extras.objects)
    if (object.pose && nodes[object.model].empty()) nodes[object.model] = object.name;
  return nodes;
}

class SceneReader {
 public:
  SceneReader(const std::string& path, const ImportLimits& limits, const std::string& folder)
      : m_path(path),
        m_folder(folder.empty() ? std::filesystem::path(path).parent_path().string() : folder),
        m_limits(limits),
        m_extras(parse_scene_extras(read_scene_extras(path).scene_json, path)) {}

  SceneFile read() {
    read_models();
    m_file.scene.floor = m_extras.floor;
    m_file.scene.floor_material = m_extras.floor_material;
    m_file.scene.floor_kind = m_extras.floor_kind;
    m_file.scene.pair_rules = m_extras.pair_rules;
    for (const ExtrasObject& object : m_extras.objects) add_object(object);
    hang_links();
    check_poses();
    m_file.layout = std::move(m_extras.layout);
    m_file.clearance = m_extras.clearance;
    if (const auto why =
            refuse_too_coarse(m_file.scene, std::span<const PlacedBox>(), m_file.clearance))
      throw Error(Error::Kind::BadInput, "%1: %2", m_path, message(*why));
    return std::move(m_file);
  }

 private:
  void read_models() {
    const std::vector<std::string> nodes = nodes_of_models(m_extras);
    std::vector<std::pair<std::string, StoredGeometry>> wanted;
    for (size_t i = 0; i < nodes.size(); ++i)
      if (!nodes[i].empty()) wanted.emplace_back(nodes[i], m_extras.models[i].geometry);
    std::vector<Model> stored = read_node_models(m_path, wanted, m_limits);
    size_t next = 0;
    for (size_t i = 0; i < nodes.size(); ++i) {
      const ExtrasModel& entry = m_extras.models[i];
      m_models.push_back(nodes[i].empty() ? unshown(entry) : best_of(entry, stored[next++]));
      if (!m_models.back()) continue;
      m_models.back()->path = entry.path;
      m_models.back()->tessellation = entry.tessellation;
      m_centre_of[m_models.back().get()] = entry.geometry.centre;
    }
    m_shapes.resize(nodes.size());
  }

  // Model that no node shows.
  std::shared_ptr<Model> unshown(const ExtrasModel& entry) const {
    return entry.mesh ? std::make_shared<Model>(*entry.mesh) : own_file(entry);
  }

  // The scene file's geometry if nothing was lost, else the model's own file, else with a note.
  std::shared_ptr<Model> best_of(const ExtrasModel& entry, Model stored) {
    Model model = restored(std::move(stored), entry.geometry);
    if (geometry_fingerprint(model.mesh) != entry.geometry.stored_fingerprint)
      fail_changed(m_path, say("the geometry of \"%1\" was changed", entry.path));
    if (entry.geometry.stored_fingerprint == entry.geometry.fingerprint)
      return std::make_shared<Model>(std::move(model));
    if (entry.mesh) {
      model.mesh = entry.mesh->mesh;
      model.rounded_appearance = model.appearance != nullptr;
      return std::make_shared<Model>(std::move(model));
    }
    if (auto own = own_file(entry)) return own;
    m_file.notes.push_back(
        say("the geometry of \"%1\" is that of the scene file, rounded to float32: the model file "
            "is missing or has changed",
            entry.path));
    return std::make_shared<Model>(std::move(model));
  }

  std::shared_ptr<Model> own_file(const ExtrasModel& entry) const {
    if (entry.path.empty()) return nullptr;
    try {
      const auto path = std::filesystem::path(m_folder) / entry.path;
      auto model =
          std::make_shared<Model>(import_model(path.string(), m_limits, entry.tessellation));
      if (geometry_fingerprint(model->mesh) == entry.geometry.fingerprint) return model;
    } catch (const Error&) {
      // Treated as missing.
    }
    return nullptr;
  }

  void add_object(const ExtrasObject& entry) {
    const auto& model = m_models[entry.model];
    if (!model) {
      m_file.notes.push_back(
          say("\"%1\", which was out of the scene, is left out: \"%2\" is missing or has changed",
              entry.name, m_extras.models[entry.model].path));
      return;
    }
    auto& shape = m_shapes[entry.model];
    const auto& judged = m_extras.models[entry.model].collision;
    if (!shape) shape = make_shape((judged ? judged : model)->mesh);
    Object object;
    object.name = entry.name;
    object.model = model;
    object.shape = shape;
    object.up = entry.up, object.scale = entry.scale, object.fixed = entry.fixed;
    object.placed = entry.pose.has_value();
    if (entry.pose) object.pose = *entry.pose;
    object.state = entry.state;
    object.locked = entry.locked, object.group = entry.group;
    object.material = entry.material;
    object.pair_kind = entry.pair_kind;
    if (entry.mass) give_mass(*entry.mass, object);
    object.flexible = entry.flexible;
    m_file.scene.add(std::move(object));
  }

  void hang_links() {
    for (const ExtrasObject& entry : m_extras.objects) {
      const auto link = m_file.scene.find(entry.name);
      if (!entry.joint || !link) continue;
      const auto parent = m_file.scene.find(entry.joint->in);
      if (!parent || closes_circle(*link, *parent))
        fail_changed(m_path, say("the joint of \"%1\" was changed", entry.name));
      hang(m_file.scene, *link, *parent, entry.joint->joint);
    }
  }

  bool closes_circle(ObjectId link, ObjectId parent) const {
    return root_of(m_file.scene, parent) == link;
  }

  // Other programs must see the scene that Trivet has.
  void check_poses() const {
    std::map<std::string, NodePose> node_of;
    NodePoses nodes = read_node_poses(m_path);
    if (nodes.origin != m_extras.origin) fail_changed(m_path, "the scene was moved");
    for (NodePose& node : nodes.nodes) node_of[node.name] = std::move(node);
    for (const ObjectId id : m_file.scene.ids()) {
      const Object& object = m_file.scene.at(id);
      if (!object.placed) continue;
      const NodePose& node = node_of[object.name];
      const Affine near = relative_to(m_extras.origin, object.world_from_object());
      const NodeMatrix rows =
          node_matrix({object.name, object.model, relative_to(node.place, near), ""},
                      m_centre_of.at(object.model.get()));
      const std::vector<double>& columns = node.matrix;
      bool same = columns.size() == 16;
      for (int r = 0; same && r < 3; ++r)
        for (int c = 0; c < 4; ++c) same &= static_cast<float>(columns[c * 4 + r]) == rows[r][c];
      if (!same) fail_changed(m_path, say("\"%1\" was moved", object.name));
    }
  }

  const std::string m_path, m_folder;
  const ImportLimits m_limits;
  TrivetExtras m_extras;
  SceneFile m_file;
  std::vector<std::shared_ptr<Model>> m_models;  // null: no longer available
  std::map<const Model*, Vec3> m_centre_of;
  std::vector<std::shared_ptr<const Shape>> m_shapes;  // made when an object needs it
};

}  // namespace

void write_scene_file(const Scene& scene, const Layout& layout, const SceneFileOptions& options,
                      const std::string& path) {
  write_scene(whole_export(scene, layout, options), path);
}

SceneFile read_scene_file(const std::string& path, const ImportLimits& limits,
                          const std::string& folder) {
  try {
    return SceneReader(path, limits, folder).read();
  } catch (const Error& e) {
    const std::string message = e.what();
    if (message.find(path) != std::string::npos) throw;
    throw Error(e.kind(), "%1: %2", path, e.sentence());
  }
}

std::string scene_file_bytes(const Scene& scene, const Layout& layout,
                             const SceneFileOptions& options) {
  return scene_bytes(whole_export(scene, layout, options), ".glb");
}

SceneFile read_scene_bytes(const std::string& bytes, const ImportLimits& limits,
                           const std::string& folder) {
  const TemporaryFile file(bytes, ".glb");
  try {
    return SceneReader(file.path(), limits, folder.empty() ? "." : folder).read();
  } catch (const Error& e) {
    std::string message = e.what();
    for (size_t at; (at = message.find(file.path())) != std::string::npos;)
      message.replace(at, file.path().size(), "scene");
    throw Error(e.kind(), message);
  }
}

bool is_scene_file(const std::string& path) {
  return has_trivet_extras(read_scene_extras(path).scene_json);
}

}  // namespace trivet
