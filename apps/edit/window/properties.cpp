#include "apps/edit/window/properties.h"

#include <QFont>
#include <QLocale>
#include <QSignalBlocker>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "apps/edit/window/outliner.h"
#include "apps/edit/window/units.h"
#include "core/base/limits.h"
#include "ops/stability/weight.h"

namespace trivet::edit {
namespace {

constexpr double kDropHeight = 0.01;  // metres, from which a scaled object is put anew

QString number(double x, int decimals) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  QString text = locale.toString(x, 'f', decimals);
  return text == "-" + locale.toString(0.0, 'f', decimals) ? text.mid(1) : text;
}

QString contacts_text(const Object& object, const SceneSnapshot& scene) {
  QStringList lines;
  for (const ObjectContact& entry : object.contacts) {
    const ObjectSnapshot* const with =
        entry.with.is_object() ? scene.find(entry.with.object()) : nullptr;
    const QString name = with ? QString::fromStdString((*with)->name) : Properties::tr("floor");
    lines << Properties::tr("%1: %2 (%3)")
                 .arg(name, QString::fromUtf8(to_string(entry.contact.type)))
                 .arg(entry.contact.points.size());
  }
  return lines.isEmpty() ? Properties::tr("none") : lines.join("\n");
}

QString mass_text(const Object& object) {
  const MassProperties& mass = object.shape->mass;
  const double square = object.scale * object.scale;
  if (mass.rule == MassRule::Surface)
    return Properties::tr("surface, %1 m²").arg(number(square * mass.area, 4));
  const QString litres = number(1000 * square * object.scale * std::abs(mass.volume), 3);
  return mass.rule == MassRule::Hull ? Properties::tr("convex hull, %1 litres").arg(litres)
                                     : Properties::tr("volume, %1 litres").arg(litres);
}

QDoubleSpinBox* number_box(double lower, double upper, int decimals, double step,
                           const QString& suffix) {
  auto* const box = new QDoubleSpinBox;
  box->setRange(lower, upper);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
  return box;
}

/// Along the vertical; of an object that is not placed, as it stands in its file.
double height_of(const Object& object) {
  if (object.placed) return 2 * world_box(object).half_extent().z();
  const Vec3 half = object.shape->box.half_extent();
  return 2 * object.scale * (object.up == UpAxis::Y ? half.y() : half.z());
}

QString weight_text(const Object& object) {
  const double kilograms = weight_of(object) / kGravity;
  return kilograms < 1 ? number(1000 * kilograms, 1) + " g" : number(kilograms, 3) + " kg";
}

}  // namespace

QString length_text(double metres) {
  const double size = std::abs(metres);
  if (!std::isfinite(metres)) return QStringLiteral("–");
  if (size >= 1) return number(metres, 3) + " m";
  if (size >= 0.1) return number(100 * metres, 2) + " cm";
  return number(1000 * metres, 2) + " mm";
}

Properties::Properties(Document& document, QWidget* parent)
    : QScrollArea(parent),
      m_document(document),
      m_name(new QLabel),
      m_empty(new QLabel(tr("Select an object to see its pose, its contacts, and how firmly "
                            "it rests."))),
      m_form(new QFormLayout),
      m_content(new QWidget),
      m_joint(new QWidget),
      m_joint_slider(new QSlider(Qt::Horizontal)),
      m_joint_value(new QDoubleSpinBox),
      m_preset(new QComboBox),
      m_position(new VectorField("position", 1e6, 4, 0.01)),
      m_rotation(new VectorField("rotation", 360, 2, 5)),
      m_scale(number_box(1e-6, 1e6, 6, 0.1, {})),
      m_height(number_box(1e-6, 1e6, 4, 0.01, tr(" m"))),
      m_unit(new QComboBox),
      m_up(new QComboBox),
      m_friction(number_box(kMinFriction, kMaxFriction, 3, 0.05, {})),
      m_density(number_box(kMinDensity, kMaxDensity, 0, 50, tr(" kg/m³"))),
      m_restitution(number_box(0, kMaxRestitution, 2, 0.05, {})) {
  lay_out();
  follow_document();
  show_object();
}

