#include "apps/edit_reach/reach.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollBar>

#include "apps/edit/window/scene_view.h"

namespace trivet::edit::test {
namespace {

constexpr QSize kLeastView(160, 90);  // pixels
constexpr int kLeastHigh = 56;        // of what scrolls: two lines
constexpr int kArrowWide = 16;        // of a list

// Parts of fields count with their field.
bool is_part(const QWidget& widget) {
  const QWidget* const parent = widget.parentWidget();
  return qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent) ||
         qobject_cast<const QLineEdit*>(parent);
}

bool is_control(const QWidget& widget) {
  if (qobject_cast<const QScrollBar*>(&widget) || qobject_cast<const QHeaderView*>(&widget) ||
      is_part(widget))
    return false;
  return qobject_cast<const QAbstractButton*>(&widget) ||
         qobject_cast<const QAbstractItemView*>(&widget) ||
         qobject_cast<const QAbstractSlider*>(&widget) ||
         qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
         qobject_cast<const SceneView*>(&widget);
}

QString told(const QWidget& widget, const char* trouble) {
  QString name = widget.objectName();
  if (const auto* const button = qobject_cast<const QAbstractButton*>(&widget))
    name += " '" + button->text() + "'";
  if (const QWidget* const parent = widget.parentWidget())
    name += QString(" in %1 %2").arg(parent->metaObject()->className(), parent->objectName());
  const QRect at(widget.mapTo(widget.window(), QPoint()), widget.size());
  return QString("%1 %2: %3; %4x%5 at %6, %7")
      .arg(widget.metaObject()->className(), name, trouble)
      .arg(at.width())
      .arg(at.height())
      .arg(at.x())
      .arg(at.y());
}

/// The nearest area around a widget in which it scrolls.
const QAbstractScrollArea* scrolls_in(const QWidget& widget) {
  for (const QWidget* up = widget.parentWidget(); up && !up->isWindow(); up = up->parentWidget())
    if (const auto* const area = qobject_cast<const QAbstractScrollArea*>(up->parentWidget()))
      if (area->viewport() == up) return area;
  return nullptr;
}

// Inside all that it lies in.
bool is_shown_whole(const QWidget& widget) {
  for (const QWidget* up = widget.parentWidget(); up; up = up->parentWidget()) {
    if (!up->rect().contains(QRect(widget.mapTo(up, QPoint()), widget.size()))) return false;
    if (up->isWindow()) return true;
  }
  return true;
}

// A click on its middle is for it.
bool is_on_top(const QWidget& widget) {
  const QWidget* hit =
      widget.window()->childAt(widget.mapTo(widget.window(), widget.rect().center()));
  while (hit && hit != &widget) hit = hit->parentWidget();
  return hit;
}

// Left and right, as up and down it scrolls.
bool is_within(const QWidget& widget, const QWidget& viewport) {
  const int left = widget.mapTo(&viewport, QPoint()).x();
  return left >= 0 && left + widget.width() <= viewport.width();
}

// A text that cannot be read as a whole.
bool is_squeezed(const QWidget& widget) {
  const auto width_of = [&](const QString& text) {
    return widget.fontMetrics().horizontalAdvance(text);
  };
  if (const auto* const box = qobject_cast<const QAbstractSpinBox*>(&widget)) {
    const auto* const field = box->findChild<QLineEdit*>();
    return field && field->width() < width_of(box->text());
  }
  if (const auto* const list = qobject_cast<const QComboBox*>(&widget))
    return list->width() < width_of(list->currentText()) + kArrowWide;
  const bool has_text = qobject_cast<const QPushButton*>(&widget) ||
                        qobject_cast<const QCheckBox*>(&widget) ||
                        qobject_cast<const QRadioButton*>(&widget);
  return has_text && widget.width() < widget.minimumSizeHint().width();
}

const char* trouble_with(const QWidget& widget) {
  if (qobject_cast<const SceneView*>(&widget))
    return widget.width() < kLeastView.width() || widget.height() < kLeastView.height()
               ? "a view too small for work"
               : nullptr;
  if (widget.objectName() == "qt_toolbar_ext_button") return "the bar does not show all its tools";
  if (is_squeezed(widget)) return "squeezed";
  if (const QAbstractScrollArea* const area = scrolls_in(widget))
    return is_within(widget, *area->viewport()) ? nullptr : "cut off at a side";
  if (!is_shown_whole(widget)) return "cut off";
  if (!is_on_top(widget)) return "covered";
  const bool scrolls = qobject_cast<const QAbstractScrollArea*>(&widget);
  return scrolls && widget.height() < kLeastHigh ? "too low for two lines" : nullptr;
}

}  // namespace

QStringList out_of_reach(const QWidget& window) {
  QStringList out;
  for (const QWidget* const widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->window() != &window || !is_control(*widget)) continue;
    if (const char* const trouble = trouble_with(*widget)) out << told(*widget, trouble);
  }
  return out;
}

QStringList out_of_screen(const QWidget& dialog) {
  QStringList out;
  if (!qobject_cast<const QFileDialog*>(&dialog)) out = out_of_reach(dialog);  // else Qt's own
  if (!dialog.screen()->geometry().contains(dialog.frameGeometry()))
    out << told(dialog, "not on the screen as a whole");
  return out;
}

}  // namespace trivet::edit::test
