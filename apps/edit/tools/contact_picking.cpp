#include "apps/edit/tools/contact_picking.h"

#include <algorithm>

#include "ops/operations/turn_axis.h"

namespace trivet::edit {
namespace {

constexpr double kPointPx = 7, kEdgePx = 5;

/// Best hit so far: by part, then by distance.
struct Best {
  std::optional<ActiveContact> contact;
  double distance = kInfinity;

  void offer(const ActiveContact& other, double px) {
    const bool better =
        !contact || other.part > contact->part || (other.part == contact->part && px < distance);
    if (!better) return;
    contact = other;
    distance = px;
  }
};

void offer_parts(const ObjectContact& entry, const View& view, const Vec2& px, Best& best) {
  const std::vector<Vec3>& hull = entry.contact.hull;
  std::vector<Vec2> outline;
  for (const Vec3& p : hull) {
    const auto at = view.project(p);
    if (!at) return;
    outline.push_back(*at);
  }
  for (const Vec3& p : hull) {
    const auto at = view.project(p);
    const double distance = (*at - px).norm();
    if (distance <= kPointPx) best.offer({entry.with, ActiveContact::Part::Point, p}, distance);
  }
  for (size_t i = 0; hull.size() > 1 && i < hull.size(); ++i) {
    const size_t j = (i + 1) % hull.size();
    const double distance = distance_px(px, outline[i], outline[j]);
    if (distance <= kEdgePx)
      best.offer({entry.with, ActiveContact::Part::Edge, 0.5 * (hull[i] + hull[j])}, distance);
  }
  if (entry.contact.type == ContactType::Area && is_inside(px, outline))
    best.offer({entry.with, ActiveContact::Part::Area, centre_of(entry.contact)}, 0);
}

}  // namespace

double distance_px(const Vec2& px, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double squared = d.squaredNorm();
  const double t = squared > 0 ? std::clamp(d.dot(px - a) / squared, 0.0, 1.0) : 0;
  return (px - a - t * d).norm();
}

bool is_inside(const Vec2& px, const std::vector<Vec2>& polygon) {
  bool inside = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > px.y()) == (b.y() > px.y())) continue;
    if (px.x() < (b.x() - a.x()) * (px.y() - a.y()) / (b.y() - a.y()) + a.x()) inside = !inside;
  }
  return inside;
}

std::optional<ActiveContact> pick_contact(const SceneSnapshot& scene, const Selection& selection,
                                          const View& view, const Vec2& px) {
  const auto id = selection.active();
  const ObjectSnapshot* const object = id ? scene.find(*id) : nullptr;
  Best best;
  if (object)
    for (const ObjectContact& entry : (*object)->contacts) offer_parts(entry, view, px, best);
  return best.contact;
}

std::vector<std::array<Vec3, 2>> contact_lines(const Contact& contact, const ActiveContact& part,
                                               double size) {
  std::vector<std::array<Vec3, 2>> out;
  const std::vector<Vec3>& hull = contact.hull;
  if (part.part == ActiveContact::Part::Point || hull.size() < 2) {
    const Vec3 at = contact.points.empty() ? part.near : held_point(contact, part.near);
    for (int k = 0; k < 3; ++k)
      out.push_back({at - 0.5 * size * Vec3::Unit(k), at + 0.5 * size * Vec3::Unit(k)});
    return out;
  }
  if (part.part == ActiveContact::Part::Edge) return {held_line(contact, part.near)};
  for (size_t i = 0; i < hull.size(); ++i) out.push_back({hull[i], hull[(i + 1) % hull.size()]});
  return out;
}

}  // namespace trivet::edit
