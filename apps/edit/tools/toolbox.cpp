#include "apps/edit/tools/toolbox.h"

#include "apps/edit/tools/gizmo_tool.h"
#include "apps/edit/tools/move_tools.h"
#include "apps/edit/tools/paint_tool.h"
#include "apps/edit/tools/select_tool.h"
#include "apps/edit/tools/turn_tool.h"
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
  }
  return std::make_unique<SelectTool>(document);
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
    default:
      return std::nullopt;
  }
}

}  // namespace

Toolbox::Toolbox(Document& document)
    : m_document(document), m_tool(make_tool(ToolKind::Select, document, m_options)) {}
Toolbox::~Toolbox() = default;

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
    taken = kind || (event.character == 'p' && put_at_pointer()) ||
            (event.character == 'u' && pick_up()) || (event.character == 'v' && next_contact());
  }
  if (taken && changed) changed();
  return taken;
}

Cursor Toolbox::cursor() const { return m_document.is_busy() ? Cursor::Busy : m_tool->cursor(); }

}  // namespace trivet::edit
