#include "random_changes.h"

#include <algorithm>
#include <memory>
#include <sstream>

#include "core/base/hash.h"
#include "core/contact/body.h"
#include "core/scene/fingerprint.h"
#include "core/scene/transaction.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

std::shared_ptr<const Shape> shape(int kind) {
  static const auto kBox = object_of("box", box_triangles(Vec3(0.5, 0.5, 0.5))).shape;
  static const auto kBar = object_of("bar", box_triangles(Vec3(3, 0.1, 0.1))).shape;
  static const auto kEmpty = std::make_shared<const Shape>();
  return kind == 0 ? kEmpty : kind % 2 ? kBox : kBar;
}

void place(Object& object, Random& random) {
  const double far = random.integer(0, 30) ? 5 : 1e15;
  object.pose = {random.rotation(), random.in_cube(far)};
  if (random.integer(0, 4) == 0) object.pose.translation.setZero();  // several in one place
  object.placed = random.integer(0, 5) != 0;
  const bool invalid = object.placed && random.integer(0, 4) == 0;
  object.state = invalid ? ObjectState::Invalid : ObjectState::Stable;
}

std::vector<ObjectId> those(const Scene& scene, const auto& accepts) {
  std::vector<ObjectId> out;
  for (const ObjectId id : scene.ids())
    if (accepts(scene.at(id))) out.push_back(id);
  return out;
}

Aabb box_of(const Object& object) {
  return Body(*object.shape, object.world_from_object()).world_box;
}

ObjectTree::Extent extent_by_brute_force(const Scene& scene, const std::vector<ObjectId>& without) {
  ObjectTree::Extent out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed || std::find(without.begin(), without.end(), id) != without.end()) continue;
    out.box.extend(box_of(object));
    const double diagonal = object.scale * object.shape->box.diagonal();
    if (diagonal > 0) out.smallest_diagonal = std::min(out.smallest_diagonal, diagonal);
    out.coarse_size = std::max(out.coarse_size, coarse_size(object));
  }
  return out;
}

bool same(const ObjectTree::Extent& a, const ObjectTree::Extent& b) {
  return a.box.lower == b.box.lower && a.box.upper == b.box.upper &&
         a.smallest_diagonal == b.smallest_diagonal && a.coarse_size == b.coarse_size;
}

Aabb random_box(Random& random) {
  const Vec3 centre = random.in_cube(6), half = Vec3::Constant(random.uniform(0, 3));
  return {centre - half, centre + half};
}

void print(std::ostream& out, const std::vector<ObjectId>& ids) {
  for (const ObjectId id : ids) out << " " << id.index << "." << id.generation;
  out << "\n";
}

void print(std::ostream& out, const ObjectTree::Extent& extent) {
  out << extent.box.lower.transpose() << " to " << extent.box.upper.transpose() << ", "
      << extent.smallest_diagonal << "\n";
}

}  // namespace

Object RandomChanges::new_object(const Scene& scene) {
  Object object;
  do object.name = "o" + std::to_string(m_random.integer(0, 999));
  while (scene.find(object.name));
  object.shape = shape(m_random.integer(0, 8));
  object.scale = m_random.uniform(0.1, 2);
  if (m_random.integer(0, 2) == 0) object.group = "g" + std::to_string(m_random.integer(0, 2));
  if (m_random.integer(0, 3)) place(object, m_random);
  return object;
}

void RandomChanges::move(Transaction& transaction, ObjectId id) {
  transaction.edit(id, [&](Object& object) {
    const int kind = m_random.integer(0, 5);
    if (kind == 0) object.group = "g" + std::to_string(m_random.integer(0, 2));
    if (kind == 1) object.group.clear();
    if (kind == 2) object.scale = m_random.uniform(0.1, 2);
    if (kind == 3) object.locked = !object.locked;
    if (kind > 3) place(object, m_random);
  });
}

void RandomChanges::link(Transaction& transaction, ObjectId id) {
  std::vector<ObjectContact> object_contacts;
  for (const ObjectId other : transaction.scene().ids())
    if (other != id && m_random.integer(0, 9) == 0) object_contacts.push_back({other, {}});
  if (m_random.integer(0, 1)) object_contacts.push_back({});
  for (ObjectContact& entry : object_contacts) {
    entry.contact.gap = m_random.uniform(0, 1);
    entry.contact.points.resize(m_random.integer(1, 3));
  }
  transaction.set_contacts(id, object_contacts);
}

void RandomChanges::apply(Transaction& transaction) {
  const std::vector<ObjectId> ids = transaction.scene().ids();
  const int kind = m_random.integer(0, 9);
  if (ids.empty() || kind < 3) {
    transaction.add(new_object(transaction.scene()));
    return;
  }
  const ObjectId id = ids[m_random.integer(0, static_cast<int>(ids.size()) - 1)];
  if (kind < 5)
    transaction.remove(id);
  else if (kind < 8)
    move(transaction, id);
  else
    link(transaction, id);
}

std::string all_answers(const Scene& scene) {
  std::ostringstream out;
  out.precision(17);
  out << hash_text(fingerprint(scene)) << " " << scene.num_objects() << "\n";
  const std::vector<ObjectId> ids = scene.ids();
  print(out, ids);
  for (const ObjectId id : ids) {
    const Object& object = scene.at(id);
    const Aabb box = scene.world_box(id);
    out << object.name << (scene.find(object.name) == id) << box.lower.transpose()
        << box.upper.transpose() << "\n";
    print(out, scene.near(box, 0.1));
    print(out, scene.extent_without({&id, 1}));
  }
  print(out, scene.extent_without({}));
  print(out, scene.invalid_objects());
  for (const char* group : {"", "g0", "g1", "g2"}) print(out, scene.group_members(group));
  return out.str();
}

std::string unlike_brute_force(const Scene& scene, Random& random) {
  if (!scene.is_consistent()) return "it is inconsistent";
  const Aabb box = random_box(random);
  const double margin = random.integer(0, 1) * random.uniform(0, 1);
  const auto is_near = [&](const Object& o) {
    return o.placed && overlaps(box_of(o), box, margin);
  };
  if (scene.near(box, margin) != those(scene, is_near)) return "near()";
  const auto is_invalid = [](const Object& o) { return o.state == ObjectState::Invalid; };
  if (scene.invalid_objects() != those(scene, is_invalid)) return "invalid_objects()";
  for (const char* group : {"g0", "g1", "g2", "g3"})
    if (scene.group_members(group) !=
        those(scene, [&](const Object& o) { return o.group == group; }))
      return "group_members()";
  if (!scene.group_members("").empty()) return "members of no group";
  std::vector<ObjectId> without;
  for (const ObjectId id : scene.ids())
    if (random.integer(0, 3) == 0) without.push_back(id);
  if (!same(scene.extent_without(without), extent_by_brute_force(scene, without)))
    return "extent_without()";
  const auto is_far = [&](const Object& o) { return !is_near(o); };
  if (!same(scene.extent_near(box, margin), extent_by_brute_force(scene, those(scene, is_far))))
    return "extent_near()";
  const Aabb all = extent_by_brute_force(scene, {}).box;
  if (scene.box().lower != all.lower || scene.box().upper != all.upper) return "box()";
  const std::string name = "o" + std::to_string(random.integer(0, 999));
  const auto named = those(scene, [&](const Object& o) { return o.name == name; });
  const auto found = scene.find(name);
  if (found.has_value() == named.empty() || (found && *found != named[0])) return "find()";
  return "";
}

}  // namespace trivet::test
