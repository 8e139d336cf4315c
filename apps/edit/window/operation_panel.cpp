#include "apps/edit/window/operation_panel.h"

#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ops/operations/table.h"

namespace trivet::edit {
namespace {

constexpr double kLongest = 1000, kMillimetre = 1e-3;  // metres

QString tool_name(int kind) {
  const QString names[] = {
      OperationPanel::tr("Select"), OperationPanel::tr("Put"),     OperationPanel::tr("Push"),
      OperationPanel::tr("Turn"),   OperationPanel::tr("Pick up"), OperationPanel::tr("Move"),
      OperationPanel::tr("Rotate"), OperationPanel::tr("Paint"),   OperationPanel::tr("Drape")};
  return names[kind];
}

}  // namespace

OperationPanel::OperationPanel(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_toolbox(toolbox),
      m_tools(new QComboBox),
      m_pages(new QStackedWidget) {
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 8);
  column->setSpacing(8);
  for (int kind = 0; kind <= static_cast<int>(ToolKind::Drape); ++kind) {
    m_tools->addItem(tool_name(kind));
    m_pages->addWidget(make_page(static_cast<ToolKind>(kind)));
  }
  column->addWidget(m_tools);
  column->addWidget(m_pages, 1);
  connect(m_tools, &QComboBox::activated, this,
          [this](int index) { Q_EMIT tool_wanted(static_cast<ToolKind>(index)); });
  connect(&m_document, &Document::snapshot_changed, this, &OperationPanel::follow_document);
  connect(&m_document, &Document::selection_changed, this, &OperationPanel::follow_document);
  connect(&m_document, &Document::busy_changed, this, &OperationPanel::follow_document);
  follow_document();
}

void OperationPanel::show_tool(ToolKind kind) {
  m_tools->setCurrentIndex(static_cast<int>(kind));
  m_pages->setCurrentIndex(static_cast<int>(kind));
  for (const auto& refresh : m_refresh) refresh();
}

QWidget* OperationPanel::make_page(ToolKind kind) {
  auto* const page = new QWidget;
  auto* const form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 6, 0);
  form->setVerticalSpacing(5);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  using AddRows = void (OperationPanel::*)(QFormLayout&);
  static constexpr AddRows kRows[] = {
      &OperationPanel::add_select, &OperationPanel::add_put,     &OperationPanel::add_push,
      &OperationPanel::add_turn,   &OperationPanel::add_pick_up, &OperationPanel::add_move,
      &OperationPanel::add_rotate, &OperationPanel::add_paint,   &OperationPanel::add_drape};
  (this->*kRows[static_cast<size_t>(kind)])(*form);
  if (kind != ToolKind::Select && kind != ToolKind::Paint && kind != ToolKind::Drape)
    choice(*form, tr("Settle objects left without support"), &ToolOptions::settle_left,
           tr("Objects that lose their support settle too; otherwise they are marked"));
  auto* const scroll = new QScrollArea;
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return scroll;
}

QDoubleSpinBox* OperationPanel::length(QFormLayout& form, const QString& name, double value,
                                       const QString& tip) {
  auto* const box = new QDoubleSpinBox;
  box->setRange(-kLongest, kLongest);
  box->setDecimals(4);
  box->setSingleStep(0.01);
  box->setSuffix(tr(" m"));
  box->setValue(value);
  box->setToolTip(tip);
  form.addRow(name, box);
  return box;
}

QDoubleSpinBox* OperationPanel::angle(QFormLayout& form, const QString& name, double value,
                                      const QString& tip) {
  auto* const box = new QDoubleSpinBox;
  box->setRange(-360, 360);
  box->setDecimals(2);
  box->setSingleStep(5);
  box->setSuffix(tr("°"));
  box->setValue(value);
  box->setToolTip(tip);
  form.addRow(name, box);
  return box;
}

QDoubleSpinBox* OperationPanel::millimetres(QFormLayout& form, const QString& name,
                                            const std::function<double&()>& value,
                                            const QString& tip) {
  auto* const box = new QDoubleSpinBox;
  box->setRange(0, 1e3 * kLongest);
  box->setDecimals(1);
  box->setSuffix(tr(" mm"));
  box->setToolTip(tip);
  form.addRow(name, box);
  m_refresh.push_back([box, value] {
    const QSignalBlocker blocker(box);
    box->setValue(value() / kMillimetre);
  });
  m_refresh.back()();
  connect(box, &QDoubleSpinBox::valueChanged, this,
          [value](double given) { value() = given * kMillimetre; });
  return box;
}

