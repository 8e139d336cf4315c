#include "apps/edit/tools/select_tool.h"

#include <QtGlobal>
#include <algorithm>

namespace trivet::edit {
namespace {

void toggle(Selection& selection, ObjectId id) {
  const auto found = std::find(selection.objects.begin(), selection.objects.end(), id);
  if (found != selection.objects.end())
    selection.objects.erase(found);
  else
    selection.objects.push_back(id);
  selection.contact.reset();
}

bool adds(const PointerEvent& event) { return event.modifiers.shift || event.modifiers.control; }

}  // namespace

bool SelectTool::grab(const PointerEvent& event) {
  m_now = event.px;
  return true;
}

bool SelectTool::takes_at(const PointerEvent& event) const {
  const auto picked = pick_to_drag(scene(), event.view, event.px, m_document.selection().objects,
                                   m_document.looks().not_selectable());
  const ObjectSnapshot* const object =
      picked && picked->object ? scene().find(*picked->object) : nullptr;
  return object && !(*object)->fixed && !(*object)->locked;
}

// With Shift and Control a box may begin on any object.
bool SelectTool::may_take(const PointerEvent& event) const {
  return pulls_links(event) && !m_document.is_busy() && takes_at(event);
}

bool SelectTool::pulls_links(const PointerEvent& event) const {
  return !(event.modifiers.shift && event.modifiers.control);
}

bool SelectTool::start(const PointerEvent&) {
  if (may_take(*m_pressed) && grab_object(*m_pressed)) {
    grab_for_snapping(*m_pressed);
    m_gesture.begin(m_pressed->view, m_pressed->px);
  }
  return true;
}

void SelectTool::steer(const PointerEvent& event) {
  m_now = event.px;
  if (!m_gesture.is_on()) return;
  auto at = m_gesture.under_foot(event);
  if (at && snaps(event)) {
    PointerEvent foot = event;
    foot.px = m_gesture.foot_px(event.px);
    snap_place(foot, m_gesture.moving(), *at);
  }
  m_gesture.follow(event, at);
}

void SelectTool::end() {
  if (m_gesture.is_on())
    m_gesture.release();
  else
    select_box();
}

void SelectTool::give_back() { m_gesture.cancel(); }

bool SelectTool::wheel(const PointerEvent& event) {
  if (!m_gesture.is_on() || event.modifiers.control) return false;
  m_gesture.turning().turn(event.wheel_steps * m_options.angle_step_deg);
  return true;
}

void SelectTool::hover(const PointerEvent& event) { m_hot = takes_at(event) || link_at(event); }

void SelectTool::click(const PointerEvent& event) {
  const auto picked =
      pick_near(scene(), m_pressed->view, m_pressed->px, m_document.looks().not_selectable());
  if (!picked || !picked->object) {
    if (!adds(event)) m_document.select({});
    return;
  }
  if (!adds(event)) return m_document.select_only(*picked->object);
  Selection selection = m_document.selection();
  toggle(selection, *picked->object);
  m_document.select(std::move(selection));
}

// Fixed things, mostly the ground of the others, only where there is nothing else.
void SelectTool::select_box() {
  Selection selection;
  if (adds(*m_pressed)) selection = m_document.selection();
  std::vector<ObjectId> found = pick_in_box(scene(), m_pressed->view, m_pressed->px, m_now,
                                            m_document.looks().not_selectable());
  const auto is_fixed = [&](ObjectId id) { return (*scene().find(id))->fixed; };
  if (!std::all_of(found.begin(), found.end(), is_fixed)) std::erase_if(found, is_fixed);
  for (const ObjectId id : found)
    if (!selection.contains(id)) selection.objects.push_back(id);
  selection.contact.reset();
  m_document.select(std::move(selection));
}

bool SelectTool::wants_key(const KeyEvent& event) const {
  return m_gesture.is_on() && turns_by(event).has_value();
}

bool SelectTool::key(const KeyEvent& event) {
  if (!wants_key(event)) return DragTool::key(event);
  m_gesture.turning().by_key(*turns_by(event), m_options.angle_step_deg);
  return true;
}

Cursor SelectTool::cursor() const {
  if (m_gesture.is_on() || is_pulling()) return DragTool::cursor();
  return m_hot && !is_active() ? Cursor::OpenHand : Cursor::Arrow;
}

Overlay SelectTool::overlay(const View& view) const {
  Overlay overlay = DragTool::overlay(view);
  if (!m_is_drag || m_gesture.is_on() || is_pulling()) return overlay;
  overlay.box_px = {m_pressed->px, m_now};
  overlay.box_window = m_pressed->window;
  return overlay;
}

std::string SelectTool::hint() const {
  if (m_gesture.is_on())
    return QT_TRANSLATE_NOOP("tools",
                             "Wheel: turn; L: next way to lie; Shift: lift; Control: snap; "
                             "Escape: put it back");
  return QT_TRANSLATE_NOOP(
      "tools",
      "Drag an object to move it, a drawer or door to open it; click to select, "
      "Shift-click to add; drag from the ground for a selection box");
}

}  // namespace trivet::edit
