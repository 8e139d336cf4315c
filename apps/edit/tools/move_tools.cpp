#include "apps/edit/tools/move_tools.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "apps/edit/tools/placing.h"
#include "ops/operations/push_axes.h"

namespace trivet::edit {
namespace {

constexpr double kSteepest = 0.5;  // cosine: PUSH is level on what is not steeper than 60 degrees
constexpr double kFlatView =
    0.12;  // sine: on planes seen flatter, the mouse is followed across the view

// Displacement of the mouse on a plane through `from`; if seen edge-on, across the view.
Vec3 way_on_plane(const PointerEvent& pressed, const PointerEvent& now, const Vec3& from,
                  const Vec3& normal) {
  const bool edge_on = std::abs(normal.dot(pressed.ray().direction.normalized())) < kFlatView;
  const Vec3 plane = edge_on ? pressed.view.axes().back : normal;
  const auto a = on_plane(pressed.ray(), from, plane), b = on_plane(now.ray(), from, plane);
  return a && b ? Vec3(*b - *a) : Vec3(Vec3::Zero());
}

bool is_load(const SceneSnapshot& scene, ObjectId object, const Support& other) {
  const std::vector<ObjectId> moving = with_loads(scene, object);
  return other.is_object() &&
         std::find(moving.begin(), moving.end(), other.object()) != moving.end();
}

}  // namespace

// --- PUSH --------------------------------------------------------------------------------------

bool PushTool::grab(const PointerEvent& event) {
  const ObjectSnapshot* const object = grab_object(event);
  if (!object) return false;
  const ObjectContact* const entry = active_object_contact(m_document.selection(), scene());
  m_normal = entry && !is_load(scene(), object->id, entry->with) ? entry->contact.normal
                                                                 : Vec3(Vec3::UnitZ());
  m_above = Vec3::UnitZ();
  if (m_normal.z() < kSteepest)
    for (int k = 0; k < 3; ++k) m_above[k] = rounded(m_normal[k], 1e-6);
  m_start = in_push_axes(m_above, (*object)->pose.translation);
  return true;
}

std::optional<Operation> PushTool::begin() {
  const ObjectSnapshot* const object = active();
  if (!object) return std::nullopt;
  auto push = operation_of<PushOperation>(*object->object);
  push.normal = m_above;
  set_push_options(m_options, *object->object, push);
  return push;
}

void PushTool::steer(const PointerEvent& event) {
  const Vec3 way = way_on_plane(*m_pressed, event, m_grabbed_at, m_normal);
  Vec2 goal = (m_start + in_push_axes(m_above, way)).head<2>();
  const double step = event.view.metres_per_px(event.view.depth(m_grabbed_at)) / kGoalsPerPx;
  for (int k = 0; k < 2; ++k) goal[k] = rounded(goal[k], step);
  if (snaps(event)) goal = snapped(event, goal);
  m_document.drag_to(Vec3(goal.x(), goal.y(), 0));
}

Vec2 PushTool::snapped(const PointerEvent& event, const Vec2& goal) {
  if (const auto found = snapped_way(event))
    return (m_start + in_push_axes(m_above, *found)).head<2>();
  if (!m_options.snap.grid) return goal;
  note_grid();
  const Vec3 base = in_push_axes(m_above, grabbed());
  Vec2 out;
  for (int k = 0; k < 2; ++k) out[k] = m_start[k] + on_grid_from(base[k], goal[k] - m_start[k]);
  return out;
}

TypedNumbers PushTool::numbers() const {
  if (is_level(m_above)) return {{"x", "y"}, 0, " m"};
  return {{QCoreApplication::translate("tools", "right").toStdString(),
           QCoreApplication::translate("tools", "up").toStdString()},
          0,
          " m"};
}

void PushTool::steer_by(const std::vector<double>& values) {
  m_document.drag_to(m_start + Vec3(values[0], values[1], 0));
}

std::string PushTool::hint() const {
  return QT_TRANSLATE_NOOP(
      "tools",
      "Drag an object along the surface it lies on, or a wall it touches (V: its "
      "next contact); type x and y meanwhile; Control snaps");
}

// --- PICK-UP -----------------------------------------------------------------------------------

bool PickUpTool::grab(const PointerEvent& event) {
  if (!grab_object(event)) return false;
  const ObjectContact* const entry = active_object_contact(m_document.selection(), scene());
  m_direction = entry ? entry->contact.normal : Vec3(Vec3::UnitZ());
  return true;
}

std::optional<Operation> PickUpTool::begin() {
  const ObjectSnapshot* const object = active();
  if (!object) return std::nullopt;
  return operation_of<PickUpOperation>(*object->object);
}

void PickUpTool::steer(const PointerEvent& event) {
  const double metres = event.view.metres_per_px(event.view.depth(m_grabbed_at));
  const auto a = on_line(m_pressed->ray(), m_grabbed_at, m_direction);
  const auto b = on_line(event.ray(), m_grabbed_at, m_direction);
  // When looking along the direction, upwards on the screen means away.
  double distance = metres * (m_pressed->px.y() - event.px.y());
  if (a && b && std::abs(m_direction.dot(event.view.forward())) < 0.95)
    distance = (*b - *a).dot(m_direction);
  m_document.drag_by(std::max(0.0, rounded(distance, metres / kGoalsPerPx)));
}

void PickUpTool::steer_by(const std::vector<double>& values) {
  m_document.drag_by(std::max(0.0, values[0]));
}

bool PickUpTool::pick_up() {
  const ObjectSnapshot* const object = active();
  if (!object) return false;
  auto pick_up = operation_of<PickUpOperation>(*object->object);
  pick_up.distance = m_options.pick_up_distance;
  m_document.perform(pick_up);
  return true;
}

std::string PickUpTool::hint() const {
  return QT_TRANSLATE_NOOP("tools",
                           "Click an object to pick it up, or drag it away from its support");
}

}  // namespace trivet::edit