void Properties::lay_out() {
  auto* const inside = new QWidget;
  auto* const column = new QVBoxLayout(inside);
  column->setContentsMargins(10, 8, 10, 8);
  column->setSpacing(6);
  m_empty->setWordWrap(true);
  m_empty->setObjectName("faint");
  QFont bold = m_name->font();
  bold.setBold(true);
  m_name->setFont(bold);
  m_form->setContentsMargins(0, 0, 0, 0);
  m_form->setHorizontalSpacing(14);
  m_form->setVerticalSpacing(4);
  m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_content->setLayout(m_form);
  add_pose();
  add_joint();
  add_scale();
  add_frame();
  add_material();
  column->addWidget(m_empty);
  column->addWidget(m_name);
  column->addWidget(m_content);
  column->addStretch(1);
  setWidget(inside);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void Properties::follow_document() {
  connect(&m_document, &Document::snapshot_changed, this, &Properties::show_object);
  connect(&m_document, &Document::verdict_changed, this, &Properties::show_object);
  connect(&m_document, &Document::selection_changed, this, &Properties::show_object);
  connect(&m_document, &Document::finished, this, [this](quint64, bool ok) {
    if (!ok) show_object();  // numbers that were refused
  });
}

void Properties::add_pose() {
  const auto add = [&](const QString& name, VectorField* field, PosePart part, const QString& tip) {
    auto* const title = new QLabel(name);
    title->setObjectName("faint");
    title->setToolTip(tip);
    m_form->addRow(title, field);
    connect(field, &VectorField::edited, this,
            [this, part](int axis, double value) { stand(part, axis, value); });
  };
  add(tr("Position"), m_position, PosePart::Position,
      tr("x, y, z in metres; a number typed here puts the object exactly there, without settling"));
  add(tr("Rotation"), m_rotation, PosePart::Rotation,
      tr("Degrees about x, then y, then z; a number typed here turns the object exactly so"));
}

void Properties::add_scale() {
  auto* const title = new QLabel(tr("Scale"));
  title->setObjectName("faint");
  m_scale->setObjectName("scale");
  for (QWidget* const widget : std::initializer_list<QWidget*>{title, m_scale})
    widget->setToolTip(
        tr("Metres per unit of the model; with another number it is put anew in its place"));
  m_form->addRow(title, m_scale);
  auto* const tall = new QLabel(tr("Height"));
  tall->setObjectName("faint");
  m_height->setObjectName("height");
  for (QWidget* const widget : std::initializer_list<QWidget*>{tall, m_height})
    widget->setToolTip(
        tr("Height of the object as it lies; another number scales it, and it settles with its "
           "loads"));
  m_form->addRow(tall, m_height);
  connect(m_height, &QDoubleSpinBox::valueChanged, this, &Properties::take_height);
  connect(m_scale, &QDoubleSpinBox::valueChanged, this, &Properties::take_scale);
}

// Unit and up axis of the file's numbers, if it was imported wrongly.
void Properties::add_frame() {
  const auto add = [&](const QString& name, QComboBox* box, const char* id, const QString& tip) {
    auto* const title = new QLabel(name);
    title->setObjectName("faint");
    box->setObjectName(id);
    title->setToolTip(tip), box->setToolTip(tip);
    m_form->addRow(title, box);
  };
  add(tr("Unit"), m_unit, "unit",
      tr("Property of the model's file; with another one the object is put anew"));
  add(tr("Up axis"), m_up, "up",
      tr("Property of the model's file; with another one the object is put anew"));
  for (const LengthUnit& unit : length_units()) m_unit->addItem(unit.name, unit.metres);
  m_unit->addItem(tr("other"), 0.0);
  m_up->addItems({tr("Y"), tr("Z")});
  connect(m_unit, &QComboBox::activated, this, [this] {
    if (const double metres = m_unit->currentData().toDouble(); metres > 0) take_scale(metres);
    if (const Object* const object = active_object()) show_frame(*object);
  });
  connect(m_up, &QComboBox::activated, this,
          [this](int index) { take_up(index == 0 ? UpAxis::Y : UpAxis::Z); });
}

const Object* Properties::active_object() const {
  const auto active = m_document.selection().active();
  const ObjectSnapshot* const found = active ? m_document.snapshot()->find(*active) : nullptr;
  return found ? found->object.get() : nullptr;
}

void Properties::take_scale(double metres) {
  const Object* const object = active_object();
  if (object && object->scale != metres) m_document.rescale(object->name, metres, kDropHeight);
}

void Properties::take_height(double metres) {
  const Object* const object = active_object();
  if (!object) return;
  const double now = height_of(*object);
  if (now > 0) take_scale(object->scale * metres / now);
}

void Properties::take_up(UpAxis up) {
  const Object* const object = active_object();
  if (object && object->up != up) m_document.rescale(object->name, object->scale, up, kDropHeight);
}

void Properties::show_frame(const Object& object) {
  const int unit = m_unit->findData(object.scale);
  m_unit->setCurrentIndex(unit >= 0 ? unit : m_unit->count() - 1);
  m_up->setCurrentIndex(object.up == UpAxis::Y ? 0 : 1);
}

void Properties::stand(PosePart part, int axis, double value) {
  const Object* const object = active_object();
  if (!object) return;
  StandOperation stand;
  stand.object = object->name;
  stand.pose = with_number(object->pose, part, axis, value);
  m_document.perform(stand);
}

void Properties::set(const QString& name, const QString& value, const QString& tip) {
  QLabel*& label = m_values[name];
  if (!label) {
    label = new QLabel;
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setWordWrap(true);
    auto* const title = new QLabel(name);
    title->setObjectName("faint");
    title->setToolTip(tip);
    m_form->addRow(title, label);
  }
  label->setToolTip(tip);
  label->setText(value);
}

void Properties::show_pose(const Object& object) {
  const bool placed = object.placed;
  for (VectorField* const field : {m_position, m_rotation}) field->setEnabled(placed);
  m_position->show_values(placed ? object.pose.translation : Vec3::Zero());
  m_rotation->show_values(placed ? angles_deg(object.pose.rotation) : Vec3::Zero());
  const QSignalBlocker scale(m_scale);
  m_scale->setValue(object.scale);
  const QSignalBlocker height(m_height);
  m_height->setValue(height_of(object));
  show_frame(object);
  const Vec3 size = placed ? Vec3(2 * world_box(object).half_extent())
                           : Vec3(2 * object.scale * object.shape->box.half_extent());
  set(tr("Size"), QString("%1 × %2 × %3")
                      .arg(length_text(size.x()), length_text(size.y()), length_text(size.z())));
}

// Shows how firmly the object rests, alone and with all that it touches.
void Properties::show_rest(const Object& object, ObjectId id) {
  const QString none = QStringLiteral("–");
  const bool rests = object.placed && !object.fixed;
  // An object between slopes is not held by the polygon alone.
  const bool tips = object.stability_margin >= 0 || object.state != ObjectState::Stable;
  set(tr("To tipping"), rests && tips ? length_text(object.stability_margin) : none,
      tr("Distance of the centre of mass inside the support polygon, seen from "
         "above; negative: outside"));
  set(tr("Least friction"),
      !rests                                 ? none
      : std::isfinite(object.least_friction) ? number(object.least_friction, 3)
                                             : tr("no coefficient holds it"),
      tr("Smallest Coulomb coefficient that holds the object"));
  const auto verdict = m_document.verdict();
  const ObjectStability* const judged = verdict ? verdict->find(id) : nullptr;
  set(tr("As a whole"), judged ? QString::fromStdString(object_text(object, *judged)) : none,
      tr("With all that it touches, at the friction of the materials. Margin: how far all weights "
         "may shift sideways before it gives way: %1")
          .arg(judged ? length_text(judged->margin) : none));
}

void Properties::show_object() {
  const auto snapshot = m_document.snapshot();
  const Selection& selection = m_document.selection();
  const ObjectSnapshot* const found =
      selection.active() ? snapshot->find(*selection.active()) : nullptr;
  m_empty->setVisible(!found);
  m_name->setVisible(found);
  m_content->setVisible(found);
  if (!found) return;
  const Object& object = *found->object;
  QString name = QString::fromStdString(object.name);
  if (selection.objects.size() > 1) name += tr("  and %1 more").arg(selection.objects.size() - 1);
  m_name->setText(name);
  set(tr("State"), state_text(object.state));
  show_pose(object);
  show_joint(object);
  show_rest(object, found->id);
  show_material(object.material);
  set(tr("Weight"), weight_text(object), tr("Objects are of uniform density"));
  set(tr("Mass by"), mass_text(object), tr("Objects are of uniform density"));
  set(tr("Touches"), contacts_text(object, *snapshot));
  set(tr("Triangles"),
      QLocale().toString(static_cast<qlonglong>(object.shape->mesh.triangles.size())));
  set(tr("Model"), QString::fromStdString(object.model ? object.model->path : std::string()));
}

}  // namespace trivet::edit
