// The dock of arrangements.
#include <QAction>
#include <QDockWidget>

#include "apps/edit/window/arrange_panel.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {

void MainWindow::make_arrange_dock() {
  m_arrange_panel = new ArrangePanel(m_document);
  m_arrange_dock = new QDockWidget(tr("Arrange"), this);
  m_arrange_dock->setObjectName("arrange_dock");
  m_arrange_dock->setWidget(m_arrange_panel);
  addDockWidget(Qt::BottomDockWidgetArea, m_arrange_dock);
  m_arrange_dock->hide();
  connect(m_arrange_dock, &QDockWidget::visibilityChanged, this, [this] {
    const bool on = !m_arrange_dock->isHidden();
    action("arrange")->setChecked(on);
    if (!on) m_document.clear_layout();
    place_message_bar();
  });
}

void MainWindow::make_arrange_action() {
  QAction* const shown = add_action(
      "arrange", tr("&Arrange…"), tr("Ctrl+R"),
      [this] { m_arrange_dock->setVisible(action("arrange")->isChecked()); },
      tr("Arrange: constraints between objects, and scenes that meet them"));
  shown->setCheckable(true);
}

}  // namespace trivet::edit
