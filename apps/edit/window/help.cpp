#include "apps/edit/window/help.h"

#include <QDialog>
#include <QFrame>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <vector>

namespace trivet::edit {
namespace {

QString tr(const char* text) { return QObject::tr(text); }

void show_text(QWidget* parent, const QString& title, const QString& html) {
  auto* const dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  dialog->resize(640, 560);
  auto* const column = new QVBoxLayout(dialog);
  column->setContentsMargins(0, 0, 0, 0);
  auto* const text = new QTextBrowser;
  text->setFrameStyle(QFrame::NoFrame);
  text->document()->setDocumentMargin(20);
  text->setHtml(html);
  column->addWidget(text);
  dialog->show();
}

QString table(const QString& heading, const std::vector<ShortcutRow>& rows) {
  QString html = "<h3>" + heading + "</h3><table cellspacing=\"0\" cellpadding=\"3\">";
  for (const ShortcutRow& row : rows)
    html += "<tr><td width=\"210\"><b>" + row.keys.toHtmlEscaped() + "</b></td><td>" +
            row.what.toHtmlEscaped() + "</td></tr>";
  return html + "</table>";
}

}  // namespace

void show_shortcuts(QWidget* parent, const std::vector<ShortcutRow>& menu_shortcuts) {
  const std::vector<ShortcutRow> mouse = {
      {tr("Left"), tr("Drag an object to move it, a drawer or door to open it; click to select; "
                      "drag from the ground for a box; "
                      "with another tool, use that")},
      {tr("Shift + Left"), tr("Click: add to the selection. Drag: lift the object")},
      {tr("Shift + Control + Left"), tr("Box, also from an object")},
      {tr("Wheel, or , and . with an object in hand"), tr("Turn it about the vertical")},
      {tr("L with an object in hand"), tr("Next way in which it can lie, the nearest first")},
      {tr("Middle, or Alt + Left"), tr("Orbit (perspective), pan (other windows)")},
      {tr("Shift + Middle, or Right"), tr("Pan")},
      {tr("Wheel, or Control + Middle"), tr("Zoom towards the mouse")},
      {tr("Control + Wheel"), tr("Move the section plane of the window")},
      {tr("Control during a drag"), tr("Snap, or not if the magnet is on")},
      {tr("Right click"), tr("Menu for the selection")},
      {tr("Double click on a title"), tr("Maximise the window, and restore it")},
      {tr("Escape"), tr("Put back what is in hand; cancel the action; close messages")},
  };
  show_text(parent, tr("Mouse and keys"),
            table(tr("Mouse"), mouse) + table(tr("Keys"), menu_shortcuts));
}

void show_two_minutes(QWidget* parent) {
  show_text(
      parent, tr("A table in two minutes"),
      tr("<h2>A table in two minutes</h2><ol>"
         "<li><b>File, Import models…</b> (or drop files onto the window): choose the table, its "
         "unit, and <i>fixed</i>. Click the place for it on the floor.</li>"
         "<li>Import plates, cups and spoons in the same way. After the import, each  "
         "is shown as a ghost where it would come to rest. Click on the table: it falls, "
         "settles, and lies at rest. Into a shelf: click on its board.</li>"
         "<li>To put another object, press <b>N</b> for the next one, or choose it in the tree, "
         "then press <b>W</b> (Put). A red ghost says why it cannot be there.</li>"
         "<li><b>Drag</b> a cup along the table, without a tool: it slides, hangs back where it is "
         "blocked, and climbs onto the saucer, the tray or the shelf under the mouse. A ghost "
         "shows "
         "where it will come to rest; let go, and it settles. Meanwhile the wheel turns it, "
         "<b>L</b> lays it otherwise, Shift lifts it, Control snaps, Escape puts it back.</li>"
         "<li><b>E</b> (Push): the same along the surface alone, with steps and walls as "
         "set.</li>"
         "<li><b>R</b> (Turn): click a contact point, edge or area in the constraint window "
         "and drag about it; or drag to turn about the contact's normal.</li>"
         "<li><b>T</b> (Pick up), <b>G</b> (Move) and <b>H</b> (Rotate) move it through the "
         "air.</li>"
         "<li><b>Control+D</b> makes a copy. <b>Control+Z</b> undoes "
         "any number of steps; the History tab jumps to any of them.</li>"
         "<li><b>Control+S</b> saves the scene as .glb, which other programs can read. "
         "<b>File, Picture…</b> renders a picture of the current view.</li></ol>"
         "<p>When an operation is refused, a bar gives the reason, and the obstacles are "
         "marked. "
         "The scene is unchanged.</p>"));
}

}  // namespace trivet::edit
