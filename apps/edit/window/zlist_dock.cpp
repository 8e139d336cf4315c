#include "apps/edit/window/zlist_dock.h"

namespace trivet::edit {

ZListDock::ZListDock(Document& document, QWidget* parent)
    : QDockWidget(tr("z-lists of the motion"), parent), m_panel(new ZListPanel(document)) {
  setObjectName("zlist_dock");
  setWidget(m_panel);
  connect(this, &QDockWidget::visibilityChanged, this, [this, &document] {
    const bool on = !isHidden();
    if (on != document.watches_zlists()) document.watch_zlists(on);
  });
}

}  // namespace trivet::edit
