#include <QCoreApplication>
#include <algorithm>

#include "apps/edit/tools/move_tools.h"
#include "apps/edit/tools/placing.h"
#include "core/base/quoted.h"

namespace trivet::edit {
namespace {

bool can_be_moved(const Object& object) {
  return !object.locked && !(object.fixed && object.placed);
}

}  // namespace

PutTool::PutTool(Document& document, const ToolOptions& options)
    : DragTool(document, options), m_turn(document, [this] {
        if (m_hovered) hover(*m_hovered);
      }) {
  m_turn.take(document.selection().active());
  m_selected = QObject::connect(&document, &Document::selection_changed, [this] {
    if (m_document.selection().active() != m_dropped) m_dropped.reset();
    m_turn.take(m_document.selection().active());
  });
  m_finished = QObject::connect(&document, &Document::finished, [this](quint64 job, bool ok) {
    if (job != m_job || !ok) return;
    drop();
    if (m_options.take_next) take_next();
  });
}

PutTool::~PutTool() {
  QObject::disconnect(m_selected);
  QObject::disconnect(m_finished);
}

const ObjectSnapshot* PutTool::held() const {
  const ObjectSnapshot* const object = active();
  return object && m_dropped != object->id && can_be_moved(*object->object) ? object : nullptr;
}

void PutTool::drop() {
  m_dropped = m_document.selection().active();
  m_turn.take(m_dropped);
  m_document.clear_ghost();
}

bool PutTool::take_next() {
  const auto& objects = scene().objects;
  const auto active = m_document.selection().active();
  const auto here = std::find_if(objects.begin(), objects.end(),
                                 [&](const ObjectSnapshot& o) { return o.id == active; });
  const size_t after = here == objects.end() ? 0 : here - objects.begin() + 1;
  for (size_t i = 0; i < objects.size(); ++i) {
    const ObjectSnapshot& next = objects[(after + i) % objects.size()];
    if (next->placed) continue;
    m_document.select_only(next.id);
    m_dropped.reset();
    return true;
  }
  return false;
}

bool PutTool::grab(const PointerEvent& event) {
  m_takes = !held();
  if (!m_takes) return true;
  if (!grab_object(event)) return false;
  m_dropped.reset();
  return true;
}

void PutTool::click(const PointerEvent& event) {
  if (m_takes) return;
  put(event);
}

std::optional<Operation> PutTool::operation_at(const PointerEvent& event) {
  forget_snap();
  const ObjectSnapshot* const object = active();
  if (!object) return std::nullopt;
  Object turned = *object->object;
  turned.pose.rotation = m_turn.of(turned.pose.rotation);
  std::vector<ObjectId> moving = with_loads(scene(), object->id);
  const std::vector<ObjectId> hidden = m_document.looks().hidden();
  moving.insert(moving.end(), hidden.begin(), hidden.end());
  auto picked = pick(scene(), event.view.seen_ray(event.px), moving);
  if (!picked) return std::nullopt;
  const double step = event.view.metres_per_px(event.view.depth(picked->point)) / kGoalsPerPx;
  for (int k = 0; k < 2; ++k) picked->point[k] = rounded(picked->point[k], step);
  if (snaps(event)) snap_place(event, moving, *picked);
  auto put = operation_of<PutOperation>(*object->object);
  put.start =
      put_start(scene(), turned, moving, *picked, m_options.drop_height, event.modifiers.alt);
  return put;
}

bool PutTool::put(const PointerEvent& event) {
  const auto operation = operation_at(event);
  if (!operation) return false;
  m_document.clear_ghost();
  m_job = m_document.perform(*operation);
  forget_snap();
  return true;
}

void PutTool::hover(const PointerEvent& event) {
  m_hovered = event;
  if (m_document.is_busy()) return;
  const auto operation = held() ? operation_at(event) : std::nullopt;
  if (operation)
    m_document.request_ghost(*operation);
  else
    m_document.clear_ghost();
}

bool PutTool::wheel(const PointerEvent& event) {
  if (!held() || event.modifiers.control) return false;
  m_turn.turn(event.wheel_steps * m_options.angle_step_deg);
  return true;
}

bool PutTool::wants_key(const KeyEvent& event) const {
  return DragTool::wants_key(event) || (held() && turns_by(event).has_value());
}

bool PutTool::key(const KeyEvent& event) {
  if (const auto steps = turns_by(event); steps && held()) {
    m_turn.by_key(*steps, m_options.angle_step_deg);
    return true;
  }
  const bool plain = !event.modifiers.control && !event.modifiers.alt;
  if (event.key == KeyEvent::Key::Character && event.character == 'n' && plain) return take_next();
  if (event.key != KeyEvent::Key::Escape || is_active() || !held()) return DragTool::key(event);
  drop();
  return true;
}

void PutTool::cancel() {
  DragTool::cancel();
  m_document.clear_ghost();
}

std::string PutTool::in_hand() const {
  const ObjectSnapshot* const object = held();
  return object ? (*object)->name : std::string();
}

std::string PutTool::hint() const {
  if (held())
    return QT_TRANSLATE_NOOP(
        "tools",
        "Click where you want it; wheel: turn; L: next way to lie; Alt: from just above that "
        "point; Escape puts it back");
  const ObjectSnapshot* const object = active();
  if (object && m_dropped != object->id && !can_be_moved(*object->object)) {
    const QString why =
        (*object)->locked
            ? QCoreApplication::translate("tools", "%1 is locked: unlock it to put it elsewhere")
            : QCoreApplication::translate("tools", "%1 is fixed: unfix it to put it elsewhere");
    return why.arg(QString::fromStdString(quoted((*object)->name))).toStdString();
  }
  return QT_TRANSLATE_NOOP(
      "tools",
      "Nothing in hand: click an object to take it; N takes the next one that is not placed yet");
}

}  // namespace trivet::edit
