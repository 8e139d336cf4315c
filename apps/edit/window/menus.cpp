// Actions of the main window: each is in a menu, with its keys.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QKeySequence>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>

#include "apps/demo/arranged.h"
#include "apps/demo/demo.h"
#include "apps/edit/window/main_window.h"
#include "apps/edit/window/quick_actions.h"

namespace trivet::edit {
void MainWindow::make_actions() {
  make_file_actions();
  make_edit_actions();
  make_tool_actions();
  make_hand_actions();
  m_snap_menu = new SnapMenu(m_toolbox, m_actions, this);
  connect(m_snap_menu, &SnapMenu::steps_wanted, this, &MainWindow::ask_preferences);
  make_view_actions();
  make_many_actions();
  make_look_actions();
  make_collection_actions();
  make_help_actions();
  make_menus();
  make_tool_bar();
  connect_start_page();
}

void MainWindow::make_help_actions() {
  add_action("two minutes", tr("A table in &two minutes"), {}, [this] { show_two_minutes(this); });
  add_action("shortcuts", tr("&Mouse and keys"), Qt::Key_F1,
             [this] { show_shortcuts(this, m_actions.shortcut_rows()); });
  add_action(
      "quick actions", tr("&Quick actions…"), tr("Ctrl+Space"),
      [this] { (new QuickActions(actions(), this))->show(); },
      tr("Quick actions: find an action by words"));
  add_action("about", tr("&About Trivet"), {}, [this] {
    QMessageBox::about(
        this, tr("About Trivet"),
        tr("<b>Trivet %1</b><p>Lays out objects with geometric and physical constraints, after "
           "Shinya and Forgue (1995).</p><p>MIT licence. Pictures: %2</p>")
            .arg(QApplication::applicationVersion(), m_workspace->device().toHtmlEscaped()));
  });
}

void MainWindow::connect_start_page() {
  connect(m_start_page, &StartPage::new_wanted, this, &MainWindow::new_scene);
  connect(m_start_page, &StartPage::open_wanted, this, &MainWindow::ask_open);
  connect(m_start_page, &StartPage::import_wanted, this, &MainWindow::ask_import);
  connect(m_start_page, &StartPage::help_wanted, this, [this] { show_two_minutes(this); });
  connect(m_start_page, &StartPage::file_wanted, this, &MainWindow::open_file);
  connect(m_start_page, &StartPage::demo_wanted, this, &MainWindow::open_demo);
  connect(m_start_page, &StartPage::recovery_wanted, this, [this](const QString& journal) {
    when_finished(m_document.restore(journal.toStdString()), [this](bool ok) {
      if (ok) show_workspace();
    });
  });
  connect(m_start_page, &StartPage::discard_wanted, this, [this](const QString& journal) {
    m_document.discard(journal.toStdString());
    show_start_page();
  });
}

void MainWindow::make_file_actions() {
  m_actions.set_icon(add_action(
                         "new", tr("&New"), QKeySequence::New, [this] { new_scene(); },
                         tr("New scene: an empty floor")),
                     Icon::New);
  m_actions.set_icon(add_action(
                         "open", tr("&Open…"), QKeySequence::Open, [this] { ask_open(); },
                         tr("Open a scene or a layout")),
                     Icon::Open);
  m_actions.set_icon(add_action(
                         "import", tr("&Import models…"), tr("Ctrl+I"), [this] { ask_import(); },
                         tr("Import models")),
                     Icon::Import);
  m_actions.set_icon(add_action("save", tr("&Save"), QKeySequence::Save, [this] { save({}); }),
                     Icon::Save);
  add_action("save as", tr("Save &as…"), tr("Ctrl+Shift+S"), [this] { save_as({}); });
  add_action(
      "export", tr("&Export…"), tr("Ctrl+E"), [this] { ask_export(); },
      tr("Export for other programs, for simulators, or as a table"));
  m_actions.set_icon(add_action(
                         "picture", tr("&Picture…"), tr("Ctrl+P"), [this] { ask_picture(); },
                         tr("Picture of the perspective view")),
                     Icon::Picture);
  add_action("start page", tr("Start pa&ge"), {}, [this] { show_start_page(); });
  add_action("quit", tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::make_edit_actions() {
  m_actions.set_icon(
      add_action("undo", tr("&Undo"), QKeySequence::Undo, [this] { m_document.undo(); }),
      Icon::Undo);
  m_actions.set_icon(
      add_action("redo", tr("&Redo"), tr("Ctrl+Shift+Z"), [this] { m_document.redo(); }),
      Icon::Redo);
  add_action(
      "duplicate", tr("&Duplicate"), tr("Ctrl+D"), [this] { duplicate(); },
      tr("Duplicate: add another object of the same model, not placed yet"));
  add_action("rename", tr("Rena&me"), tr("F2"), [this] { control().outliner().edit_name(); });
  add_action("delete", tr("De&lete"), QKeySequence::Delete, [this] { m_toolbox.erase_selected(); });
  add_action("select all", tr("Select &all"), QKeySequence::SelectAll, [this] { select_all(); });
  add_action("search", tr("Searc&h"), tr("/"), [this] { control().search().setFocus(); });
  add_action("select none", tr("Select &none"), tr("Ctrl+Shift+A"),
             [this] { m_document.select({}); });
  add_action(
      "lock", tr("Loc&k"), tr("Ctrl+L"), [this] { lock_selected(true); },
      tr("Lock: operations refuse to move it; it may still topple"));
  add_action("unlock", tr("Unlock"), tr("Ctrl+Shift+L"), [this] { lock_selected(false); });
  add_action(
      "fix", tr("Fi&x"), tr("Ctrl+F"), [this] { fix_selected(true); },
      tr("Fix: it never moves, and supports any load"));
  add_action(
      "unfix", tr("Unfix"), tr("Ctrl+Shift+F"), [this] { fix_selected(false); },
      tr("Unfix: it can be moved again, with its loads"));
  add_action(
      "group", tr("&Group"), tr("Ctrl+G"), [this] { group_selected(true); },
      tr("Group: its objects always move together"));
  add_action("preferences", tr("&Preferences…"), tr("Ctrl+,"), [this] { ask_preferences(); });
  add_action("ungroup", tr("Ungroup"), tr("Ctrl+Shift+G"), [this] { group_selected(false); });
}

void MainWindow::make_tool_actions() {
  auto* const group = new QActionGroup(this);
  const auto tool = [&](const char* name, const QString& text, const char* key, ToolKind kind,
                        const QString& tip) {
    QAction* const action = add_action(
        name, text, QKeySequence(key), [this, kind] { take_tool(kind); }, tip);
    action->setCheckable(true);
    group->addAction(action);
    m_actions.set_icon(action, static_cast<Icon>(kind));
  };
  tool("select", tr("&Select"), "Q", ToolKind::Select,
       tr("Select and move: drag an object, click it, or draw a box"));
  tool("put", tr("&Put"), "W", ToolKind::Put,
       tr("Put: drop the object where you click, and let it settle"));
  tool("push", tr("Pus&h"), "E", ToolKind::Push,
       tr("Push: move the object along the surface it lies on"));
  tool("turn", tr("&Turn"), "R", ToolKind::Turn,
       tr("Turn: about a contact's normal, edge or point"));
  tool("pick up", tr("Pick &up"), "T", ToolKind::PickUp,
       tr("Pick up: move the object away from its support"));
  tool("move", tr("&Move"), "G", ToolKind::Move, tr("Move: translate the object by handles"));
  tool("rotate", tr("&Rotate"), "H", ToolKind::Rotate, tr("Rotate: turn the object by handles"));
  tool("paint", tr("P&aint"), "B", ToolKind::Paint,
       tr("Paint: drag over a surface to set down copies along the stroke"));
  tool("drape", tr("&Drape"), "D", ToolKind::Drape,
       tr("Drape: let a cloth, a paper or a cable come down where you click"));
}

void MainWindow::make_hand_actions() {
  add_action(
      "put here", tr("Put at the mouse &position"), tr("P"), [this] { m_toolbox.put_at_pointer(); },
      tr("Put: drop the active object at the mouse position"));
  add_action(
      "take next", tr("Take the &next object"), tr("N"), [this] { m_toolbox.take_next(); },
      tr("Put: take the next object that is not placed yet"));
  add_action(
      "pick up now", tr("Pick up &now"), tr("U"), [this] { m_toolbox.pick_up(); },
      tr("Pick up the selected object by the distance in the operation panel"));
  add_action(
      "next way", tr("Next wa&y to lie"), tr("L"), [this] { m_toolbox.lie(Lying::Next); },
      tr("Lift the object, lay it as it can lie next, and let it settle"));
  add_action(
      "on its side", tr("Lay on its s&ide"), tr("Alt+L"),
      [this] { m_toolbox.lie(Lying::OnItsSide); },
      tr("Lift the object, lay it on its side, and let it settle"));
  add_action(
      "upright", tr("Stand upri&ght"), tr("Alt+U"), [this] { m_toolbox.lie(Lying::Upright); },
      tr("Lift the object, stand it upright, and let it settle"));
  add_action(
      "lean", tr("L&ean against the last selected"), tr("Shift+L"),
      [this] {
        if (!m_toolbox.lean())
          say(Message::Kind::Info, tr("Lean: select an object that stands, then what it leans on"));
      },
      tr("Tilt the object until it touches the one selected last, and let it go"));
  add_action(
      "turn left", tr("Turn &left"), tr(","), [this] { m_toolbox.turn(1); },
      tr("Turn about the vertical by a step, seen from above to the left"));
  add_action(
      "turn right", tr("Turn ri&ght"), tr("."), [this] { m_toolbox.turn(-1); },
      tr("Turn about the vertical by a step, seen from above to the right"));
  add_action(
      "next contact", tr("Ne&xt contact"), tr("V"), [this] { m_toolbox.next_contact(); },
      tr("The next contact of the active object: the constraint window looks along it, and Push "
         "goes along it, walls included"));
}

QMenu* MainWindow::add_menu(const QString& title, std::initializer_list<const char*> names) {
  QMenu* const out = menuBar()->addMenu(title);
  m_actions.fill(*out, names);
  return out;
}

void MainWindow::make_file_menu() {
  QMenu* const file = add_menu(tr("&File"), {"new", "open"});
  m_recent_menu = file->addMenu(tr("Open &recent"));
  connect(m_recent_menu, &QMenu::aboutToShow, this, &MainWindow::fill_recent_menu);
  QMenu* const demos = file->addMenu(tr("Open &demo"));
  for (const std::vector<std::string>& names : {demo_names(), arranged_demo_names()}) {
    for (const std::string& name : names)
      demos->addAction(QString::fromStdString(name),
                       [this, name] { open_demo(QString::fromStdString(name)); });
    demos->addSeparator();
  }
  m_actions.fill(*file, {"", "import", "", "save", "save as", "", "export", "picture", "",
                         "start page", "quit"});
}

void MainWindow::make_view_menu() {
  QMenu* const view = add_menu(tr("&View"), {"frame", "frame all", ""});
  m_actions.fill(*view, {"from front", "from side", "from above", "from behind", "follow contact",
                         "section", "", "maximise", "reset layout", ""});
  m_actions.fill(*view, {"hide", "show all", "not selectable", "all selectable"});
  view->addMenu(m_colours);
  view->addMenu(m_bookmark_menu);
  m_actions.fill(*view, {"", "shadows", "contacts", "watch settling", "zlists", "assets", "dark"});
}

void MainWindow::make_context_menu() {
  m_context_menu = new QMenu(this);
  m_actions.fill(
      *m_context_menu,
      {"put",      "push",        "turn",    "pick up", "move",      "rotate", "",
       "next way", "on its side", "upright", "",        "duplicate", "delete", "lock",
       "unlock",   "fix",         "unfix",   "",        "frame",     "hide",   "not selectable"});
  m_context_menu->addMenu(m_colours);
}

void MainWindow::make_menus() {
  make_file_menu();
  add_menu(
      tr("&Edit"),
      {"undo",        "redo",    "", "duplicate", "rename",    "delete", "",           "select all",
       "select none", "search",  "", "lock",      "unlock",    "fix",    "unfix",      "",
       "group",       "ungroup", "", "collect",   "uncollect", "",       "preferences"});
  QMenu* const object =
      add_menu(tr("&Object"),
               {"select",      "put",          "push",       "turn",     "pick up",     "move",
                "rotate",      "paint",        "drape",      "",         "put here",    "take next",
                "pick up now", "next contact", "",           "next way", "on its side", "upright",
                "lean",        "turn left",    "turn right", "",         "snap"});
  object->addMenu(m_snap_menu);
  add_menu(tr("&Many"), {"array", "scatter", "put all", "", "align", "replace", "", "arrange", "",
                         "mend", "settle all"});
  make_view_menu();
  add_menu(tr("&Help"), {"quick actions", "two minutes", "shortcuts", "about"});
  make_context_menu();
}

void MainWindow::make_tool_bar() {
  QToolBar* const bar = addToolBar(tr("Tools"));
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setIconSize(QSize(20, 20));
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  m_actions.fill(*bar,
                 {"new",    "open", "save", "import", "",        "undo",     "redo",   "",
                  "select", "put",  "push", "turn",   "pick up", "move",     "rotate", "paint",
                  "drape",  "",     "snap", "",       "frame",   "maximise", "picture"});
  m_snap_menu->dress_button(*bar);
  for (const char* const name :
       {"select", "put", "push", "turn", "pick up", "move", "rotate", "paint", "drape"})
    if (auto* const button = qobject_cast<QToolButton*>(bar->widgetForAction(action(name))))
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

}  // namespace trivet::edit