QDoubleSpinBox* OperationPanel::threshold(QFormLayout& form, const QString& name,
                                          double ToolOptions::*option, const QString& tip) {
  return millimetres(
      form, name, [this, option]() -> double& { return m_toolbox.options().*option; }, tip);
}

QDoubleSpinBox* OperationPanel::push_length(QFormLayout& form, const QString& name, const char* key,
                                            const QString& tip) {
  const Field* const field = table<PushOperation>().find(key);
  return millimetres(
      form, name,
      [this, field]() -> double& {
        return *std::get<double*>(field->slot(&m_toolbox.options().push));
      },
      tip);
}

QDoubleSpinBox* OperationPanel::share(QFormLayout& form, const QString& name,
                                      double ToolOptions::*option, const QString& tip) {
  auto* const box = new QDoubleSpinBox;
  box->setRange(0, 100);
  box->setDecimals(1);
  box->setSuffix(tr(" %"));
  box->setToolTip(tip);
  form.addRow(name, box);
  m_refresh.push_back([this, box, option] {
    const QSignalBlocker blocker(box);
    box->setValue(100 * m_toolbox.options().*option);
  });
  m_refresh.back()();
  connect(box, &QDoubleSpinBox::valueChanged, this,
          [this, option](double value) { m_toolbox.options().*option = 0.01 * value; });
  return box;
}

QCheckBox* OperationPanel::choice(QFormLayout& form, const QString& name, bool ToolOptions::*option,
                                  const QString& tip) {
  auto* const box = new QCheckBox(name);
  box->setToolTip(tip);
  form.addRow(box);
  m_refresh.push_back([this, box, option] {
    const QSignalBlocker blocker(box);
    box->setChecked(m_toolbox.options().*option);
  });
  m_refresh.back()();
  connect(box, &QCheckBox::toggled, this, [this, option](bool on) {
    m_toolbox.options().*option = on;
    for (const auto& refresh : m_refresh) refresh();
  });
  return box;
}

void OperationPanel::add_angle_step(QFormLayout& form) {
  auto* const box =
      angle(form, tr("Steps"), 0, tr("For the mouse, while Control is held or the magnet is on"));
  box->setMinimum(0.01);
  m_refresh.push_back([this, box] {
    const QSignalBlocker blocker(box);
    box->setValue(m_toolbox.options().angle_step_deg);
  });
  m_refresh.back()();
  connect(box, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    m_toolbox.options().angle_step_deg = value;
    for (const auto& refresh : m_refresh) refresh();
  });
}

QPushButton* OperationPanel::apply(QFormLayout& form, const QString& name,
                                   std::function<Operation(const Object&)> make) {
  auto* const button = new QPushButton(name);
  button->setToolTip(
      tr("Apply to the active object with these numbers; other selected objects move along"));
  form.addRow(button);
  m_buttons.push_back(button);
  connect(button, &QPushButton::clicked, this, [this, make = std::move(make)] {
    const auto active = m_document.selection().active();
    const ObjectSnapshot* const object = active ? m_document.snapshot()->find(*active) : nullptr;
    if (object) m_document.perform(make(*object->object));
  });
  return button;
}

void OperationPanel::follow_document() {
  const auto snapshot = m_document.snapshot();
  if (snapshot->drag) return;
  const auto active = m_document.selection().active();
  for (QPushButton* const button : m_buttons)
    button->setEnabled(active.has_value() && !m_document.is_busy());
  refresh_choices();
  const ObjectSnapshot* const object = active ? snapshot->find(*active) : nullptr;
  if (!object || !(*object)->placed) return;
  const Vec3& at = (*object)->pose.translation;
  for (int i = 0; i < 3; ++i)
    if (!m_put_at[i]->hasFocus()) m_put_at[i]->setValue(i == 2 ? at.z() + 0.3 : at[i]);
}

void OperationPanel::refresh_choices() {
  const QSignalBlocker blocker(m_put_on);
  const QString chosen = m_put_on->currentText();
  m_put_on->clear();
  m_put_on->addItem(tr("the surface below"));
  m_put_on->addItem(tr("a free place on the floor"));
  for (const ObjectSnapshot& object : m_document.snapshot()->objects)
    if (object->placed && object.id != m_document.selection().active())
      m_put_on->addItem(QString::fromStdString(object->name));
  m_put_on->setCurrentIndex(std::max(m_put_on->findText(chosen), 0));
}

}  // namespace trivet::edit
