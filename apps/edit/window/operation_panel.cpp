#include "apps/edit/window/operation_panel.h"

#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/tools/operation_of.h"

namespace trivet::edit {
namespace {

constexpr double kLongest = 1000, kMillimetre = 1e-3;  // metres

QString tool_name(int kind) {
  static constexpr const char* kNames[] = {"Select",  "Put",  "Push",  "Turn",
                                           "Pick up", "Move", "Rotate"};
  return OperationPanel::tr(kNames[kind]);
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
  for (int kind = 0; kind <= static_cast<int>(ToolKind::Rotate); ++kind) {
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
  static constexpr AddRows kRows[] = {&OperationPanel::add_select,  &OperationPanel::add_put,
                                      &OperationPanel::add_push,    &OperationPanel::add_turn,
                                      &OperationPanel::add_pick_up, &OperationPanel::add_move,
                                      &OperationPanel::add_rotate};
  (this->*kRows[static_cast<size_t>(kind)])(*form);
  if (kind != ToolKind::Select)
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

QDoubleSpinBox* OperationPanel::threshold(QFormLayout& form, const QString& name,
                                          double ToolOptions::*option, const QString& tip) {
  auto* const box = new QDoubleSpinBox;
  box->setRange(0, 1e3 * kLongest);
  box->setDecimals(1);
  box->setSuffix(tr(" mm"));
  box->setToolTip(tip);
  form.addRow(name, box);
  m_refresh.push_back([this, box, option] {
    const QSignalBlocker blocker(box);
    box->setValue(m_toolbox.options().*option / kMillimetre);
  });
  m_refresh.back()();
  connect(box, &QDoubleSpinBox::valueChanged, this,
          [this, option](double value) { m_toolbox.options().*option = value * kMillimetre; });
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
  auto* const box = angle(form, tr("Steps"), 0, tr("For the mouse, while Control is held"));
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

void OperationPanel::add_select(QFormLayout& form) {
  auto* const text = new QLabel(
      tr("Click selects, Shift-click adds; drag from an empty place to select with a box."));
  text->setWordWrap(true);
  text->setObjectName("faint");
  form.addRow(text);
}

void OperationPanel::add_put(QFormLayout& form) {
  m_put_on = new QComboBox;
  m_put_on->setToolTip(
      tr("From a position, the object falls; on another object, the free place nearest to x, y "
         "is searched"));
  form.addRow(tr("Onto"), m_put_on);
  const char* const names[] = {"X", "Y", "Z"};
  for (int i = 0; i < 3; ++i) m_put_at[i] = length(form, tr(names[i]), i == 2 ? 1 : 0);
  auto* const turned = angle(form, tr("Turned"), 0, tr("About the vertical axis"));
  auto* const keep =
      length(form, tr("Keep away"), 0, tr("Distance from everything but its support"));
  threshold(form, tr("Drop height"), &ToolOptions::drop_height,
            tr("For the mouse: above the highest point below the object"));
  choice(form, tr("Then take the next object"), &ToolOptions::take_next,
         tr("After a click that put one: the next object that is not placed yet (or press N)"));
  connect(m_put_on, &QComboBox::currentIndexChanged, this, [this, keep](int index) {
    m_put_at[2]->setEnabled(index <= 0);
    keep->setEnabled(index > 0);
  });
  apply(form, tr("Put"), [this, turned, keep](const Object& object) {
    auto put = operation_of<PutOperation>(object, m_document, m_toolbox.options());
    const Rotation before = object.placed ? object.pose.rotation : Rotation{};
    put.start.rotation = turned_about(Vec3::UnitZ(), turned->value()) * before;
    put.start.translation = Vec3(m_put_at[0]->value(), m_put_at[1]->value(), m_put_at[2]->value());
    if (m_put_on->currentIndex() <= 0) return Operation(put);
    PlaceOptions place;
    place.on = m_put_on->currentIndex() == 1 ? std::string("floor")
                                             : m_put_on->currentText().toStdString();
    place.near = Vec2(put.start.translation.head<2>());
    place.keep = keep->value();
    put.place = place;
    return Operation(put);
  });
}

void OperationPanel::add_push(QFormLayout& form) {
  auto* const direction = angle(form, tr("Direction"), 0, tr("Seen from above, from x towards y"));
  auto* const distance = length(form, tr("Distance"), 0.1);
  threshold(form, tr("Step up"), &ToolOptions::step_up, tr("Higher steps stop the object"));
  threshold(form, tr("Step down"), &ToolOptions::step_down, tr("Deeper edges stop the object"));
  choice(form, tr("Slide along walls"), &ToolOptions::slide, tr("Otherwise walls stop the object"));
  choice(form, tr("Settle at the end"), &ToolOptions::settle, tr("Otherwise the object is held"));
  apply(form, tr("Push"), [this, direction, distance](const Object& object) {
    auto push = operation_of<PushOperation>(object, m_document, m_toolbox.options());
    const double radians = direction->value() * 0.0174532925199433;
    push.direction = Vec2(std::cos(radians), std::sin(radians));
    push.distance = distance->value();
    push.step_up = m_toolbox.options().step_up;
    push.step_down = m_toolbox.options().step_down;
    push.slide = m_toolbox.options().slide;
    push.settle = m_toolbox.options().settle;
    return Operation(push);
  });
}

void OperationPanel::add_turn(QFormLayout& form) {
  auto* const about = new QComboBox;
  about->addItems(
      {tr("the contact's normal"), tr("an edge of the contact"), tr("a contact point")});
  about->setToolTip(tr("Click a contact point, edge or area in a view to choose it"));
  form.addRow(tr("About"), about);
  auto* const by = angle(form, tr("Angle"), 15);
  add_angle_step(form);
  choice(form, tr("Settle at the end"), &ToolOptions::let_go, tr("Otherwise the object is held"));
  apply(form, tr("Turn"), [this, about, by](const Object& object) {
    auto turn = operation_of<TurnOperation>(object, m_document, m_toolbox.options());
    turn.about = static_cast<TurnOperation::About>(about->currentIndex());
    if (const auto& contact = m_document.selection().contact) {
      turn.point = contact->near;
      const ObjectSnapshot* const with =
          contact->with.is_object() ? m_document.snapshot()->find(contact->with.object()) : nullptr;
      turn.with = with ? (*with)->name : std::string("floor");
    }
    turn.angle_deg = by->value();
    turn.settle = m_toolbox.options().let_go;
    return Operation(turn);
  });
}

void OperationPanel::add_pick_up(QFormLayout& form) {
  threshold(form, tr("Distance"), &ToolOptions::pick_up_distance, tr("Along the contact's normal"));
  apply(form, tr("Pick up"), [this](const Object& object) {
    auto pick_up = operation_of<PickUpOperation>(object, m_document, m_toolbox.options());
    pick_up.distance = m_toolbox.options().pick_up_distance;
    return Operation(pick_up);
  });
}

void OperationPanel::add_move(QFormLayout& form) {
  auto* const x = length(form, tr("X"), 0);
  auto* const y = length(form, tr("Y"), 0);
  auto* const z = length(form, tr("Z"), 0.1);
  choice(form, tr("Ignore collisions"), &ToolOptions::free,
         tr("As in a modeller; interpenetrating objects are marked until resolved"));
  choice(form, tr("Settle at the end"), &ToolOptions::let_go, tr("Otherwise the object is held"));
  apply(form, tr("Move"), [this, x, y, z](const Object& object) {
    auto move = operation_of<TranslateOperation>(object, m_document, m_toolbox.options());
    move.by = Vec3(x->value(), y->value(), z->value());
    move.free = m_toolbox.options().free;
    move.settle = m_toolbox.options().let_go && !move.free;
    return Operation(move);
  });
}

void OperationPanel::add_rotate(QFormLayout& form) {
  auto* const axis = new QComboBox;
  axis->addItems({tr("X"), tr("Y"), tr("Z")});
  axis->setCurrentIndex(2);
  form.addRow(tr("Axis"), axis);
  auto* const by = angle(form, tr("Angle"), 15, tr("About the centre of mass"));
  add_angle_step(form);
  choice(form, tr("Ignore collisions"), &ToolOptions::free,
         tr("As in a modeller; interpenetrating objects are marked until resolved"));
  choice(form, tr("Settle at the end"), &ToolOptions::let_go, tr("Otherwise the object is held"));
  apply(form, tr("Rotate"), [this, axis, by](const Object& object) {
    auto rotate = operation_of<RotateOperation>(object, m_document, m_toolbox.options());
    rotate.axis = Vec3::Unit(axis->currentIndex());
    rotate.angle_deg = by->value();
    rotate.free = m_toolbox.options().free;
    rotate.settle = m_toolbox.options().let_go && !rotate.free;
    return Operation(rotate);
  });
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
