#include "apps/edit/document/many.h"

#include <algorithm>
#include <cmath>

#include "apps/edit/document/dice.h"
#include "apps/edit/document/names.h"
#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/document/remake.h"

namespace trivet::edit {
namespace {

const Object* placed_object(const SceneSnapshot& scene, const std::string& name) {
  const ObjectSnapshot* const found = scene.find(name);
  return found && (*found)->placed ? found->object.get() : nullptr;
}

PutOperation put_from(const std::string& object, const Pose& start) {
  PutOperation put;
  put.object = object;
  put.start = start;
  return put;
}

Pose shifted(Pose pose, const Vec3& by) {
  pose.translation += by;
  return pose;
}

/// Poses of the copies, without that of the original.
std::vector<Pose> array_poses(const Pose& first, const ArrayWish& wish) {
  std::vector<Pose> out;
  out.reserve(static_cast<size_t>(std::max({wish.count, wish.rows * wish.columns, 0})));
  switch (wish.kind) {
    case ArrayWish::Kind::Line:
      for (int i = 1; i < wish.count; ++i) out.push_back(shifted(first, i * wish.step));
      break;
    case ArrayWish::Kind::Grid:
      for (int j = 0; j < wish.columns; ++j)
        for (int i = j == 0 ? 1 : 0; i < wish.rows; ++i)
          out.push_back(shifted(first, Vec3(i * wish.step.x(), j * wish.step.y(), 0)));
      break;
    case ArrayWish::Kind::Circle: {
      const Vec3 centre = first.translation + Vec3(wish.centre.x(), wish.centre.y(), 0);
      const bool round = std::abs(wish.angle_deg) >= 360;
      for (int i = 1; i < wish.count; ++i) {
        const double deg = wish.angle_deg * i / (round ? wish.count : wish.count - 1);
        const Rotation turn = turned_about(Vec3::UnitZ(), deg);
        Pose pose = first;
        pose.translation = centre + turn.matrix() * (first.translation - centre);
        if (wish.turned) pose.rotation = (turn * first.rotation).normalized();
        out.push_back(pose);
      }
    }
  }
  return out;
}

constexpr double kHeapPerObject = 0.3;  // of its size: a heap grows by less with each

PutOperation scattered_put(const std::string& name, const Rotation& rotation,
                           const ScatterWish& wish, Dice& dice) {
  PutOperation put = put_from(name, {dice.turned(wish.turn, rotation), Vec3::Zero()});
  PlaceOptions place;
  place.on = wish.on;
  place.seed = dice.seed();
  place.keep = wish.keep;
  if (wish.region) {
    const auto& [lower, upper] = *wish.region;
    const double x = dice.uniform(lower.x(), upper.x());
    place.near = Vec2(x, dice.uniform(lower.y(), upper.y()));
  }
  put.place = place;
  return put;
}

/// Part of a support, about its middle, where a pile falls: its rim is no place for it.
constexpr double kMiddle = 0.35;

/// The rectangle over which a pile falls.
ScatterWish::Region pile_region(const SceneSnapshot& scene, const ScatterWish& wish, double size) {
  if (wish.region) return *wish.region;
  const Object* const on = placed_object(scene, wish.on);
  const Aabb box = on ? world_box(*on) : scene.box();
  const Vec3 centre = box.empty() ? Vec3(Vec3::Zero()) : box.centre();
  const Vec3 half = on ? Vec3(kMiddle * box.half_extent()) : Vec3(Vec3::Constant(size));
  return {(centre - half).head<2>(), (centre + half).head<2>()};
}

/// From above all that is there, and what fell before: one falls onto the other.
PutOperation piled_put(const SceneSnapshot& scene, const std::string& name, Object object,
                       size_t before, const ScatterWish& wish, Dice& dice) {
  object.pose = {dice.turned(wish.turn, object.pose.rotation), Vec3::Zero()};
  const Aabb box = world_box(object);
  const auto [lower, upper] = pile_region(scene, wish, box.diagonal());
  const double x = dice.uniform(lower.x(), upper.x()), y = dice.uniform(lower.y(), upper.y());
  const Object* const on = placed_object(scene, wish.on);
  const double top = on ? world_box(*on).upper.z() : 0;
  const double above = top + kHeapPerObject * static_cast<double>(before + 1) * box.diagonal();
  const Vec3 centre = box.centre();
  PutOperation put = put_from(
      name, {object.pose.rotation, Vec3(x - centre.x(), y - centre.y(), above - box.lower.z())});
  return put;
}

/// An object that is to be aligned.
struct InRow {
  const Object* object;
  double lower, upper;  // of its box along the axis
  double by = 0;        // metres to move along the axis
};

void align(std::vector<InRow>& row, AlignWish::How how) {
  const InRow last = row.back();
  for (InRow& r : row)
    r.by = how == AlignWish::How::Lower   ? last.lower - r.lower
           : how == AlignWish::How::Upper ? last.upper - r.upper
                                          : (last.lower + last.upper - r.lower - r.upper) / 2;
}

void space_evenly(std::vector<InRow>& row) {
  std::sort(row.begin(), row.end(),
            [](const InRow& a, const InRow& b) { return a.lower + a.upper < b.lower + b.upper; });
  double gap = row.back().lower - row.front().upper;
  for (size_t i = 1; i + 1 < row.size(); ++i) gap -= row[i].upper - row[i].lower;
  if (row.size() > 2) gap /= static_cast<double>(row.size() - 1);
  double at = row.front().upper;
  for (size_t i = 1; i + 1 < row.size(); ++i) {
    row[i].by = at + gap - row[i].lower;
    at += gap + row[i].upper - row[i].lower;
  }
}

}  // namespace

ManyObjects array_of(const SceneSnapshot& scene, const ArrayWish& wish) {
  ManyObjects out;
  const Object* const original = placed_object(scene, wish.object);
  if (!original) return out;
  NewNames names(scene);
  for (const Pose& pose : array_poses(original->pose, wish)) {
    const std::string name = names.like(wish.object);
    const Pose start = shifted(pose, Vec3(0, 0, wish.drop_height));
    out.groups.push_back({DuplicateOperation{wish.object, name}, put_from(name, start)});
    out.names.push_back(name);
  }
  return out;
}

std::vector<std::string> unplaced_names(const SceneSnapshot& scene) {
  std::vector<std::string> out;
  for (const ObjectSnapshot& object : scene.objects)
    if (!object->placed) out.push_back(object->name);
  return out;
}

ManyObjects scattered(const SceneSnapshot& scene, const ScatterWish& wish) {
  ManyObjects out;
  const std::vector<const Object*> originals = objects_named(scene, wish.objects);
  if (originals.empty()) return out;
  Dice dice(wish.seed);
  NewNames names(scene);
  for (size_t i = 0; i < static_cast<size_t>(std::max(wish.count, 0)); ++i) {
    const Object& original = *originals[i % originals.size()];
    OperationGroup group;
    std::string name = original.name;
    if (original.placed || i >= originals.size()) {
      name = names.like(original.name);
      group.push_back(DuplicateOperation{original.name, name});
    }
    group.push_back(wish.pile ? piled_put(scene, name, original, i, wish, dice)
                              : scattered_put(name, original.pose.rotation, wish, dice));
    out.groups.push_back(std::move(group));
    out.names.push_back(name);
  }
  return out;
}

ManyObjects aligned(const SceneSnapshot& scene, const AlignWish& wish) {
  ManyObjects out;
  std::vector<InRow> row;
  for (const std::string& name : wish.objects)
    if (const Object* const object = placed_object(scene, name)) {
      const Aabb box = world_box(*object);
      row.push_back({object, box.lower[wish.axis], box.upper[wish.axis]});
    }
  if (row.size() < 2) return out;
  if (wish.how == AlignWish::How::Gaps)
    space_evenly(row);
  else
    align(row, wish.how);
  // Objects that go up begin at the upper end, and objects that go down at the lower end.
  std::stable_sort(row.begin(), row.end(), [](const InRow& a, const InRow& b) {
    if ((a.by > 0) != (b.by > 0)) return a.by > 0;
    return a.by > 0 ? a.upper > b.upper : a.lower < b.lower;
  });
  for (const InRow& r : row) {
    if (r.by == 0) continue;
    Vec3 by(0, 0, wish.drop_height);
    by[wish.axis] = r.by;
    out.groups.push_back({put_from(r.object->name, shifted(r.object->pose, by))});
    out.names.push_back(r.object->name);
  }
  return out;
}

ManyObjects replaced(const SceneSnapshot& scene, const std::vector<std::string>& objects,
                     const std::string& by, double drop_height) {
  ManyObjects out;
  const ObjectSnapshot* const model = scene.find(by);
  if (!model) return out;
  NewNames names(scene);
  for (const std::string& name : objects) {
    const Object* const old = placed_object(scene, name);
    if (!old || name == by) continue;
    const Pose start = start_in_place_of(*old, *model->object, drop_height);
    const std::string copy = names.like(by);
    DeleteOperation erase;
    erase.object = name;
    out.groups.push_back({DuplicateOperation{by, copy}, erase, put_from(copy, start)});
    out.names.push_back(copy);
  }
  return out;
}

}  // namespace trivet::edit
