#include "apps/edit_hour/hour.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QTabBar>

#include "apps/edit_document/boxes.h"
#include "apps/edit_hour/dragging.h"

namespace trivet::edit::test {
namespace {

const Vec3 kTray(0, -0.95, 0), kCup(0.85, -0.8, 0);

class Hour {
 public:
  Hour(Document& document, MainWindow& window, User& user, const QString& folder)
      : m_document(document), m_window(window), m_user(user), m_folder(folder) {}

  void import_folders();
  void put_shelf();
  void put_book_into_shelf();
  void put_ten_in_a_row();
  void put_forty_apples();
  void push_and_turn();
  void type_numbers();
  void rename();
  void collect();
  void save_and_reopen();
  void export_and_render();

 private:
  void show_folder(const QString& name);
  void show_room();
  void wait_for(const std::string& object);
  void begin() { m_before = m_user.effort(); }
  /// Since begin(), and what was done in the asset browser.
  void print_effort(const char* what, int asset_clicks = 0, int asset_drags = 0) const;
  void enter_file(const QString& file);
  void enter_file_once_asked(const QString& file);
  void with_row(QWidget& dialog, const char* row, const QString& text);
  Vec3 centre(const std::string& name) { return world_box(m_user.object(name)).centre(); }

  Document& m_document;
  MainWindow& m_window;
  User& m_user;
  QString m_folder;
  User::Effort m_before;
};

/// A row of a dialog, in the language of the window.
QString in_words(const char* text) { return QCoreApplication::translate("QObject", text); }

void Hour::print_effort(const char* what, int asset_clicks, int asset_drags) const {
  const User::Effort& now = m_user.effort();
  std::printf("effort: %s: %d clicks, %d drags, %d keys\n", what,
              now.clicks - m_before.clicks + asset_clicks, now.drags - m_before.drags + asset_drags,
              now.keys - m_before.keys);
}

void Hour::wait_for(const std::string& object) {
  QTRY_VERIFY_WITH_TIMEOUT(m_document.snapshot()->find(object), kPatienceMs);
  QVERIFY(m_user.wait());
}

void Hour::with_row(QWidget& dialog, const char* row, const QString& text) {
  auto* const box = dialog.findChild<QAbstractSpinBox*>(in_words(row));
  QVERIFY2(box, row);
  box->setFocus();
  m_user.press_key_in(*box, Qt::Key_A, Qt::ControlModifier);
  m_user.type(*box, text);
}

/// Null: none is open.
QFileDialog* open_file_dialog() {
  for (QWidget* const widget : QApplication::topLevelWidgets())
    if (auto* const files = qobject_cast<QFileDialog*>(widget); files && files->isVisible())
      return files;
  return nullptr;
}

/// Into the file dialog that is open.
void Hour::enter_file(const QString& file) {
  QFileDialog* const files = open_file_dialog();
  QVERIFY2(files, "no file dialog");
  auto* const field = files->findChild<QLineEdit*>("fileNameEdit");
  field->setText(file);
  QTest::keyClick(field, Qt::Key_Return);
}

/// Into one that another dialog is about to open.
void Hour::enter_file_once_asked(const QString& file) {
  auto* const timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [this, timer, file] {
    if (!open_file_dialog()) return;
    timer->stop();
    timer->deleteLater();
    enter_file(file);
  });
  timer->start(50);
}

// --- models ------------------------------------------------------------------------------------

void Hour::show_folder(const QString& name) {
  AssetBrowser& assets = m_window.assets();
  m_user.with_dialog([&] { m_user.click(*assets.findChild<QToolButton*>("add folder")); },
                     [&](QWidget&) { enter_file(m_folder + "/" + name); });
  QVERIFY(assets.folder().endsWith(name));
  const auto all_made = [&] {
    for (int i = 0; i < assets.list().count(); ++i)
      if (!assets.thumbnails().find(assets.list().item(i)->data(Qt::UserRole).toString()))
        return false;
    return assets.list().count() > 0;
  };
  QVERIFY(QTest::qWaitFor(all_made, kPatienceMs));
}

void Hour::import_folders() {
  m_user.press_key(Qt::Key_N, Qt::ControlModifier);
  QVERIFY(m_user.wait());
  m_user.press_key(Qt::Key_M);
  show_folder("kitchen");
  m_user.look("kitchen");
  show_folder("library");
  auto* const unit = m_window.assets().findChild<QComboBox*>("asset unit");
  m_user.press_key_in(*unit, Qt::Key_Down);
  m_user.press_key_in(*unit, Qt::Key_Down);
  m_user.press_key_in(*unit, Qt::Key_Down);
  QCOMPARE(unit->currentData().toDouble(), 0.001);
  m_user.look("library_in_millimetres");
}

void Hour::put_shelf() {
  double_click_asset(m_window, "shelf");
  wait_for("shelf");
  m_user.click(WindowKind::Perspective, Vec3::Zero());
  QVERIFY(m_user.wait());
  const Aabb box = world_box(m_user.object("shelf"));
  QVERIFY2(std::abs(box.upper.x() - box.lower.x() - 1.04) < 1e-6, "1.04 m, not millimetres");
  m_user.press_key(Qt::Key_F, Qt::ControlModifier);
  QVERIFY(m_user.wait());
  QVERIFY(m_user.object("shelf").fixed);
  m_user.move_to(m_window.view(WindowKind::Perspective), QPoint(20, 20));
  m_user.press_key(Qt::Key_Home);
  QVERIFY(m_user.wait());
  m_user.look("shelf");
}

void Hour::put_book_into_shelf() {
  const Vec3 shelf = centre("shelf");
  const Vec3 place(shelf.x() - 0.36, shelf.y() - 0.06, 0.42);
  begin();
  drag_asset(m_window, m_user, "book", WindowKind::Perspective, place);
  wait_for("book");
  QVERIFY(QTest::qWaitFor([&] { return m_user.object("book").placed; }, kPatienceMs));
  print_effort("a book into a shelf", 0, 1);
  QVERIFY2(std::abs(world_box(m_user.object("book")).lower.z() - 0.42) < 1e-3, "on the board");
  QVERIFY(m_user.wait());
  m_user.look("book_in_shelf");
}

void Hour::put_ten_in_a_row() {
  begin();
  m_user.select("book");
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier); },
                     [&](QWidget& dialog) {
                       with_row(dialog, "Objects", "10");
                       m_user.look("array_dialog");
                       m_user.press_key_in(dialog, Qt::Key_Return);
                     });
  QVERIFY(m_user.wait());
  print_effort("ten copies in a row");
  QCOMPARE(m_document.selection().objects.size(), size_t{9});
  for (int i = 2; i <= 10; ++i) {
    const Object& book = m_user.object("book " + std::to_string(i));
    QVERIFY(std::abs(world_box(book).lower.z() - 0.42) < 1e-3);
    QVERIFY(book.state == ObjectState::Stable);
  }
  m_user.look("ten_books");
}

