#include "apps/edit/tools/tool.h"

namespace trivet::edit {

bool escape(Tool& tool, Document& document) {
  if (tool.is_active()) {
    tool.cancel();
    return true;
  }
  if (document.selection() == Selection()) return false;
  document.select({});
  return true;
}

}  // namespace trivet::edit
