#include "apps/edit/tools/gizmo_tool.h"

#include <QtGlobal>
#include <cmath>

#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/tools/hand_ghost.h"
#include "apps/edit/tools/placing.h"

namespace trivet::edit {
std::optional<Gizmo> GizmoTool::gizmo() const {
  const ObjectSnapshot* const object = active();
  if (!object || !(*object)->placed) return std::nullopt;
  return Gizmo{(*object)->centre_of_mass(), m_turns};
}

bool GizmoTool::grab(const PointerEvent& event) {
  if (const auto shown = gizmo()) {
    m_hot = shown->hit(event.view, event.px);
    if (m_hot) {
      m_grabbed_at = shown->centre;
      m_axis = shown->axis(*m_hot, event.view);
      return true;
    }
  }
  m_hot.reset();
  m_axis = event.view.axes().back;
  return grab_object(event) != nullptr;
}

std::optional<Operation> GizmoTool::begin() {
  const ObjectSnapshot* const object = active();
  if (!object) return std::nullopt;
  if (!m_turns) {
    auto move = operation_of<TranslateOperation>(*object->object);
    move.free = m_options.free;
    move.settle = m_options.let_go;
    return move;
  }
  auto rotate = operation_of<RotateOperation>(*object->object);
  for (int k = 0; k < 3; ++k) rotate.axis[k] = rounded(m_axis[k], 1e-6);
  rotate.free = m_options.free;
  rotate.settle = m_options.let_go;
  m_turning = Turning(*m_pressed, (*object)->centre_of_mass(), m_axis);
  return rotate;
}

// Lifted, turned and let settle: its support is not in the way.
bool GizmoTool::start(const PointerEvent& event) {
  const ObjectSnapshot* const object = active();
  const bool alone = m_document.selection().objects.size() == 1;
  if (!m_turns || !m_options.lift || m_options.free || !alone || !object ||
      (*object)->state == ObjectState::Held)
    return DragTool::start(event);
  m_lifted = object->object;
  m_lifted_id = object->id;
  m_degrees = 0;
  m_turning = Turning(*m_pressed, m_lifted->centre_of_mass(), m_axis);
  return true;
}

std::vector<Operation> GizmoTool::choices() const {
  Object turned = *m_lifted;
  Vec3 axis = m_axis;
  for (int k = 0; k < 3; ++k) axis[k] = rounded(axis[k], 1e-6);
  const Rotation turn = turned_about(axis.normalized(), std::fmod(m_degrees, 360));
  turned.pose.rotation = (turn * turned.pose.rotation).normalized();
  auto put = operation_of<PutOperation>(*m_lifted);
  put.tries = kTriesInHand;
  return put_choices(scene(), turned, with_loads(scene(), m_lifted_id), place_of(*m_lifted), put,
                     m_options.drop_height);
}

void GizmoTool::turn_to(double degrees) {
  if (!m_lifted) return m_document.drag_by(degrees);
  m_degrees = degrees;
  m_document.request_ghost_in_hand(choices());
}

void GizmoTool::end() {
  if (!m_lifted) return DragTool::end();
  put_as_shown(m_document, m_lifted_id, *m_lifted, choices());
  m_lifted.reset();
  m_document.clear_ghost();
}

void GizmoTool::give_back() {
  if (!m_lifted) return DragTool::give_back();
  m_lifted.reset();
}

Vec3 GizmoTool::way(const PointerEvent& event) const {
  const bool line = m_hot && m_hot->kind == GizmoHandle::Kind::Arrow;
  const auto at = [&](const PointerEvent& e) {
    return line ? on_line(e.ray(), m_grabbed_at, m_axis) : on_plane(e.ray(), m_grabbed_at, m_axis);
  };
  const auto a = at(*m_pressed), b = at(event);
  return a && b ? Vec3(*b - *a) : Vec3(Vec3::Zero());
}

void GizmoTool::steer(const PointerEvent& event) {
  if (m_turns) {
    turn_to(m_turning.follow(event, angle_step(event)));
  } else {
    Vec3 goal = way(event);
    const double step = event.view.metres_per_px(event.view.depth(m_grabbed_at)) / kGoalsPerPx;
    for (int k = 0; k < 3; ++k) goal[k] = rounded(goal[k], step);
    if (snaps(event)) goal = snapped(event, goal);
    m_document.drag_to(goal);
  }
  show_ghost();
}

// As far as the handle lets it: along an arrow, in the plane of a square.
Vec3 GizmoTool::snapped(const PointerEvent& event, Vec3 goal) {
  const bool line = m_hot && m_hot->kind == GizmoHandle::Kind::Arrow;
  if (const auto found = snapped_way(event)) {
    if (line) return found->dot(m_axis) * m_axis;
    return m_hot ? Vec3(*found - found->dot(m_axis) * m_axis) : *found;
  }
  if (!m_options.snap.grid) return goal;
  note_grid();
  for (int k = 0; k < 3; ++k)
    if (!m_hot || (std::abs(m_axis[k]) == 1) == line) goal[k] = on_grid_from(grabbed()[k], goal[k]);
  return goal;
}

TypedNumbers GizmoTool::numbers() const {
  if (m_turns) return {{""}, 0, "°"};
  const bool along = m_hot && m_hot->kind == GizmoHandle::Kind::Arrow;
  return {{"x", "y", "z"}, along ? static_cast<size_t>(m_hot->axis) : 0, " m"};
}

void GizmoTool::steer_by(const std::vector<double>& values) {
  if (m_turns)
    turn_to(values[0]);
  else
    m_document.drag_to(Vec3(values[0], values[1], values[2]));
  show_ghost();
}

// Previews where the object would land if released now.
void GizmoTool::show_ghost() {
  const ObjectSnapshot* const object = active();
  const bool alone = m_document.selection().objects.size() == 1;
  if (!object || !alone || m_options.free || m_lifted) return;
  auto put = operation_of<PutOperation>(*object->object);
  put.start = (*object)->pose;
  m_document.request_ghost(put);
}

void GizmoTool::hover(const PointerEvent& event) {
  const auto shown = gizmo();
  m_hot = shown ? shown->hit(event.view, event.px) : std::nullopt;
}

void GizmoTool::cancel() {
  DragTool::cancel();
  m_document.clear_ghost();
  m_hot.reset();
}

Overlay GizmoTool::overlay(const View& view) const {
  Overlay overlay = DragTool::overlay(view);
  const auto shown = gizmo();
  if (!shown) return overlay;
  for (const GizmoHandle& handle : shown->handles())
    for (const auto& [a, b] : shown->lines(handle, view))
      overlay.lines.push_back(
          {m_hot == handle ? Overlay::Role::HotHandle : Overlay::Role::Handle, a, b, handle.axis});
  return overlay;
}

std::string GizmoTool::hint() const {
  return m_turns
             ? QT_TRANSLATE_NOOP(
                   "tools",
                   "Drag a ring to turn the object; hold Control for steps, or type degrees")
             : QT_TRANSLATE_NOOP(
                   "tools",
                   "Drag an arrow, a square or the object itself; type metres, Tab for the axis");
}

}  // namespace trivet::edit