/// As the wheel would: the shelf and the floor before it.
void Hour::show_room() {
  for (const WindowKind kind : {WindowKind::Perspective, WindowKind::ThreeView})
    m_window.view(kind).frame({{-0.6, -1.4, 0}, {1.2, 0.3, 0.85}});
  QVERIFY(m_user.wait());
}

void Hour::put_forty_apples() {
  show_folder("kitchen");
  show_room();
  double_click_asset(m_window, "tray");
  wait_for("tray");
  m_user.click(WindowKind::ThreeView, kTray);
  QVERIFY(m_user.wait());
  QVERIFY(m_user.object("tray").placed);
  begin();
  double_click_asset(m_window, "apple");
  wait_for("apple");
  m_user.with_dialog([&] { m_user.choose("scatter"); },
                     [&](QWidget& dialog) {
                       with_row(dialog, "Objects", "40");
                       auto* const on = dialog.findChild<QComboBox*>(in_words("On"));
                       m_user.type(*on, "t");
                       QCOMPARE(on->currentText(), QString("tray"));
                       m_user.look("scatter_dialog");
                       m_user.press_key_in(dialog, Qt::Key_Return);
                     });
  QVERIFY(m_user.wait());
  print_effort("forty apples on a tray", 2);  // with the double click
  int apples = 0;
  for (const ObjectSnapshot& object : m_document.snapshot()->objects)
    apples += object->name.rfind("apple", 0) == 0 && object->state == ObjectState::Stable;
  QCOMPARE(apples, 40);
  m_user.look("forty_apples");
}

// --- moves -------------------------------------------------------------------------------------

void Hour::push_and_turn() {
  drag_asset(m_window, m_user, "cup", WindowKind::ThreeView, kCup);
  wait_for("cup");
  QVERIFY(QTest::qWaitFor([&] { return m_user.object("cup").placed; }, kPatienceMs));
  m_user.select("cup");
  m_user.press_key(Qt::Key_E);
  const Vec3 before = m_user.object("cup").pose.translation;
  const Vec3 from = centre("cup");
  m_user.drag(WindowKind::ThreeView, from, from + Vec3(0, 0.25, 0));
  QVERIFY(m_user.wait());
  QVERIFY((m_user.object("cup").pose.translation - before).norm() > 0.1);
  m_user.look("pushed");
  m_user.press_key(Qt::Key_R);
  QVERIFY(m_user.wait());
  const Rotation turned = m_user.object("cup").pose.rotation;
  const QPoint handle = m_user.pixel_on("cup", WindowKind::Constraint);
  m_user.drag(m_window.view(WindowKind::Constraint), handle, handle + QPoint(30, 50));
  QVERIFY(m_user.wait());
  const Rotation& now = m_user.object("cup").pose.rotation;
  QVERIFY(std::abs(now.w - turned.w) + std::abs(now.z - turned.z) > 1e-3);
  m_user.look("turned");
}

