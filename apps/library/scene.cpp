#include "trivet/scene.h"

#include <dlfcn.h>

#include <filesystem>

#include "apps/library/scene_internal.h"
#include "core/base/bad_input.h"
#include "core/io/process/sandboxed_import.h"
#include "core/scene/fingerprint.h"
#include "core/scene/materials.h"
#include "ops/detect/backend.h"

namespace trivet::v0 {
namespace {

OpenedSession empty_session(bool floor) {
  trivet::Scene scene;
  scene.floor = floor;
  Layout layout;
  layout.floor = floor;
  return {Session(std::move(scene), std::move(layout), ModelSource{}), "", "", 0, {}};
}

State outer(ObjectState state) {
  switch (state) {
    case ObjectState::Unplaced:
      return State::Unplaced;
    case ObjectState::Fixed:
      return State::Fixed;
    case ObjectState::Stable:
      return State::Stable;
    case ObjectState::Wedged:
      return State::Wedged;
    case ObjectState::Held:
      return State::Held;
    case ObjectState::Unsupported:
      return State::Unsupported;
    case ObjectState::Invalid:
      break;
  }
  return State::Invalid;
}

Contact::Type outer(ContactType type) {
  switch (type) {
    case ContactType::Point:
      return Contact::Type::Point;
    case ContactType::Line:
      return Contact::Type::Line;
    case ContactType::Area:
      break;
  }
  return Contact::Type::Area;
}

Contact outer(const trivet::Scene& scene, const ObjectContact& touch) {
  Contact out;
  out.with = name_of(scene, touch.with);
  out.type = outer(touch.contact.type);
  for (const trivet::ContactPoint& p : touch.contact.points)
    out.points.push_back({v0::outer(p.point), v0::outer(p.normal), p.gap});
  return out;
}

void add_links(const trivet::Scene& scene, const Object& object, ObjectInfo& info) {
  for (const ObjectContact& touch : object.contacts) {
    const std::string with = name_of(scene, touch.with);
    if (holds_up(touch.contact)) info.supports.push_back(with);
    if (weighs_on(touch.contact)) info.loads.push_back(with);
    info.contacts.push_back(outer(scene, touch));
  }
}

AppendOperation append_of(const std::string& name, const Model& model, const AddOptions& options) {
  AppendOperation append;
  append.object = name;
  append.scale = options.scale;
  append.fixed = options.fixed;
  if (options.y_up) append.up = *options.y_up ? UpAxis::Y : UpAxis::Z;
  append.model_data = model.internal().model;
  append.shape = model.shape().internal().shape;
  if (options.material) append.material = inner(*options.material);
  return append;
}

}  // namespace

PhysicsMaterial inner(const Material& m) { return {m.name, m.friction, m.density, m.restitution}; }
Material outer(const PhysicsMaterial& m) { return {m.name, m.friction, m.density, m.restitution}; }

std::string name_of(const trivet::Scene& scene, const Support& support) {
  return support.is_floor() ? kFloorName : scene.at(support.object()).name;
}

namespace {

// Looks above the folder of this library: PREFIX/lib/libtrivet.so, PREFIX/bin/trivet-import.
std::string importer_of_installation() {
  Dl_info info{};
  if (!dladdr(reinterpret_cast<const void*>(&version), &info) || !info.dli_fname) return "";
  for (std::filesystem::path folder = std::filesystem::path(info.dli_fname).parent_path();
       folder.has_relative_path(); folder = folder.parent_path())
    if (const auto file = folder / "bin" / "trivet-import"; std::filesystem::exists(file))
      return file.string();
  return "";
}

}  // namespace

ImportLimits usual_limits() {
  ImportLimits limits;
  limits.importer = find_importer();
  if (limits.importer.empty()) limits.importer = importer_of_installation();
  return limits;
}

Scene scene_of(OpenedSession opened, Rules rules) {
  const SettleOptions settle = with_rules({}, opened.rules);
  rules.perfect_friction = settle.perfect_friction;
  rules.whole_at_rest = settle.whole_at_rest;
  rules.robust = settle.robust;
  if (!(rules.clearance > 0)) rules.clearance = opened.clearance;
  auto internal = std::make_unique<Scene::Internal>(std::move(opened));
  internal->rules = rules;
  return Scene(std::move(internal));
}

SettleOptions Scene::Internal::settle() const {
  SettleOptions out;
  out.clearance = rules.clearance;
  out.perfect_friction = rules.perfect_friction;
  out.whole_at_rest = rules.whole_at_rest;
  out.robust = rules.robust;
  out.max_motions = rules.max_motions;
  return out;
}

const Object& Scene::Internal::at(ObjectId id) const {
  if (!scene().contains(inner(id)))
    bad_input("object: slot %1, generation %2 is not in the scene; accepted: ids of objects()",
              id.index, id.generation);
  return scene().at(inner(id));
}

Scene::Scene(const Rules& rules, bool floor)
    : m_internal(std::make_unique<Internal>(empty_session(floor))) {
  m_internal->rules = rules;
}
Scene::Scene(std::unique_ptr<Internal> internal) : m_internal(std::move(internal)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::Scene(const Scene& other)
    : m_internal(std::make_unique<Internal>(copy_of(other.m_internal->opened(), usual_limits()))) {
  m_internal->rules = other.m_internal->rules;
}
Scene& Scene::operator=(const Scene& other) {
  if (this != &other) *this = Scene(other);
  return *this;
}

const Rules& Scene::rules() const { return m_internal->rules; }
void Scene::set_rules(const Rules& rules) { m_internal->rules = rules; }

std::string Scene::set_detector(DetectorKind kind) {
  return guarded([&] {
    BackendOptions options;
    options.backend = kind == DetectorKind::Gpu        ? Backend::Gpu
                      : kind == DetectorKind::Software ? Backend::Software
                                                       : Backend::Bvh;
    options.make_gpu_stage = [](const GpuNotes&) { return gpu_stage(); };
    m_internal->detector = make_detector(options);
    return m_internal->detector->device();
  });
}

ObjectId Scene::add(const std::string& name, const Model& model, const AddOptions& options) {
  return guarded([&] {
    std::vector<Operation> operations{append_of(name, model, options)};
    if (options.pose) {
      StandOperation stand;
      stand.object = name;
      stand.pose = inner(*options.pose);
      operations.emplace_back(std::move(stand));
    }
    const Result result = m_internal->perform(operations);
    if (!result.ok()) bad_input(result.reason());
    return v0::outer(*m_internal->scene().find(name));
  });
}

Result Scene::remove(ObjectId object) {
  return guarded([&] {
    DeleteOperation operation;
    operation.object = m_internal->name(object);
    return m_internal->perform({operation});
  });
}

std::optional<ObjectId> Scene::find(const std::string& name) const {
  const auto found = m_internal->scene().find(name);
  return found ? std::optional(v0::outer(*found)) : std::nullopt;
}

std::vector<ObjectId> Scene::objects() const {
  std::vector<ObjectId> out;
  for (const trivet::ObjectId id : m_internal->scene().ids()) out.push_back(v0::outer(id));
  return out;
}

bool Scene::contains(ObjectId object) const { return m_internal->scene().contains(inner(object)); }

ObjectInfo Scene::info(ObjectId id) const {
  return guarded([&] {
    const Object& object = m_internal->at(id);
    ObjectInfo out;
    out.name = object.name;
    out.pose = v0::outer(object.pose);
    out.scale = object.scale;
    out.fixed = object.fixed, out.locked = object.locked, out.placed = object.placed;
    out.group = object.group;
    out.material = v0::outer(object.material);
    out.state = outer(object.state);
    out.box = v0::outer(m_internal->scene().world_box(inner(id)));
    out.centre_of_mass = v0::outer(object.centre_of_mass());
    out.stability_margin = object.stability_margin;
    out.least_friction = object.least_friction;
    add_links(m_internal->scene(), object, out);
    return out;
  });
}

Model Scene::model(ObjectId id) const {
  return guarded([&] {
    const Object& object = m_internal->at(id);
    return Model(std::make_shared<Model::Internal>(Model::Internal{
        object.model, object.model ? object.model->path : std::string(),
        object.model ? in_english(object.model->notes) : std::vector<std::string>()}));
  });
}

Result Scene::set_fixed(ObjectId object, bool fixed) {
  return guarded([&] {
    FixOperation operation;
    operation.object = m_internal->name(object);
    operation.fixed = fixed;
    return m_internal->perform({operation});
  });
}

Result Scene::set_material(ObjectId object, const Material& material) {
  return guarded([&] {
    MaterialOperation operation;
    operation.object = m_internal->name(object);
    operation.material = inner(material);
    return m_internal->perform({operation});
  });
}

bool Scene::undo() {
  return guarded([&] { return m_internal->session().undo(); });
}
bool Scene::redo() {
  return guarded([&] { return m_internal->session().redo(); });
}
std::uint64_t Scene::fingerprint() const { return trivet::fingerprint(m_internal->scene()); }

Material material_preset(const std::string& name) {
  return guarded([&] {
    if (const auto found = trivet::material_preset(name)) return outer(*found);
    std::string known;
    for (const std::string& one : material_names()) known += (known.empty() ? "" : ", ") + one;
    bad_input("material: \"%1\" is not accepted; accepted: %2", name, known);
  });
}

const char* to_string(State state) {
  switch (state) {
    case State::Unplaced:
      return trivet::to_string(ObjectState::Unplaced);
    case State::Fixed:
      return trivet::to_string(ObjectState::Fixed);
    case State::Stable:
      return trivet::to_string(ObjectState::Stable);
    case State::Wedged:
      return trivet::to_string(ObjectState::Wedged);
    case State::Held:
      return trivet::to_string(ObjectState::Held);
    case State::Unsupported:
      return trivet::to_string(ObjectState::Unsupported);
    case State::Invalid:
      break;
  }
  return trivet::to_string(ObjectState::Invalid);
}

}  // namespace trivet::v0
