#include "core/scene/index.h"

#include "core/base/hash.h"
#include "core/base/tunables.h"
#include "core/contact/body.h"

namespace trivet {

namespace {

// Each axis of the object is one of the world.
bool is_along_axes(const Affine& world_from_object) {
  constexpr double kNone = 1e-12;  // of what is left of a quarter turn in doubles
  const auto size = world_from_object.linear.cwiseAbs();
  return ((size.array() > kNone * size.maxCoeff()).rowwise().count() == 1).all();
}

}  // namespace

double coarse_size(const Object& object) {
  const double size = object.scale * object.shape->box.diagonal();
  if (!object.fixed) return kCoarseDiagonals * size;
  return is_along_axes(object.world_from_object()) ? 0 : size;
}

ObjectTree::Extent extent_of(const Object& object) {
  const double size = object.scale * object.shape->box.diagonal();
  return {Body(*object.shape, object.world_from_object()).world_box, size, leans(object) ? size : 0,
          coarse_size(object)};
}

std::uint64_t SceneIndex::hash_of(std::string_view text) noexcept {
  return Hash().add(text).value();
}

void SceneIndex::reserve(size_t num_slots) {
  m_tree.reserve(num_slots);
  m_names.reserve(num_slots);
  m_groups.reserve(num_slots);
  m_invalid.reserve(num_slots);
  m_free.reserve(num_slots);
}

void SceneIndex::set(Index slot, const Object* object) noexcept {
  // A slot without an object leaves all tables, and is free for the next one.
  if (!object) {
    m_free.insert(slot);
    m_names.erase(slot);
    m_groups.erase(slot);
    m_invalid.erase(slot);
    m_tree.erase(slot);
    return;
  }
  // Each table holds those objects alone that its question is about.
  m_free.erase(slot);
  m_names.set(slot, hash_of(object->name));
  if (object->group.empty())
    m_groups.erase(slot);
  else
    m_groups.set(slot, hash_of(object->group));
  if (object->state == ObjectState::Invalid)
    m_invalid.set(slot, 0);
  else
    m_invalid.erase(slot);
  if (object->placed && object->shape)
    m_tree.set(slot, extent_of(*object));
  else
    m_tree.erase(slot);
}

}  // namespace trivet
