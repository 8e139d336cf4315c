#include "apps/edit/window/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

namespace trivet::edit {
namespace {

QPalette palette_of(const Theme& theme) {
  QPalette palette;
  palette.setColor(QPalette::Window, theme.window());
  palette.setColor(QPalette::Base, theme.base());
  palette.setColor(QPalette::AlternateBase,
                   theme.dark ? QColor(37, 39, 43) : QColor(245, 246, 248));
  palette.setColor(QPalette::Button, theme.dark ? QColor(56, 59, 64) : QColor(246, 247, 248));
  palette.setColor(QPalette::ToolTipBase, theme.base());
  palette.setColor(QPalette::Highlight, theme.accent());
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, theme.accent());
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                          QPalette::ToolTipText, QPalette::BrightText})
    palette.setColor(role, theme.text());
  palette.setColor(QPalette::PlaceholderText, theme.faint_text());
  QColor disabled = theme.faint_text();
  disabled.setAlpha(130);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, disabled);
  return palette;
}

}  // namespace

void Theme::apply(QApplication& application) const {
  if (application.style()->objectName() != "fusion")
    QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(palette_of(*this));
  application.setStyleSheet(QString(R"(
    QToolTip { border: 1px solid %1; padding: 4px; }
    QToolButton:checked { color: %2; }
    QMainWindow::separator, QSplitter::handle { background: %1; }
    QToolBar { border: none; border-bottom: 1px solid %1; padding: 2px 4px; spacing: 2px; }
    QToolBar QToolButton { padding: 3px; border: none; border-radius: 4px; }
    QToolBar QToolButton[popupMode="1"] { padding-right: 17px; }
    QToolBar QToolButton::menu-button { border: none; width: 14px; }
    QToolBar QToolButton:hover { background: rgba(128, 128, 128, 60); }
    QToolBar QToolButton:checked { background: %5; color: %4; }
    QStatusBar { border-top: 1px solid %1; }
    QStatusBar::item { border: none; }
    QTreeWidget, QListWidget, QScrollArea, QTableWidget { border: none; }
    QTreeView::item, QListView::item { padding: 2px 0; }
    QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
    QCheckBox::indicator:unchecked { border: 1px solid %3; border-radius: 2px;
      background: transparent; width: 11px; height: 11px; }
    QTabWidget::pane { border: none; border-top: 1px solid %1; }
    QTabBar { qproperty-drawBase: 0; }
    QTabBar::tab { padding: 5px 9px; border: none; color: %3; }
    QTabBar::tab:selected { color: %4; border-bottom: 2px solid %2; }
    #title { color: %3; font-weight: bold; }
    #faint { color: %3; }
  )")
                                .arg(line().name(), accent().name(), faint_text().name(),
                                     text().name(),
                                     QString("rgba(%1, %2, %3, 110)")
                                         .arg(accent().red())
                                         .arg(accent().green())
                                         .arg(accent().blue())));
}

LiveColour live_colour(const QColor& colour, float alpha) {
  return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
          static_cast<float>(colour.blueF()), alpha};
}

}  // namespace trivet::edit
