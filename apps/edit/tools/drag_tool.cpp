#include "apps/edit/tools/drag_tool.h"

#include <QCoreApplication>

#include "apps/edit/document/joint_words.h"

namespace trivet::edit {
namespace {

constexpr double kClickPx = 3;  // a press with less motion is a click
constexpr double kSnapMarkPx = 7;
constexpr double kAxisArmPx = 60;

}  // namespace

bool DragTool::pointer(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (event.kind == Kind::Wheel) return wheel(event);
  if (event.kind == Kind::Press) {
    if (m_pressed) return true;
    if (event.button != MouseButton::Left || waits() || !grab(event)) return false;
    m_pressed = event;
    m_is_drag = false;
    grab_for_snapping(event);
    return true;
  }
  if (!m_pressed) {
    if (event.kind == Kind::Move) hover(event);
    return false;
  }
  if (event.kind == Kind::Move) {
    if (!m_is_drag && (event.px - m_pressed->px).norm() > kClickPx &&
        (begin_pull() || start(event))) {
      m_is_drag = true;
      m_typed = m_pull ? m_pull->numbers() : numbers();
    }
    if (m_is_drag && (m_pull ? m_document.is_dragging() : follows()) && m_typed.empty()) {
      forget_snap();
      m_pull ? steer_pull(event) : steer(event);
    }
    return true;
  }
  if (event.kind != Kind::Release || event.button != MouseButton::Left) return true;
  if (m_is_drag) {
    finish_drag();
    return true;
  }
  if (!waits()) click(event);
  m_pressed.reset();
  return true;
}

bool DragTool::start(const PointerEvent&) {
  const auto operation = begin();
  if (operation) m_document.begin_drag(*operation);
  return operation.has_value();
}

void DragTool::finish_drag() {
  forget_snap();
  m_is_drag = false;
  m_pull ? static_cast<void>(m_document.end_drag()) : end();
  m_pull.reset();
  m_pressed.reset();
}

// --- joints -------------------------------------------------------------------------------------

const ObjectSnapshot* DragTool::link_at(const PointerEvent& event) const {
  const auto picked = pick_to_drag(scene(), event.view, event.px, m_document.selection().objects,
                                   m_document.looks().not_selectable());
  const ObjectSnapshot* const found =
      picked && picked->object ? scene().find(*picked->object) : nullptr;
  return found && (*found)->joint && !(*found)->locked ? found : nullptr;
}

bool DragTool::begin_pull() {
  if (!pulls_links(*m_pressed) || m_document.is_busy() || !link_at(*m_pressed)) return false;
  const ObjectSnapshot* const link = grab_object(*m_pressed);
  if (!link) return false;
  m_pull.emplace(*m_pressed, *link->object, m_grabbed_at);
  m_document.begin_drag(m_pull->operation());
  return true;
}

void DragTool::steer_pull(const PointerEvent& event) {
  double step = 0;
  if (m_pull->turns())
    step = angle_step(event);
  else if (snaps(event) && m_options.snap.grid)
    step = m_options.snap.grid_step, note_grid();
  m_document.drag_by(m_pull->value_at(event, step));
}

// --- snapping -----------------------------------------------------------------------------------

void DragTool::grab_for_snapping(const PointerEvent& event) {
  m_base = m_grabbed_at;
  const auto active = m_document.selection().active();
  if (!active) return;
  SnapOptions own = m_options.snap;
  own.faces = false;
  const auto near = snap(scene(), event.view, event.px, own, m_document.looks().hidden(), active);
  if (near) m_base = near->point;
}

void DragTool::forget_snap() {
  m_target.reset();
  m_note.clear();
}

void DragTool::show_snap(const Snap& snap) {
  m_target = snap.point;
  m_note = in_words(snap, scene());
}

std::optional<Vec3> DragTool::snapped_way(const PointerEvent& event) {
  const SceneSnapshot& now = scene();
  std::vector<ObjectId> except = m_document.looks().hidden();
  for (const ObjectId id : m_document.selection().objects)
    for (const ObjectId moving : with_loads(now, id)) except.push_back(moving);
  const auto found = snap(now, event.view, event.px, m_options.snap, except);
  if (!found) return std::nullopt;
  show_snap(*found);
  return Vec3(found->point - m_base);
}

void DragTool::snap_place(const PointerEvent& event, const std::vector<ObjectId>& moving,
                          Picked& place) {
  SnapOptions options = m_options.snap;
  options.faces = false;
  const auto found = snap(scene(), event.view, event.px, options, moving);
  if (found) {
    place.point = found->point;
    return show_snap(*found);
  }
  if (!options.grid) return;
  note_grid();
  for (int k = 0; k < 2; ++k) place.point[k] = on_grid(place.point[k], options.grid_step);
}

double DragTool::on_grid_from(double grabbed, double way) const {
  return on_grid(grabbed + way, m_options.snap.grid_step) - grabbed;
}

double DragTool::angle_step(const PointerEvent& event) {
  if (!snaps(event)) return 0;
  m_note = QCoreApplication::translate("tools", "steps of %1°")
               .arg(QString::fromStdString(plain_number(m_options.angle_step_deg)))
               .toStdString();
  return m_options.angle_step_deg;
}

Overlay DragTool::overlay(const View& view) const {
  Overlay out;
  out.note = m_note;
  if (m_pull) {
    const auto [a, b] = m_pull->line(kAxisArmPx * view.metres_per_px(view.depth(m_grabbed_at)));
    out.lines.push_back({Overlay::Role::Hint, a, b});
  }
  if (!m_target) return out;
  const double size = kSnapMarkPx * view.metres_per_px(view.depth(*m_target));
  const View::Axes axes = view.axes();
  const Vec3 r = size * axes.right, u = size * axes.up;
  const std::array<Vec3, 4> corners{*m_target + r, *m_target + u, *m_target - r, *m_target - u};
  for (size_t i = 0; i < 4; ++i)
    out.lines.push_back({Overlay::Role::Snap, corners[i], corners[(i + 1) % 4]});
  return out;
}

// --- numbers -----------------------------------------------------------------------------------

bool DragTool::wants_key(const KeyEvent& event) const {
  if (!m_is_drag || !m_typed.takes_numbers()) return false;
  if (event.key == KeyEvent::Key::Character) return TypedNumbers::is_part(event.character);
  return event.key == KeyEvent::Key::Tab || event.key == KeyEvent::Key::Backspace ||
         event.key == KeyEvent::Key::Return;
}

bool DragTool::type(const KeyEvent& event) {
  if (!wants_key(event)) return false;
  if (event.key == KeyEvent::Key::Return) {
    finish_drag();
    return true;
  }
  if (event.key == KeyEvent::Key::Tab)
    m_typed.next_axis();
  else if (event.key == KeyEvent::Key::Backspace)
    m_typed.erase();
  else
    m_typed.type(event.character);
  forget_snap();
  if (!m_document.is_dragging()) return true;
  if (m_pull)
    m_document.drag_by(m_typed.values()[0]);
  else
    steer_by(m_typed.values());
  return true;
}

std::string DragTool::reading() const {
  if (!m_is_drag) return {};
  if (const ObjectSnapshot* const link = active(); m_pull && m_typed.empty() && link)
    return dragged_joint_in_words(scene(), *link->object);
  if (m_typed.empty()) return {};
  return m_typed.text() + "  –  " +
         QCoreApplication::translate("tools", "Tab: next axis, Return: done, Escape: cancel")
             .toStdString();
}

bool DragTool::key(const KeyEvent& event) {
  return type(event) || (event.key == KeyEvent::Key::Escape && escape(*this, m_document));
}

void DragTool::cancel() {
  forget_snap();
  if (m_is_drag) m_pull ? m_document.cancel_drag() : give_back();
  m_pull.reset();
  m_is_drag = false;
  m_pressed.reset();
}

Cursor DragTool::cursor() const {
  if (!m_pressed) return Cursor::OpenHand;
  const auto& drag = scene().drag;
  return m_is_drag && drag && drag->blocked ? Cursor::Forbidden : Cursor::ClosedHand;
}

const ObjectSnapshot* DragTool::active() const {
  const auto id = m_document.selection().active();
  return id ? scene().find(*id) : nullptr;
}

const ObjectSnapshot* DragTool::grab_object(const PointerEvent& event) {
  const Selection& selection = m_document.selection();
  const auto picked = pick_to_drag(scene(), event.view, event.px, selection.objects,
                                   m_document.looks().not_selectable());
  if (!picked || !picked->object) return nullptr;
  if (!selection.contains(*picked->object)) {
    m_document.select_only(picked->object);
  } else if (selection.active() != picked->object) {
    Selection turned{selection.objects, {}};
    std::erase(turned.objects, *picked->object);
    turned.objects.push_back(*picked->object);
    m_document.select(std::move(turned));
  }
  m_grabbed_at = picked->point;
  return active();
}

}  // namespace trivet::edit
