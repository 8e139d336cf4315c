#include "apps/edit/window/arrange_dock.h"

namespace trivet::edit {

ArrangeDock::ArrangeDock(Document& document, QWidget* parent)
    : QDockWidget(tr("Arrange"), parent), m_panel(new ArrangePanel(document)) {
  setObjectName("arrange_dock");
  setWidget(m_panel);
  connect(this, &QDockWidget::visibilityChanged, this, [this, &document] {
    if (isHidden()) document.clear_layout();
  });
}

}  // namespace trivet::edit
