#include "apps/edit/tools/drape_tool.h"

#include <QCoreApplication>
#include <algorithm>

#include "apps/edit/document/names.h"
#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/tools/picking.h"
#include "core/flex/presets.h"
#include "ops/operations/cable_path.h"

namespace trivet::edit {
namespace {

constexpr double kBeside = 1.5e-3;  // metres from a surface to a cable
constexpr double kOver = 0.02;      // metres from what a cable is led over
constexpr double kHigh = 0.5;       // metres over the point from which on things are above a sheet

bool overlap_from_above(const Aabb& a, const Aabb& b) {
  return a.lower.x() <= b.upper.x() && b.lower.x() <= a.upper.x() && a.lower.y() <= b.upper.y() &&
         b.lower.y() <= a.upper.y();
}

/// The top of what is below a box, without what begins above `limit`.
double top_below(const SceneSnapshot& scene, const Aabb& box, double limit) {
  double top = scene.floor ? 0 : -kInfinity;
  for (const ObjectSnapshot& object : scene.objects) {
    if (!object->placed) continue;
    const Aabb other = world_box(*object.object);
    if (overlap_from_above(box, other) && other.lower.z() <= limit)
      top = std::max(top, other.upper.z());
  }
  return top;
}

bool is_blocked(const SceneSnapshot& scene, const Vec3& from, const Vec3& to) {
  const double length = (to - from).norm();
  if (!(length > 0)) return false;
  const auto hit = pick(scene, {from, (to - from) / length});
  return hit && (hit->point - from).norm() < length;
}

/// Straight, or over what is between.
void add_leg(const SceneSnapshot& scene, const Vec3& to, std::vector<Vec3>& path) {
  const Vec3 from = path.back();
  if (is_blocked(scene, from, to)) {
    Aabb box;
    box.extend(from), box.extend(to);
    const double top = kOver + std::max({top_below(scene, box, box.upper.z()), from.z(), to.z()});
    path.emplace_back(from.x(), from.y(), top);
    path.emplace_back(to.x(), to.y(), top);
  }
  path.push_back(to);
}

std::array<Vec3, 4> corners_of(const DrapeOperation& o) {
  const Affine world = world_from_object(o.start, UpAxis::Z, 1);
  const Vec2 half = *o.size / 2;
  return {world.apply({-half.x(), -half.y(), 0}), world.apply({half.x(), -half.y(), 0}),
          world.apply({half.x(), half.y(), 0}), world.apply({-half.x(), half.y(), 0})};
}

}  // namespace

bool DrapeTool::lays_cable() const {
  const auto* const preset = flex::flex_preset(m_options.drape_material);
  return preset && preset->is_cable;
}

std::string DrapeTool::new_name(const std::string& like) const {
  const SceneSnapshot& scene = *m_document.snapshot();
  return scene.find(like) ? NewNames(scene).like(like) : like;
}

DrapeTool::Corner DrapeTool::corner_at(const Picked& at) const {
  const double radius = flex::flex_preset(m_options.drape_material)->material.thickness / 2;
  Corner out{at.point + (radius + kBeside) * at.normal, ""};
  if (at.object) out.holder = (*m_document.snapshot()->find(*at.object))->name;
  return out;
}

// From so high that it starts clear of all that it may come down on.
DrapeOperation DrapeTool::sheet_at(const Vec3& point) const {
  DrapeOperation out;
  out.material = m_options.drape_material;
  out.object = new_name(out.material);
  out.size = Vec2(m_options.drape_width, m_options.drape_length);
  out.cell = m_options.drape_cell;
  out.start = {turned_about(Vec3::UnitZ(), m_turned_deg), point};
  Aabb box;
  for (const Vec3& corner : corners_of(out)) box.extend(corner);
  const double thickness = flex::flex_preset(out.material)->material.thickness;
  out.start.translation.z() =
      std::max(point.z(), top_below(*m_document.snapshot(), box, point.z() + kHigh)) + thickness +
      m_options.drop_height;
  return out;
}

// With slack, as leads have it, unless they go over something.
std::vector<Vec3> DrapeTool::path(const std::vector<Corner>& corners) const {
  std::vector<Vec3> out{corners.front().point};
  for (size_t i = 1; i < corners.size(); ++i)
    add_leg(*m_document.snapshot(), corners[i].point, out);
  if (out.size() > corners.size()) return out;
  return cable_path_of_length(out, (1 + m_options.drape_slack) * length_of(out));
}

bool DrapeTool::pointer(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (m_document.is_busy()) return false;
  if (event.kind == Kind::Wheel && !event.modifiers.control && !lays_cable()) {
    m_turned_deg += event.wheel_steps * m_options.angle_step_deg;
    return true;
  }
  const bool presses = event.kind == Kind::Press && event.button == MouseButton::Left;
  const bool ends = event.kind == Kind::DoubleClick && event.button == MouseButton::Left;
  if (ends && is_active()) return finish();
  if (event.kind != Kind::Move && !presses) return false;
  m_hovered.reset(), m_hovered_point.reset();
  const auto at =
      pick(*m_document.snapshot(), event.view.seen_ray(event.px), m_document.looks().hidden());
  if (at && lays_cable()) m_hovered = corner_at(*at);
  if (at) m_hovered_point = at->point;
  return presses && click(event);
}

bool DrapeTool::click(const PointerEvent&) {
  if (!m_hovered_point) return false;
  if (lays_cable())
    m_corners.push_back(*m_hovered);
  else
    m_document.perform(sheet_at(*m_hovered_point));
  return true;
}

// Ends on objects are held by these.
bool DrapeTool::finish() {
  std::vector<Corner> corners = std::move(m_corners);
  cancel();
  const auto same = [](const Corner& a, const Corner& b) { return a.point == b.point; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  if (corners.size() < 2) return true;
  DrapeOperation o;
  o.material = m_options.drape_material;
  o.object = new_name(o.material);
  o.path = path(corners);
  for (const Corner* const end : {&corners.front(), &corners.back()})
    if (!end->holder.empty()) o.pins.push_back(end->point), o.held_by.push_back(end->holder);
  m_document.perform(o);
  return true;
}

bool DrapeTool::wants_key(const KeyEvent& event) const {
  using Key = KeyEvent::Key;
  return is_active() && (event.key == Key::Return || event.key == Key::Backspace);
}

bool DrapeTool::key(const KeyEvent& event) {
  if (event.key == KeyEvent::Key::Return && is_active()) return finish();
  if (event.key == KeyEvent::Key::Backspace && is_active()) {
    m_corners.pop_back();
    return true;
  }
  if (event.key != KeyEvent::Key::Escape) return false;
  if (!m_document.is_busy()) return escape(*this, m_document);
  m_document.cancel();
  return true;
}

void DrapeTool::cancel() {
  m_corners.clear();
  m_hovered.reset(), m_hovered_point.reset();
}

Overlay DrapeTool::overlay(const View&) const {
  Overlay out;
  if (m_document.is_busy()) return out;
  const auto add = [&](const Vec3& a, const Vec3& b) {
    out.lines.push_back({Overlay::Role::Hint, a, b});
  };
  if (lays_cable()) {
    std::vector<Corner> corners = m_corners;
    if (m_hovered) corners.push_back(*m_hovered);
    if (corners.size() < 2) return out;
    const std::vector<Vec3> line = path(corners);
    for (size_t i = 0; i + 1 < line.size(); ++i) add(line[i], line[i + 1]);
  } else if (m_hovered_point) {
    const auto corners = corners_of(sheet_at(*m_hovered_point));
    for (size_t i = 0; i < corners.size(); ++i) add(corners[i], corners[(i + 1) % 4]);
  }
  return out;
}

std::string DrapeTool::hint() const {
  if (!lays_cable())
    return QT_TRANSLATE_NOOP("tools",
                             "Click: the sheet comes down there; wheel: turn; Escape stops it");
  if (!is_active())
    return QT_TRANSLATE_NOOP(
        "tools", "Click where the cable begins; an object that you click holds its end");
  return QT_TRANSLATE_NOOP("tools",
                           "Click where it goes; Return or a double click ends it; Backspace takes "
                           "the last place back, Escape all");
}

}  // namespace trivet::edit
