#include "apps/edit/tools/move_tools.h"

#include <QtGlobal>
#include <cmath>

#include "apps/edit/tools/placing.h"

namespace trivet::edit {
namespace {

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

}  // namespace

// --- PUSH --------------------------------------------------------------------------------------

bool PushTool::grab(const PointerEvent& event) {
  const ObjectSnapshot* const object = grab_object(event);
  if (!object) return false;
  const ObjectContact* const entry = active_object_contact(m_document.selection(), scene());
  m_normal = entry && entry->contact.normal.z() > 0.1 ? entry->contact.normal : Vec3(Vec3::UnitZ());
  m_start = (*object)->pose.translation;
  return true;
}

std::optional<Operation> PushTool::begin() {
  const ObjectSnapshot* const object = active();
  if (!object) return std::nullopt;
  auto push = operation_of<PushOperation>(*object->object);
  push.step_up = m_options.step_up;
  push.step_down = m_options.step_down;
  push.slide = m_options.slide;
  push.settle = m_options.settle;
  return push;
}

void PushTool::steer(const PointerEvent& event) {
  Vec3 goal = m_start + way_on_plane(*m_pressed, event, m_grabbed_at, m_normal);
  const double step = event.view.metres_per_px(event.view.depth(m_grabbed_at)) / kGoalsPerPx;
  for (int k = 0; k < 2; ++k) goal[k] = rounded(goal[k], step);
  m_document.drag_to(goal);
}

void PushTool::steer_by(const std::vector<double>& values) {
  m_document.drag_to(m_start + Vec3(values[0], values[1], 0));
}

std::string PushTool::hint() const {
  return QT_TRANSLATE_NOOP(
      "tools",
      "Drag an object along the surface it lies on, or type x and y meanwhile; Escape cancels");
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
