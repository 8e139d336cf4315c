#include "apps/edit/window/many_dialogs.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QStringList>
#include <cmath>

#include "apps/edit/window/form_dialog.h"

namespace trivet::edit {
namespace {

constexpr int kMost = 10000;      // objects at once
constexpr double kGap = 0.01;     // metres between copies, unless the user says otherwise
constexpr double kDigits = 1000;  // lengths are proposed in millimetres

QString tr(const char* text) { return QObject::tr(text); }

double proposed(double metres) { return std::ceil(metres * kDigits) / kDigits; }

/// Fields of one end and the other.
struct Range {
  QDoubleSpinBox *lower, *upper;
};

Range range(FormDialog& dialog, const QString& axis, double centre) {
  auto* const lower = dialog.metres(tr("%1 from").arg(axis), centre - 0.25);
  return {lower, dialog.metres(tr("%1 to").arg(axis), centre + 0.25)};
}

}  // namespace

std::optional<ArrayWish> ask_for_array(QWidget* parent, const Object& object) {
  using Kind = ArrayWish::Kind;
  ArrayWish wish;
  wish.object = object.name;
  const Vec3 size = 2 * world_box(object).half_extent();
  FormDialog dialog(parent, tr("Array of %1").arg(QString::fromStdString(object.name)), tr("Put"));
  auto* const kind = dialog.choice(tr("Pattern"), {tr("Line"), tr("Grid"), tr("Circle")});
  auto* const count = dialog.number(tr("Objects"), wish.count, 2, kMost);
  auto* const rows = dialog.number(tr("Along x"), wish.rows, 1, 100);
  auto* const columns = dialog.number(tr("Along y"), wish.columns, 1, 100);
  auto* const x = dialog.metres(tr("Step x"), proposed(size.x() + kGap));
  auto* const y = dialog.metres(tr("Step y"), 0);
  auto* const z = dialog.metres(tr("Step z"), 0);
  auto* const centre_x = dialog.metres(tr("Centre x"), 0);
  auto* const centre_y = dialog.metres(tr("Centre y"), proposed(3 * size.head<2>().norm()));
  auto* const angle = dialog.degrees(tr("Angle"), wish.angle_deg);
  auto* const turned = dialog.yes_or_no(tr("Turn each with its place"), wish.turned);
  dialog.note(tr(
      "The first is the object itself. Each copy is put from just above; what is refused is left "
      "out."));
  const auto follow = [&] {
    const auto now = static_cast<Kind>(kind->currentIndex());
    dialog.show_rows({count}, now != Kind::Grid);
    dialog.show_rows({rows, columns}, now == Kind::Grid);
    dialog.show_rows({x, y}, now != Kind::Circle);
    dialog.show_rows({z}, now == Kind::Line);
    dialog.show_rows({centre_x, centre_y, angle, turned}, now == Kind::Circle);
    if (now == Kind::Grid && y->value() == 0) y->setValue(proposed(size.y() + kGap));
  };
  QObject::connect(kind, &QComboBox::currentIndexChanged, &dialog, follow);
  follow();
  if (!dialog.ask()) return std::nullopt;
  wish.kind = static_cast<Kind>(kind->currentIndex());
  wish.count = count->value(), wish.rows = rows->value(), wish.columns = columns->value();
  wish.step = Vec3(x->value(), y->value(), z->value());
  wish.centre = Vec2(centre_x->value(), centre_y->value());
  wish.angle_deg = angle->value();
  wish.turned = turned->isChecked();
  return wish;
}

std::optional<ScatterWish> ask_for_scatter(QWidget* parent, const SceneSnapshot& scene,
                                           ScatterWish wish, bool put_all) {
  FormDialog dialog(parent, put_all ? tr("Put all that are not placed") : tr("Scatter"), tr("Put"));
  auto* const count = dialog.number(tr("Objects"), wish.count, 1, kMost);
  dialog.show_rows({count}, !put_all);
  QStringList supports;
  if (scene.floor) supports << tr("the floor");
  for (const ObjectSnapshot& object : scene.objects)
    if (object->placed) supports << QString::fromStdString(object->name);
  auto* const on = dialog.choice(tr("On"), supports,
                                 std::max(0LL, supports.indexOf(QString::fromStdString(wish.on))));
  auto* const within = dialog.yes_or_no(tr("In a rectangle"), false);
  const Aabb box = scene.box();
  const Vec3 middle = box.empty() ? Vec3(Vec3::Zero()) : box.centre();
  const Range x = range(dialog, "x", proposed(middle.x()));
  const Range y = range(dialog, "y", proposed(middle.y()));
  auto* const pile = dialog.yes_or_no(tr("As a pile, on each other"), wish.pile);
  auto* const keep = dialog.metres(tr("Keep away"), wish.keep, 0);
  auto* const turn =
      dialog.choice(tr("Turned"), {tr("not"), tr("about the vertical"), tr("anyhow")},
                    static_cast<int>(wish.turn));
  auto* const seed = dialog.number(tr("Seed"), static_cast<int>(wish.seed), 0, 1000000);
  dialog.note(tr(
      "Each object is placed at a random free spot on the selected support, or let fall over its "
      "middle as a pile; objects that do not fit are skipped. Cancel keeps what is placed."));
  const auto follow = [&] {
    dialog.show_rows({x.lower, x.upper, y.lower, y.upper}, within->isChecked());
    dialog.show_rows({keep}, !pile->isChecked());
  };
  QObject::connect(within, &QCheckBox::toggled, &dialog, follow);
  QObject::connect(pile, &QCheckBox::toggled, &dialog, follow);
  follow();
  if (supports.isEmpty() || !dialog.ask()) return std::nullopt;
  if (!put_all) wish.count = count->value();
  wish.on = scene.floor && on->currentIndex() == 0 ? "floor" : on->currentText().toStdString();
  if (within->isChecked())
    wish.region = {Vec2(x.lower->value(), y.lower->value()),
                   Vec2(x.upper->value(), y.upper->value())};
  wish.pile = pile->isChecked();
  wish.keep = keep->value();
  wish.turn = static_cast<RandomTurn>(turn->currentIndex());
  wish.seed = static_cast<std::uint64_t>(seed->value());
  return wish;
}

std::optional<AlignWish> ask_for_alignment(QWidget* parent, AlignWish wish) {
  FormDialog dialog(parent, tr("Align"), tr("Align"));
  auto* const how = dialog.choice(
      tr("By"), {tr("lower sides"), tr("centres"), tr("upper sides"), tr("equal gaps")},
      static_cast<int>(wish.how));
  auto* const axis = dialog.choice(tr("Along"), {"x", "y"}, wish.axis);
  dialog.note(tr(
      "To the object that was selected last; equal gaps leave the outermost two. Each is put from "
      "just above, with its loads."));
  if (!dialog.ask()) return std::nullopt;
  wish.how = static_cast<AlignWish::How>(how->currentIndex());
  wish.axis = axis->currentIndex();
  return wish;
}

}  // namespace trivet::edit
