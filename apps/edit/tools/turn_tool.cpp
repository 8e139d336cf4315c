#include "apps/edit/tools/turn_tool.h"

#include <QtGlobal>

#include "apps/edit/tools/contact_picking.h"
#include "apps/edit/tools/placing.h"

namespace trivet::edit {
namespace {

constexpr double kCrossPx = 12;
constexpr double kAxisPx = 60;

}  // namespace

TurnOperation turn_about(const SceneSnapshot& scene, const Selection& selection,
                         const Vec3& view_axis) {
  TurnOperation turn;
  const ObjectContact* const entry = active_object_contact(selection, scene);
  if (!entry) return turn;
  turn.with = entry->with.is_object() ? (*scene.find(entry->with.object()))->name : "floor";
  if (!selection.contact || selection.contact->part == ActiveContact::Part::Area) return turn;
  turn.point = selection.contact->near;
  const bool edge =
      selection.contact->part == ActiveContact::Part::Edge && entry->contact.hull.size() > 1;
  turn.about = edge ? TurnOperation::About::Line : TurnOperation::About::Point;
  if (!edge)
    turn.axis = Vec3(rounded(view_axis.x(), 1e-6), rounded(view_axis.y(), 1e-6),
                     rounded(view_axis.z(), 1e-6));
  return turn;
}

bool TurnTool::grab(const PointerEvent& event) {
  if (const auto contact = pick_contact(scene(), m_document.selection(), event.view, event.px)) {
    Selection selection = m_document.selection();
    selection.contact = contact;
    m_document.select(std::move(selection));
    return true;
  }
  return grab_object(event) != nullptr;
}

std::optional<Operation> TurnTool::begin() {
  const ObjectSnapshot* const object = active();
  const ObjectContact* const entry = active_object_contact(m_document.selection(), scene());
  if (!object) return std::nullopt;
  TurnOperation turn = turn_about(scene(), m_document.selection(), m_pressed->view.axes().back);
  turn.object = (*object)->name;
  turn.settle = m_options.let_go;
  turn.settle_left = m_options.settle_left;
  if (entry) {
    m_axis = turn_axis(*object->object, entry->contact, turn);
    // Fixes the direction of the axis, so that the turn follows the mouse.
    if (turn.about == TurnOperation::About::Line) turn.axis = m_axis->direction;
    m_turning = Turning(*m_pressed, m_axis->centre, m_axis->direction);
  }
  return turn;
}

void TurnTool::steer(const PointerEvent& event) {
  m_document.drag_by(m_turning.follow(event, angle_step(event)));
}

void TurnTool::steer_by(const std::vector<double>& values) { m_document.drag_by(values[0]); }

void TurnTool::hover(const PointerEvent& event) {
  m_axis.reset();
  m_hovered = pick_contact(scene(), m_document.selection(), event.view, event.px);
}

Overlay TurnTool::overlay(const View& view) const {
  Overlay overlay = DragTool::overlay(view);
  if (m_axis && m_is_drag) {
    const Vec3 arm = kAxisPx * view.metres_per_px(view.depth(m_axis->centre)) * m_axis->direction;
    overlay.lines.push_back({Overlay::Role::Hint, m_axis->centre - arm, m_axis->centre + arm});
    return overlay;
  }
  Selection shown = m_document.selection();
  if (m_hovered) shown.contact = m_hovered;
  const ObjectContact* const entry = active_object_contact(shown, scene());
  if (!entry || !shown.contact) return overlay;
  const double size = kCrossPx * view.metres_per_px(view.depth(shown.contact->near));
  for (const auto& [a, b] : contact_lines(entry->contact, *shown.contact, size))
    overlay.lines.push_back({Overlay::Role::HoverEdge, a, b});
  return overlay;
}

std::string TurnTool::hint() const {
  return QT_TRANSLATE_NOOP(
      "tools",
      "Click a contact point, edge or area, then drag to turn about it; hold Control for steps, "
      "or type degrees");
}

}  // namespace trivet::edit
