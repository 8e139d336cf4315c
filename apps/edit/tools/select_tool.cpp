#include "apps/edit/tools/select_tool.h"

#include <QtGlobal>
#include <algorithm>

#include "apps/edit/tools/picking.h"

namespace trivet::edit {
namespace {

constexpr double kBoxPx = 4;  // a press with less motion draws no box

void toggle(Selection& selection, ObjectId id) {
  const auto found = std::find(selection.objects.begin(), selection.objects.end(), id);
  if (found != selection.objects.end())
    selection.objects.erase(found);
  else
    selection.objects.push_back(id);
  selection.contact.reset();
}

}  // namespace

bool SelectTool::pointer(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (event.kind == Kind::Press && event.button == MouseButton::Left) {
    m_pressed = event;
    m_now = event.px;
    m_is_box = false;
    return true;
  }
  if (!m_pressed) return false;
  if (event.kind == Kind::Move) {
    m_now = event.px;
    if ((m_now - m_pressed->px).norm() > kBoxPx) m_is_box = true;
    return true;
  }
  if (event.kind != Kind::Release || event.button != MouseButton::Left) return false;
  m_now = event.px;
  if (m_is_box)
    select_box(event);
  else
    click(event);
  m_pressed.reset();
  return true;
}

void SelectTool::click(const PointerEvent& event) {
  const auto picked = pick_near(*m_document.snapshot(), m_pressed->view, m_pressed->px,
                                m_document.looks().not_selectable());
  const bool more = event.modifiers.shift || event.modifiers.control;
  if (!picked || !picked->object) {
    if (!more) m_document.select({});
    return;
  }
  if (!more) return m_document.select_only(*picked->object);
  Selection selection = m_document.selection();
  toggle(selection, *picked->object);
  m_document.select(std::move(selection));
}

void SelectTool::select_box(const PointerEvent& event) {
  Selection selection;
  if (event.modifiers.shift || event.modifiers.control) selection = m_document.selection();
  for (const ObjectId id : pick_in_box(*m_document.snapshot(), m_pressed->view, m_pressed->px,
                                       event.px, m_document.looks().not_selectable()))
    if (!selection.contains(id)) selection.objects.push_back(id);
  selection.contact.reset();
  m_document.select(std::move(selection));
}

bool SelectTool::key(const KeyEvent& event) {
  if (event.key != KeyEvent::Key::Escape) return false;
  if (m_pressed)
    cancel();
  else
    m_document.select({});
  return true;
}

void SelectTool::cancel() { m_pressed.reset(); }

Overlay SelectTool::overlay(const View&) const {
  Overlay overlay;
  if (!m_pressed || !m_is_box) return overlay;
  overlay.box_px = {m_pressed->px, m_now};
  overlay.box_window = m_pressed->window;
  return overlay;
}

std::string SelectTool::hint() const {
  return QT_TRANSLATE_NOOP(
      "tools", "Click an object to select it, Shift-click to add it; drag for a selection box");
}

}  // namespace trivet::edit
