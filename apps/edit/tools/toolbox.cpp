#include "apps/edit/tools/toolbox.h"

#include "apps/edit/tools/select_tool.h"

namespace trivet::edit {

Toolbox::Toolbox(Document& document)
    : m_document(document), m_tool(std::make_unique<SelectTool>(document)) {}
Toolbox::~Toolbox() = default;

void Toolbox::take(ToolKind kind) {
  m_tool->cancel();
  m_current = kind;
  m_tool = std::make_unique<SelectTool>(m_document);
  if (changed) changed();
}

bool Toolbox::pointer(const PointerEvent& event) {
  m_last = event;
  const bool taken = m_tool->pointer(event);
  if (changed) changed();
  return taken;
}

bool Toolbox::key(const KeyEvent& event) {
  const bool taken = m_tool->key(event);
  if (taken && changed) changed();
  return taken;
}

Cursor Toolbox::cursor() const { return m_tool->cursor(); }

}  // namespace trivet::edit
