// Menu actions on many objects at once, and on how objects are shown.
#include <QColor>
#include <QMenu>
#include <QPixmap>

#include "apps/edit/window/main_window.h"
#include "apps/edit/window/many_dialogs.h"

namespace trivet::edit {
namespace {

struct NamedColour {
  const char* name;
  LookColour colour;
};
// Told apart by the colour-blind, too [Okabe 2008].
constexpr NamedColour kColours[] = {
    {QT_TR_NOOP("Orange"), {0.90f, 0.62f, 0.00f}}, {QT_TR_NOOP("Sky blue"), {0.34f, 0.71f, 0.91f}},
    {QT_TR_NOOP("Green"), {0.00f, 0.62f, 0.45f}},  {QT_TR_NOOP("Yellow"), {0.94f, 0.89f, 0.26f}},
    {QT_TR_NOOP("Blue"), {0.00f, 0.45f, 0.70f}},   {QT_TR_NOOP("Vermilion"), {0.84f, 0.37f, 0.00f}},
    {QT_TR_NOOP("Purple"), {0.80f, 0.47f, 0.65f}}, {QT_TR_NOOP("Grey"), {0.55f, 0.55f, 0.55f}},
};

// Of the selected objects where there are several, else of all.
Operation repair_of(bool mends, const std::vector<std::string>& selected) {
  RepairOperation out;
  out.mends = mends;
  if (selected.size() > 1) out.only = selected;
  return out;
}

}  // namespace

std::vector<std::string> MainWindow::selected_names() const {
  return edit::selected_names(m_document.selection(), *m_document.snapshot());
}

void MainWindow::perform_many(const QString& name, ManyObjects many) {
  if (many.groups.empty())
    return say(Message::Kind::Info, tr("%1: there is none to put").arg(name));
  m_document.perform_groups(name.toStdString(), std::move(many));
}

void MainWindow::make_array() {
  const auto snapshot = m_document.snapshot();
  const auto active = m_document.selection().active();
  const ObjectSnapshot* const object = active ? snapshot->find(*active) : nullptr;
  if (!object || !(*object)->placed)
    return say(Message::Kind::Info, tr("Array: first put the object"));
  auto wish = ask_for_array(this, *object->object);
  if (!wish) return;
  wish->drop_height = m_toolbox.options().drop_height;
  perform_many(tr("array"), array_of(*snapshot, *wish));
}

void MainWindow::scatter(bool put_all) {
  const auto snapshot = m_document.snapshot();
  ScatterWish wish;
  wish.objects = put_all ? unplaced_names(*snapshot) : selected_names();
  if (put_all) wish.count = static_cast<int>(wish.objects.size());
  if (put_all && wish.objects.empty())
    return say(Message::Kind::Info, tr("Put all: every object is placed"));
  if (const auto asked = ask_for_scatter(this, *snapshot, wish, put_all))
    perform_many(put_all ? tr("put all") : tr("scatter"), scattered(*snapshot, *asked));
}

void MainWindow::align_selected() {
  AlignWish wish;
  wish.objects = selected_names();
  wish.drop_height = m_toolbox.options().drop_height;
  if (wish.objects.size() < 2)
    return say(Message::Kind::Info, tr("Align: select two objects or more"));
  if (const auto asked = ask_for_alignment(this, wish))
    perform_many(tr("align"), aligned(*m_document.snapshot(), *asked));
}

void MainWindow::replace_selected() {
  std::vector<std::string> names = selected_names();
  if (names.size() < 2)
    return say(Message::Kind::Info,
               tr("Replace: select the objects, and last the one whose copies take their places"));
  const std::string by = names.back();
  names.pop_back();
  perform_many(tr("replace"),
               replaced(*m_document.snapshot(), names, by, m_toolbox.options().drop_height));
}

void MainWindow::change_looks(const QString& name, const std::function<void(Look&)>& change) {
  Looks looks = m_document.looks();
  for (const ObjectId id : m_document.selection().objects) {
    Look look = looks.of(id);
    change(look);
    looks.change(id, look);
  }
  m_document.set_looks(std::move(looks), name.toStdString());
}

void MainWindow::reset_looks(const QString& name, bool Look::*field) {
  Looks looks = m_document.looks();
  for (const ObjectSnapshot& object : m_document.snapshot()->objects) {
    Look look = looks.of(object.id);
    look.*field = false;
    looks.change(object.id, look);
  }
  m_document.set_looks(std::move(looks), name.toStdString());
}

void MainWindow::make_many_actions() {
  add_action(
      "array", tr("&Array…"), tr("Ctrl+Shift+D"), [this] { make_array(); },
      tr("Array: copies in a line, a grid or a circle"));
  add_action(
      "scatter", tr("&Scatter…"), {}, [this] { scatter(false); },
      tr("Scatter: copies at free places of a support"));
  add_action(
      "put all", tr("Put a&ll…"), {}, [this] { scatter(true); },
      tr("Put all objects that are not placed yet"));
  add_action(
      "align", tr("Al&ign…"), {}, [this] { align_selected(); },
      tr("Align the selected objects, or space them evenly"));
  add_action(
      "replace", tr("&Replace by the last selected"), {}, [this] { replace_selected(); },
      tr("Replace the selected objects by copies of the one selected last"));
  add_action(
      "mend", tr("&Mend"), {}, [this] { m_document.perform(repair_of(true, selected_names())); },
      tr("Mend: move what interpenetrates or floats as little as possible, so that everything "
         "rests on what it was meant to rest on; of several selected objects, these alone"));
  add_action(
      "settle all", tr("Se&ttle"), {},
      [this] { m_document.perform(repair_of(false, selected_names())); },
      tr("Settle: let what floats or is sunk come to rest; of several selected objects, these "
         "alone"));
}

void MainWindow::make_look_actions() {
  add_action(
      "hide", tr("H&ide"), tr("Ctrl+H"),
      [this] { change_looks(tr("hide"), [](Look& look) { look.hidden = true; }); },
      tr("Hide: not drawn; it stays in the scene"));
  add_action("show all", tr("Sho&w hidden"), tr("Ctrl+Shift+H"),
             [this] { reset_looks(tr("show hidden"), &Look::hidden); });
  add_action(
      "not selectable", tr("&Not selectable"), tr("Ctrl+K"),
      [this] {
        change_looks(tr("not selectable"), [](Look& look) { look.not_selectable = true; });
      },
      tr("Not selectable: clicks pass through it, but things can be put on it"));
  add_action("all selectable", tr("All s&electable"), tr("Ctrl+Shift+K"),
             [this] { reset_looks(tr("all selectable"), &Look::not_selectable); });
  m_colours = new QMenu(tr("Co&lour"), this);
  m_colours->setObjectName("colours");
  m_colours->addAction(tr("As the model"), [this] {
    change_looks(tr("colour"), [](Look& look) { look.colour.reset(); });
  });
  for (const NamedColour& named : kColours) {
    const LookColour c = named.colour;
    QPixmap sample(16, 16);
    sample.fill(QColor::fromRgbF(c[0], c[1], c[2]));
    m_colours->addAction(sample, tr(named.name), [this, c] {
      change_looks(tr("colour"), [c](Look& look) { look.colour = c; });
    });
  }
}

}  // namespace trivet::edit
