#include "ops/files/layout/named_objects.h"

#include <set>
#include <utility>

namespace trivet {
namespace {

LayoutObject appended(const AppendOperation& operation) {
  LayoutObject out;
  out.name = operation.object;
  out.model = operation.model;
  out.scale = operation.scale;
  out.up = operation.up;
  out.fixed = operation.fixed;
  out.tessellation = operation.tessellation;
  out.material = operation.material;
  return out;
}

// It is of no file.
LayoutObject draped(const DrapeOperation& operation) {
  LayoutObject out;
  out.name = operation.object;
  out.fixed = true;
  return out;
}

// Steps back over an operation that changes names.
// @param names  after it; brought to before it.
// @return false: by these names it was refused.
bool step_back(const Operation& operation, std::set<std::string>& names) {
  const std::string& name = object_name(operation);
  const bool removes = std::holds_alternative<DeleteOperation>(operation) ||
                       std::holds_alternative<RenameOperation>(operation);
  if (removes && names.count(name)) return false;
  if (const auto given = given_name(operation); given && !names.erase(*given->name)) return false;
  if (removes) names.insert(name);
  return true;
}

}  // namespace

std::optional<GivenName> given_name(const Operation& operation) {
  if (const auto* o = std::get_if<AppendOperation>(&operation))
    return GivenName{"object", &o->object};
  if (const auto* o = std::get_if<DrapeOperation>(&operation); o && !o->again)
    return GivenName{"object", &o->object};
  if (const auto* o = std::get_if<DuplicateOperation>(&operation)) return GivenName{"as", &o->as};
  if (const auto* o = std::get_if<RenameOperation>(&operation)) return GivenName{"to", &o->to};
  return std::nullopt;
}

NamedObjects::NamedObjects(const std::vector<LayoutObject>& objects) {
  m_objects.reserve(objects.size());
  for (const LayoutObject& object : objects) add(object);
}

void NamedObjects::add(LayoutObject object) {
  m_index[object.name] = m_objects.size();
  m_objects.emplace_back(std::move(object));
}

bool NamedObjects::follow(const Operation& operation) {
  if (std::holds_alternative<ArrangeOperation>(operation) ||
      std::holds_alternative<RepairOperation>(operation))
    return true;
  const auto* const append = std::get_if<AppendOperation>(&operation);
  const auto* drape = std::get_if<DrapeOperation>(&operation);
  if (drape && drape->again) drape = nullptr;
  const auto found = m_index.find(object_name(operation));
  if (!append && !drape && found == m_index.end()) return false;
  if (const auto given = given_name(operation); given && contains(*given->name)) return false;
  if (append) add(appended(*append));
  if (drape) add(draped(*drape));
  if (const auto* const copy = std::get_if<DuplicateOperation>(&operation)) {
    LayoutObject object = *m_objects[found->second];
    object.name = copy->as;
    object.pose.reset();
    object.fixed = false;
    object.joint.reset();
    add(std::move(object));
  } else if (const auto* const renamed = std::get_if<RenameOperation>(&operation)) {
    m_objects[found->second]->name = renamed->to;
    auto entry = m_index.extract(found);
    entry.key() = renamed->to;
    m_index.insert(std::move(entry));
  } else if (std::holds_alternative<DeleteOperation>(operation)) {
    m_objects[found->second].reset();
    m_index.erase(found);
  }
  return true;
}

const LayoutObject* NamedObjects::find(const std::string& name) const {
  const auto found = m_index.find(name);
  return found == m_index.end() ? nullptr : &*m_objects[found->second];
}

std::vector<std::string> NamedObjects::names() const {
  std::vector<std::string> out;
  out.reserve(m_index.size());
  for (const auto& object : m_objects)
    if (object) out.push_back(object->name);
  return out;
}

NamedObjects objects_after(const Layout& layout) {
  NamedObjects out(layout.objects);
  for (const Operation& operation : layout.operations) out.follow(operation);
  return out;
}

NamedObjects objects_in(const Scene& scene, const Layout& layout) {
  std::set<std::string> names;
  for (const ObjectId id : scene.ids()) names.insert(scene.at(id).name);
  std::vector<const Operation*> done;
  for (size_t i = layout.operations.size(); i-- > 0;)
    if (step_back(layout.operations[i], names)) done.push_back(&layout.operations[i]);
  NamedObjects out(layout.objects);
  for (size_t i = done.size(); i-- > 0;) out.follow(*done[i]);
  return out;
}

}  // namespace trivet
