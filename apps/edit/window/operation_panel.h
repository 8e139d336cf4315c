// Forms for the operations: numbers instead of the mouse, and thresholds.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <functional>

#include "apps/edit/document/document.h"
#include "apps/edit/tools/toolbox.h"

namespace trivet::edit {

class OperationPanel : public QWidget {
  Q_OBJECT

 public:
  OperationPanel(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);

  /// Shows the form of that tool.
  void show_tool(ToolKind kind);

 Q_SIGNALS:
  void tool_wanted(trivet::edit::ToolKind kind);

 private:
  QWidget* make_page(ToolKind kind);

  // operation_forms.cpp
  void add_select(QFormLayout& form);
  void add_put(QFormLayout& form);
  void add_push(QFormLayout& form);
  void add_turn(QFormLayout& form);
  void add_pick_up(QFormLayout& form);
  void add_move(QFormLayout& form);
  void add_rotate(QFormLayout& form);
  void add_paint(QFormLayout& form);
  void add_drape(QFormLayout& form);
  QDoubleSpinBox* length(QFormLayout& form, const QString& name, double value,
                         const QString& tip = {});
  QDoubleSpinBox* angle(QFormLayout& form, const QString& name, double value,
                        const QString& tip = {});
  QDoubleSpinBox* millimetres(QFormLayout& form, const QString& name,
                              const std::function<double&()>& value, const QString& tip);
  /// Length of the PUSH that the toolbox keeps. @param key  of its table.
  QDoubleSpinBox* push_length(QFormLayout& form, const QString& name, const char* key,
                              const QString& tip);
  QDoubleSpinBox* threshold(QFormLayout& form, const QString& name, double ToolOptions::*option,
                            const QString& tip);
  QDoubleSpinBox* share(QFormLayout& form, const QString& name, double ToolOptions::*option,
                        const QString& tip);
  QCheckBox* choice(QFormLayout& form, const QString& name, bool ToolOptions::*option,
                    const QString& tip);
  void add_angle_step(QFormLayout& form);
  QPushButton* apply(QFormLayout& form, const QString& name,
                     std::function<Operation(const Object& object)> make);
  void follow_document();
  void refresh_choices();

  Document& m_document;
  Toolbox& m_toolbox;
  QComboBox* m_tools;
  QStackedWidget* m_pages;
  std::vector<QPushButton*> m_buttons;
  std::vector<std::function<void()>> m_refresh;
  QComboBox* m_put_on = nullptr;
  QDoubleSpinBox* m_put_at[3] = {};
};

}  // namespace trivet::edit
