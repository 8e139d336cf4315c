#include "apps/edit/tools/toolbox.h"

#include <QCoreApplication>
#include <cmath>
#include <utility>

#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/tools/drape_tool.h"
#include "apps/edit/tools/gizmo_tool.h"
#include "apps/edit/tools/lean.h"
#include "apps/edit/tools/move_tools.h"
#include "apps/edit/tools/paint_tool.h"
#include "apps/edit/tools/placing.h"
#include "apps/edit/tools/select_tool.h"
#include "apps/edit/tools/turn_tool.h"
#include "core/base/quoted.h"
#include "ops/operations/turn_axis.h"

namespace trivet::edit {
namespace {

std::unique_ptr<Tool> make_tool(ToolKind kind, Document& document, const ToolOptions& options) {
  switch (kind) {
    case ToolKind::Select:
      break;
    case ToolKind::Put:
      return std::make_unique<PutTool>(document, options);
    case ToolKind::Push:
      return std::make_unique<PushTool>(document, options);
    case ToolKind::Turn:
      return std::make_unique<TurnTool>(document, options);
    case ToolKind::PickUp:
      return std::make_unique<PickUpTool>(document, options);
    case ToolKind::Move:
      return std::make_unique<GizmoTool>(document, options, false);
    case ToolKind::Rotate:
      return std::make_unique<GizmoTool>(document, options, true);
    case ToolKind::Paint:
      return std::make_unique<PaintTool>(document, options);
    case ToolKind::Drape:
      return std::make_unique<DrapeTool>(document, options);
  }
  return std::make_unique<SelectTool>(document, options);
}

std::optional<ToolKind> kind_of(char key) {
  switch (key) {
    case 'q':
      return ToolKind::Select;
    case 'w':
      return ToolKind::Put;
    case 'e':
      return ToolKind::Push;
    case 'r':
      return ToolKind::Turn;
    case 't':
      return ToolKind::PickUp;
    case 'g':
      return ToolKind::Move;
    case 'h':
      return ToolKind::Rotate;
    case 'b':
      return ToolKind::Paint;
    case 'd':
      return ToolKind::Drape;
    default:
      return std::nullopt;
  }
}

}  // namespace

Toolbox::Toolbox(Document& document)
    : m_document(document), m_tool(make_tool(ToolKind::Select, document, m_options)) {
  m_ways = QObject::connect(&document, &Document::ways_found,
                            [this](const WaysToLie& ways) { lie_as_found(ways); });
}

Toolbox::~Toolbox() { QObject::disconnect(m_ways); }

void Toolbox::take(ToolKind kind) {
  m_tool->cancel();
  m_current = kind;
  m_tool = make_tool(kind, m_document, m_options);
  if (changed) changed();
}

bool Toolbox::pointer(const PointerEvent& event) {
  m_last = event;
  const bool taken = m_tool->pointer(event);
  if (changed) changed();
  return taken;
}

bool Toolbox::put_at_pointer() {
  if (!m_last || m_document.is_busy() || m_document.is_dragging()) return false;
  if (auto* const put = dynamic_cast<PutTool*>(m_tool.get())) return put->put(*m_last);
  return PutTool(m_document, m_options).put(*m_last);
}

bool Toolbox::take_next() {
  if (m_document.is_busy() || m_document.is_dragging()) return false;
  if (m_current != ToolKind::Put) take(ToolKind::Put);
  const bool taken = static_cast<PutTool&>(*m_tool).take_next();
  if (changed) changed();
  return taken;
}

bool Toolbox::pick_up() {
  if (m_document.is_busy() || m_document.is_dragging()) return false;
  return PickUpTool(m_document, m_options).pick_up();
}

// The active object, when it can be put elsewhere now.
const ObjectSnapshot* Toolbox::idle_active() const {
  if (m_document.is_busy() || m_document.is_dragging()) return nullptr;
  const auto active = m_document.selection().active();
  const ObjectSnapshot* const object = active ? m_document.snapshot()->find(*active) : nullptr;
  return object && (*object)->placed ? object : nullptr;
}

void Toolbox::put_turned(const ObjectSnapshot& object, const Rotation& rotation) {
  const SceneSnapshot& scene = *m_document.snapshot();
  Object turned = *object.object;
  turned.pose.rotation = rotation;
  m_document.perform_first(put_choices(
      scene, turned, with_loads(scene, object.id), place_of(*object.object),
      operation_of<PutOperation>(*object.object, m_document, m_options), m_options.drop_height));
}

bool Toolbox::turn(int steps) {
  const ObjectSnapshot* const object = idle_active();
  if (!object) return false;
  const Rotation turn =
      turned_about(Vec3::UnitZ(), std::fmod(steps * m_options.angle_step_deg, 360));
  put_turned(*object, (turn * (*object)->pose.rotation).normalized());
  return true;
}

bool Toolbox::lean() {
  const std::vector<ObjectId>& selected = m_document.selection().objects;
  const ObjectSnapshot* const wall = idle_active();
  if (!wall || selected.size() != 2) return false;
  const SceneSnapshot& scene = *m_document.snapshot();
  const ObjectSnapshot* const object = scene.find(selected.front());
  if (!object || !(*object)->placed) return false;
  const auto turn = lean_against(*object, *wall, scene);
  if (turn) m_document.perform(*turn);
  return turn.has_value();
}

bool Toolbox::lie(Lying how) {
  const ObjectSnapshot* const object = idle_active();
  if (!object) return false;
  m_lying = how;
  m_document.request_ways(object->id);
  return true;
}

void Toolbox::lie_as_found(const WaysToLie& ways) {
  const std::optional<Lying> how = std::exchange(m_lying, std::nullopt);
  const ObjectSnapshot* const object = idle_active();
  if (!how || !object || object->id != ways.object) return;
  if (const auto way = way_of(ways.ways, *how)) return put_turned(*object, way->rotation);
  const QString said = QCoreApplication::translate("tools", "%1 lies so already, or cannot lie so");
  Q_EMIT m_document.message(
      {Message::Kind::Info,
       said.arg(QString::fromStdString(quoted((*object)->name))).toStdString(),
       {},
       {}});
}

bool Toolbox::next_contact() {
  if (m_document.is_busy() || m_document.is_dragging()) return false;
  const SceneSnapshot& scene = *m_document.snapshot();
  Selection selection = m_document.selection();
  const auto active = selection.active();
  const ObjectSnapshot* const object = active ? scene.find(*active) : nullptr;
  if (!object || (*object)->contacts.empty()) return false;
  const std::vector<ObjectContact>& all = (*object)->contacts;
  const ObjectContact* const now = active_object_contact(selection, scene);
  const ObjectContact& next = all[static_cast<size_t>(now - all.data() + 1) % all.size()];
  selection.contact = {next.with, ActiveContact::Part::Area, centre_of(next.contact)};
  m_document.select(std::move(selection));
  return true;
}

bool Toolbox::erase_selected() {
  if (m_document.is_busy() || m_document.is_dragging()) return false;
  std::vector<Operation> operations;
  for (const ObjectId id : m_document.selection().objects) {
    DeleteOperation erase;
    erase.object = (*m_document.snapshot()->find(id))->name;
    erase.settle_left = m_options.settle_left;
    operations.push_back(erase);
  }
  if (operations.empty()) return false;
  m_document.perform_all("delete", std::move(operations));
  return true;
}

bool Toolbox::key(const KeyEvent& event) {
  bool taken = m_tool->key(event);
  const bool plain = !event.modifiers.control && !event.modifiers.alt;
  if (!taken && event.key == KeyEvent::Key::Delete) taken = erase_selected();
  if (!taken && event.key == KeyEvent::Key::Character && plain) {
    const auto kind = kind_of(event.character);
    if (kind) take(*kind);
    taken =
        kind || (event.character == 'p' && put_at_pointer()) ||
        (turns_by(event) && (event.character == 'l' ? lie(Lying::Next) : turn(*turns_by(event)))) ||
        (event.character == 'u' && pick_up()) || (event.character == 'v' && next_contact());
  }
  if (taken && changed) changed();
  return taken;
}

Cursor Toolbox::cursor() const { return m_document.is_busy() ? Cursor::Busy : m_tool->cursor(); }

}  // namespace trivet::edit