void Hour::type_numbers() {
  m_user.press_key(Qt::Key_G);
  // From afar the handles hide it.
  m_user.move_to(m_window.view(WindowKind::Perspective), QPoint(20, 20));
  m_user.press_key(Qt::Key_F);
  QVERIFY(m_user.wait());
  SceneView& view = m_window.view(WindowKind::Perspective);
  const QPoint cup = m_user.pixel_on("cup", WindowKind::Perspective);
  const Vec3 before = m_user.object("cup").pose.translation;
  m_user.press(view, cup, Qt::LeftButton);
  for (int i = 1; i <= 4; ++i) m_user.move_to(view, cup + QPoint(3 * i, -6 * i));
  QVERIFY(QTest::qWaitFor([&] { return m_document.is_dragging(); }, kPatienceMs));
  for (const Qt::Key key :
       {Qt::Key_0, Qt::Key_Period, Qt::Key_1, Qt::Key_Tab, Qt::Key_0, Qt::Key_Tab, Qt::Key_0})
    m_user.press_key(key);
  const auto moved = [&] { return m_user.object("cup").pose.translation.x() - before.x(); };
  QVERIFY(QTest::qWaitFor([&] { return std::abs(moved() - 0.1) < 1e-5; }, kPatienceMs));
  QVERIFY(m_user.wait_for_drag(view));
  m_user.look("typed_in_a_drag");
  m_user.press_key(Qt::Key_Return);
  m_user.release(view, cup, Qt::LeftButton);
  QVERIFY(m_user.wait());
  const Vec3 off = m_user.object("cup").pose.translation - before - Vec3(0.1, 0, 0);
  QVERIFY2(off.norm() < 1e-5,
           qPrintable(QString("%1 %2 %3").arg(off.x()).arg(off.y()).arg(off.z())));
  m_user.press_key(Qt::Key_Q);
  m_user.show_tab(ControlWindow::tr("Properties"));
  auto* const box = m_window.control().findChild<QDoubleSpinBox*>("position x");
  box->setFocus();
  box->selectAll();
  m_user.type(*box, QLocale().toString(1.05));
  m_user.press_key_in(*box, Qt::Key_Return);
  QVERIFY(m_user.wait());
  QCOMPARE(m_user.object("cup").pose.translation.x(), 1.05);
  m_user.look("position_typed");
}

// --- names -------------------------------------------------------------------------------------

void Hour::rename() {
  m_user.select("cup");
  m_user.press_key(Qt::Key_F2);
  auto* const field = m_window.control().outliner().findChild<QLineEdit*>();
  QVERIFY2(field && field->isVisible(), "F2 opens a field");
  field->selectAll();
  m_user.type(*field, "mug");
  m_user.press_key_in(*field, Qt::Key_Return);
  wait_for("mug");
  QVERIFY(m_document.history().steps.back() == "rename \"cup\"");
  m_user.look("renamed");
}

void Hour::collect() {
  m_user.press_key(Qt::Key_Slash);
  QLineEdit& search = m_window.control().search();
  m_user.type(search, "apple");
  m_user.press_key_in(search, Qt::Key_Return);
  QCOMPARE(m_document.selection().objects.size(), size_t{40});
  search.clear();
  m_user.press_key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  auto* const field = m_window.control().outliner().findChild<QLineEdit*>();
  QVERIFY(field && field->isVisible());
  field->selectAll();
  m_user.type(*field, "apples");
  m_user.press_key_in(*field, Qt::Key_Return);
  QTRY_VERIFY_WITH_TIMEOUT(m_document.looks().collections.find("apples"), kPatienceMs);
  m_document.select({});
  QVERIFY(m_user.wait());
  m_window.control().outliner().scrollToTop();
  m_user.look("collection");
}

// --- files -------------------------------------------------------------------------------------

void Hour::save_and_reopen() {
  const QString file = m_folder + "/hour.glb";
  QFile::remove(file);
  const std::string before = names_in(*m_document.snapshot())(m_document.snapshot()->objects[3].id);
  const Pose mug = m_user.object("mug").pose;
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_S, Qt::ControlModifier); },
                     [&](QWidget&) {
                       m_user.look("save_dialog");
                       enter_file(file);
                     });
  QVERIFY(QTest::qWaitFor([&] { return QFile::exists(file); }, kPatienceMs));
  QVERIFY(m_user.wait());
  QVERIFY(!m_document.is_modified());
  m_user.press_key(Qt::Key_N, Qt::ControlModifier);
  QVERIFY(m_user.wait());
  QVERIFY(m_document.snapshot()->objects.empty());
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_O, Qt::ControlModifier); },
                     [&](QWidget&) { enter_file(file); });
  wait_for("mug");
  QVERIFY(m_user.object("mug").pose.translation == mug.translation);
  QVERIFY(m_document.snapshot()->objects[3]->name == before);
  QCOMPARE(m_document.looks().collections.find("apples")->objects.size(), size_t{40});
  m_user.look("reopened");
}

