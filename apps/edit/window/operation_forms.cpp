// The forms of the operation panel, one per tool.
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <cmath>
#include <limits>

#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/tools/operation_of.h"
#include "apps/edit/window/operation_panel.h"

namespace trivet::edit {

void OperationPanel::add_select(QFormLayout& form) {
  auto* const text = new QLabel(
      tr("Drag an object to move it: it slides, climbs onto what is under the mouse, and settles. "
         "Wheel: turn; L: next way to lie; Shift: lift; Control: snap. Click selects, Shift-click "
         "adds; drag from the ground to select with a box."));
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
  auto* const by_size =
      choice(form, tr("Steps in proportion to the object"), &ToolOptions::steps_by_size,
             tr("Otherwise in millimetres. Steps are measured across the surface"));
  auto* const of_size = share(
      form, tr("Step"), &ToolOptions::step_share,
      tr("Largest step in parts of the object's size; higher steps and deeper edges stop it"));
  auto* const up =
      push_length(form, tr("Step up"), kPushSteps[0], tr("Higher steps stop the object"));
  auto* const down =
      push_length(form, tr("Step down"), kPushSteps[1], tr("Deeper edges stop the object"));
  const auto show = [&form, of_size, up, down](bool on) {
    form.setRowVisible(of_size, on);
    form.setRowVisible(up, !on), form.setRowVisible(down, !on);
  };
  connect(by_size, &QCheckBox::toggled, this, show);
  show(by_size->isChecked());
  choice(form, tr("Slide along walls"), &ToolOptions::slide, tr("Otherwise walls stop the object"));
  choice(form, tr("Settle at the end"), &ToolOptions::settle, tr("Otherwise the object is held"));
  apply(form, tr("Push"), [this, direction, distance](const Object& object) {
    auto push = operation_of<PushOperation>(object, m_document, m_toolbox.options());
    const double radians = direction->value() * 0.0174532925199433;
    push.direction = Vec2(std::cos(radians), std::sin(radians));
    push.distance = distance->value();
    set_push_options(m_toolbox.options(), object, push);
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
  choice(form, tr("Lift, turn and settle"), &ToolOptions::lift,
         tr("For the mouse: otherwise the object turns where it is, and stops at collisions"));
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

void OperationPanel::add_paint(QFormLayout& form) {
  auto* const text = new QLabel(
      tr("Drag over a surface: copies of the selected objects, in turn, along the stroke."));
  text->setWordWrap(true);
  text->setObjectName("faint");
  form.addRow(text);
  choice(form, tr("Pour a pile"), &ToolOptions::paint_pile,
         tr("While the button is down, copies fall onto each other under the mouse"));
  auto* const flow = new QSpinBox;
  flow->setRange(1, 100);
  flow->setSuffix(tr(" a second"));
  flow->setToolTip(tr("Copies of a pile, while the button is down"));
  flow->setValue(m_toolbox.options().paint_flow);
  connect(flow, &QSpinBox::valueChanged, this,
          [this](int value) { m_toolbox.options().paint_flow = value; });
  form.addRow(tr("Flow"), flow);
  auto* const spacing = threshold(form, tr("Spacing"), &ToolOptions::paint_spacing,
                                  tr("Between the middles of the copies; 0: side by side"));
  spacing->setSpecialValueText(tr("side by side"));
  spacing->setObjectName("paint spacing");
  choice(form, tr("Random turns"), &ToolOptions::paint_turned,
         tr("Each copy is turned about the vertical axis"));
  auto* const seed = new QSpinBox;
  seed->setRange(0, std::numeric_limits<int>::max());
  seed->setToolTip(tr("Seed of the turns: the same strokes give the same scene"));
  seed->setValue(static_cast<int>(m_toolbox.options().paint_seed));
  connect(seed, &QSpinBox::valueChanged, this, [this](int value) {
    m_toolbox.options().paint_seed = static_cast<std::uint64_t>(value);
  });
  form.addRow(tr("Seed"), seed);
  threshold(form, tr("Drop height"), &ToolOptions::drop_height,
            tr("Above the surface under the stroke"));
}

void OperationPanel::add_drape(QFormLayout& form) {
  auto* const material = new QComboBox;
  material->setObjectName("drape material");
  const std::pair<const char*, QString> materials[] = {
      {"cotton", tr("Cotton")}, {"felt", tr("Felt")}, {"paper", tr("Paper")},
      {"towel", tr("Towel")},   {"wool", tr("Wool")}, {"lead", tr("Cable")}};
  for (const auto& [name, shown] : materials) material->addItem(shown, QString(name));
  form.addRow(tr("Material"), material);
  auto* const width = threshold(form, tr("Width"), &ToolOptions::drape_width, tr("Along the warp"));
  auto* const length =
      threshold(form, tr("Length"), &ToolOptions::drape_length, tr("Along the weft"));
  auto* const cell = threshold(form, tr("Cells"), &ToolOptions::drape_cell,
                               tr("Largest side: small ones show small folds, and take longer"));
  cell->setSpecialValueText(tr("a 40th of the length"));
  auto* const slack = share(form, tr("Slack"), &ToolOptions::drape_slack,
                            tr("By how much a cable is longer than its way"));
  auto* const drop = threshold(form, tr("Drop height"), &ToolOptions::drop_height,
                               tr("Above the highest point below the sheet"));
  const auto show = [&form, material, width, length, cell, slack, drop, this] {
    m_toolbox.options().drape_material = material->currentData().toString().toStdString();
    const bool is_cable = material->currentData().toString() == "lead";
    for (QWidget* const row : {width, length, cell, drop}) form.setRowVisible(row, !is_cable);
    form.setRowVisible(slack, is_cable);
  };
  connect(material, &QComboBox::currentIndexChanged, this, show);
  show();
}

}  // namespace trivet::edit
