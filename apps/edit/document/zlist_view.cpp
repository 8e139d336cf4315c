#include "apps/edit/document/zlist_view.h"

#include <algorithm>
#include <chrono>
#include <set>

namespace trivet::edit {
namespace {

struct Bodies {
  std::vector<const Object*> moving_objects, fixed_objects;
  std::vector<Body> moving, fixed;
};

Bodies bodies_of(const ZListQuestion& question) {
  Bodies out;
  std::set<std::uint32_t> slots;
  for (const Placement& placement : question.moving) {
    const ObjectSnapshot* const found = question.scene->find(placement.id);
    if (!found) continue;
    slots.insert(placement.id.index);
    out.moving_objects.push_back(found->object.get());
    out.moving.push_back(body_of(*found->object, placement.pose));
  }
  for (const ObjectSnapshot& other : question.scene->objects) {
    if (!other->placed || slots.count(other.id.index)) continue;
    out.fixed_objects.push_back(other.object.get());
    out.fixed.push_back(body_of(*other.object));
  }
  return out;
}

void list_confirmed(const Bodies& bodies, ZListView& out) {
  std::set<std::pair<Index, Index>> moving, fixed;  // a face may be in many pairs
  for (const FacePair& pair : out.lists.confirmed()) {
    if (out.confirmed.size() == ZListView::kMostListed) break;
    out.confirmed.push_back({{bodies.moving_objects[pair.moving]->name, pair.face_moving},
                             {bodies.fixed_objects[pair.fixed]->name, pair.face_fixed},
                             shown_time(out.motion, pair.not_before)});
    if (moving.insert({pair.moving, pair.face_moving}).second)
      out.moving_faces.push_back(bodies.moving[pair.moving].triangle(pair.face_moving));
    if (fixed.insert({pair.fixed, pair.face_fixed}).second)
      out.fixed_faces.push_back(bodies.fixed[pair.fixed].triangle(pair.face_fixed));
  }
}

}  // namespace

double shown_time(const Motion& motion, double time) {
  if (motion.kind == Motion::Kind::Translation) return 1e3 * time;
  return time < kInfinity ? turned_deg(std::min(time, 1.0)) : time;
}

ZListView zlist_view(const ZListQuestion& question, CandidateFinder& finder, int resolution) {
  const auto begin = std::chrono::steady_clock::now();
  const Bodies bodies = bodies_of(question);
  ZListView out;
  out.committed = question.scene->committed;
  out.motion = question.motion;
  out.clearance = question.clearance;
  out.finder = finder.name();
  FirstContactQuery query{bodies.moving, bodies.fixed, question.scene->floor, question.motion, {}};
  query.clearance.distance = question.clearance;
  out.lists = motion_zlists(query, finder, resolution);
  for (const Index i : out.lists.depths.frame.fixed)
    out.in_the_way.push_back(bodies.fixed_objects[i]->name);
  const FirstContact& contact = out.lists.contact;
  if (contact.status != FirstContact::Status::Free)
    out.touched =
        contact.fixed == FirstContact::kFloor ? "floor" : bodies.fixed_objects[contact.fixed]->name;
  list_confirmed(bodies, out);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  out.milliseconds = took.count();
  return out;
}

}  // namespace trivet::edit