void Hour::export_and_render() {
  const QString mesh = m_folder + "/hour.obj", picture = m_folder + "/hour.png";
  QFile::remove(mesh), QFile::remove(picture);
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_E, Qt::ControlModifier); },
                     [&](QWidget&) {
                       m_user.look("export_dialog");
                       enter_file(mesh);
                     });
  QVERIFY(QTest::qWaitFor([&] { return QFile::exists(mesh); }, kPatienceMs));
  QVERIFY(m_user.wait());
  m_user.with_dialog([&] { m_user.press_key(Qt::Key_P, Qt::ControlModifier); },
                     [&](QWidget& dialog) {
                       const QList<QSpinBox*> sizes = dialog.findChildren<QSpinBox*>();
                       QCOMPARE(sizes.size(), qsizetype{2});
                       sizes[0]->setValue(320), sizes[1]->setValue(200);
                       dialog.findChild<QComboBox*>()->setCurrentIndex(0);
                       m_user.look("picture_dialog");
                       enter_file_once_asked(picture);
                       QTest::mouseClick(
                           dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save),
                           Qt::LeftButton);
                     });
  QVERIFY(QTest::qWaitFor([&] { return QFile::exists(picture); }, kPatienceMs));
  QVERIFY(QTest::qWaitFor([&] { return m_window.message_bar().isVisible(); }, kPatienceMs));
  m_user.look("picture_written");
}

QString text_of(const QWidget& widget) {
  if (const auto* const label = qobject_cast<const QLabel*>(&widget))
    return label->wordWrap() || label->textFormat() == Qt::RichText ? QString() : label->text();
  const auto* const button = qobject_cast<const QAbstractButton*>(&widget);
  return button ? button->text() : QString();
}

}  // namespace

QStringList cut_off_texts(QWidget& window) {
  QStringList out;
  for (const QWidget* const widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    const QString text = text_of(*widget);
    const bool hint = widget->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
    if (!text.isEmpty() && !hint && widget->width() + 1 < widget->minimumSizeHint().width())
      out << text;
    const auto* const tabs = qobject_cast<const QTabBar*>(widget);
    for (int i = 0; tabs && i < tabs->count(); ++i)
      if (tabs->tabRect(i).width() < tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)))
        out << tabs->tabText(i);
  }
  return out;
}

void write_hour_models(const QString& folder) {
  const QString kitchen = folder + "/kitchen", library = folder + "/library";
  QVERIFY(QDir().mkpath(kitchen) && QDir().mkpath(library));
  std::vector<Aabb> shelf = shelf_boxes();
  for (Aabb& box : shelf) box = {1000 * box.lower, 1000 * box.upper};
  write_boxes((library + "/shelf.obj").toStdString(), shelf);
  write_boxes((library + "/book.obj").toStdString(), {{{-20, -80, 0}, {20, 80, 220}}});
  write_boxes((kitchen + "/tray.obj").toStdString(), {{{-0.45, -0.35, 0}, {0.45, 0.35, 0.02}}});
  const QString all = folder + "/breakfast";
  QProcess demo;
  demo.start(TRIVET_PROGRAM,
             {"demo", "breakfast", "-o", all + "/breakfast.glb", "--export", all, "--quiet"});
  QVERIFY(demo.waitForFinished(kPatienceMs));
  QCOMPARE(demo.exitCode(), 0);
  for (const char* const name : {"apple", "cup", "plate", "teapot"})
    QVERIFY(QFile::copy(all + "/" + name + ".glb", kitchen + "/" + name + ".glb"));
}

void work_an_hour(Document& document, MainWindow& window, User& user, const QString& folder) {
  Hour hour(document, window, user, folder);
  for (const auto step :
       {&Hour::import_folders, &Hour::put_shelf, &Hour::put_book_into_shelf,
        &Hour::put_ten_in_a_row, &Hour::put_forty_apples, &Hour::push_and_turn, &Hour::type_numbers,
        &Hour::rename, &Hour::collect, &Hour::save_and_reopen, &Hour::export_and_render}) {
    (hour.*step)();
    if (QTest::currentTestFailed()) {
      user.look("failed");
      return;
    }
  }
}

}  // namespace trivet::edit::test
