#include "apps/edit_hour/browsing.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>

#include "apps/edit_document/boxes.h"
#include "apps/edit_hour/dragging.h"
#include "support/effort.h"

namespace trivet::edit::test {
namespace {

void write_text(const QString& file, const QByteArray& text) {
  QFile out(file);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write(text);
}

/// A box of 100 x 100 x 200 mm, a box of 0.4 m, and two files that are no models.
void write_models(const QString& folder) {
  QVERIFY(QDir().mkpath(folder + "/below"));
  write_boxes((folder + "/brick.obj").toStdString(), {{{-50, -50, 0}, {50, 50, 200}}});
  write_boxes((folder + "/below/crate.obj").toStdString(), {{{-0.2, -0.2, 0}, {0.2, 0.2, 0.4}}});
  write_text(folder + "/bad.obj", "v 0 0\nf 1 2 3\n");
  write_text(folder + "/bad.glb", QByteArray(2000, '\x07'));
  write_text(folder + "/notes.txt", "not a model");
}

bool all_made(const AssetBrowser& assets, int count) {
  int made = 0;
  const AssetList& list = const_cast<AssetBrowser&>(assets).list();
  for (int i = 0; i < list.count(); ++i)
    made += assets.thumbnails().find(list.item(i)->data(Qt::UserRole).toString()) != nullptr;
  return made == count;
}

QListWidgetItem* item_of(AssetBrowser& assets, const QString& name) {
  const auto found = assets.list().findItems(name, Qt::MatchExactly);
  return found.isEmpty() ? nullptr : found.front();
}

}  // namespace

void browse_models(Document& document, MainWindow& window, User& user, const QString& folder) {
  write_models(folder);
  document.new_scene();
  QVERIFY(user.wait());
  user.press_key(Qt::Key_M);
  AssetBrowser& assets = window.assets();
  QVERIFY(QTest::qWaitFor([&] { return assets.isVisible(); }, kPatienceMs));
  assets.add_folder(folder);
  // The window answers while models are read.
  QElapsedTimer timer;
  qint64 longest = 0;
  QVERIFY(QTest::qWaitFor(
      [&] {
        if (timer.isValid()) longest = std::max(longest, timer.restart());
        timer.start();
        return all_made(assets, 4);
      },
      kPatienceMs));
  // A second where nothing else runs: needs TRIVET_TEST_EFFORT=2.
  std::printf("assets: the window answered within %lld ms\n", longest);
  QVERIFY(longest < (trivet::test::with_effort(100) < 200 ? 20000 : 1000));
  user.look("assets");
  QVERIFY(!item_of(assets, "notes"));
  QVERIFY(item_of(assets, "bad")->toolTip().contains("bad."));
  QVERIFY(item_of(assets, "brick")->toolTip().contains("likely cm"));
  user.type(assets.search(), "cra");
  QVERIFY(item_of(assets, "brick")->isHidden() && !item_of(assets, "crate")->isHidden());
  assets.search().clear();
  // A double click takes it in hand, in the unit of its folder.
  auto* const unit = assets.findChild<QComboBox*>("asset unit");
  unit->setCurrentIndex(unit->findData(0.001));
  double_click_asset(window, "brick");
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("brick"), kPatienceMs);
  QVERIFY(user.wait());
  QCOMPARE(user.object("brick").scale, 0.001);
  QVERIFY(window.toolbox().in_hand() == "brick");
  user.click(WindowKind::Perspective, Vec3::Zero());
  QVERIFY(user.wait());
  QVERIFY(user.object("brick").state == ObjectState::Stable);
  // One that is dragged lies where it is dropped.
  drag_asset(window, user, "brick", WindowKind::ThreeView, Vec3(0.13, 0, 0));
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("brick_2"), kPatienceMs);
  QVERIFY(QTest::qWaitFor([&] { return user.object("brick_2").placed; }, kPatienceMs));
  QVERIFY(std::abs(user.object("brick_2").pose.translation.x() - 0.13) < 0.02);
  // A file that has changed is measured again.
  unit->setCurrentIndex(0);
  write_boxes((folder + "/brick.obj").toStdString(), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.21}}});
  double_click_asset(window, "brick");
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("brick_3"), kPatienceMs);
  QCOMPARE(user.object("brick_3").scale, 1.0);
  QVERIFY(user.wait());
  double_click_asset(window, "bad");
  QTRY_VERIFY_WITH_TIMEOUT(window.message_bar().isVisible(), kPatienceMs);
  QVERIFY(user.wait());
  user.look("assets_used");
  user.press_key(Qt::Key_M);
  document.go_to_step(0);
  QVERIFY(user.wait());
}

void keep_thumbnails(const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString file = folder + "/brick.obj", cache = folder + "/cache";
  const auto box = [&](double height) {
    write_boxes(file.toStdString(), {{{-1, -1, 0}, {1, 1, height}}});
  };
  ImportLimits limits;
  limits.max_seconds = kPatienceMs / 1000;  // by the clock
  AssetInfo info;
  const auto read = [&](const QStringList& seen, const QStringList& rest) {
    AssetThumbnails thumbnails(cache, limits);
    thumbnails.want(seen, rest);
    QVERIFY2(QTest::qWaitFor([&] { return thumbnails.find(file) != nullptr; }, kPatienceMs),
             "made");
    QVERIFY(thumbnails.is_current(file));
    info = *thumbnails.find(file);
  };
  box(2);
  read({file}, {});
  QCOMPARE(info.size.z(), 2.0);
  QVERIFY(!info.picture.isNull());
  const QImage first = info.picture;
  // Other content of the same size and time is not noticed: the kept one is shown.
  const QDateTime time = QFileInfo(file).lastModified();
  const auto set_time = [&](const QDateTime& when) {
    QFile opened(file);
    QVERIFY(opened.open(QIODevice::ReadWrite));
    QVERIFY(opened.setFileTime(when, QFileDevice::FileModificationTime));
  };
  box(3);
  set_time(time);
  read({file}, {});
  QCOMPARE(info.size.z(), 2.0);
  set_time(time.addSecs(2));
  read({file}, {});
  QCOMPARE(info.size.z(), 3.0);
  QVERIFY(info.picture != first);
  // Of what is not in sight there is the size, the picture is in the cache alone.
  read({}, {file});
  QCOMPARE(info.size.z(), 3.0);
  QVERIFY(info.picture.isNull());
  // An error of this machine is not kept.
  box(4);
  limits.importer = folder.toStdString() + "/none";
  read({file}, {});
  QVERIFY(info.picture.isNull());
  QVERIFY2(info.error.contains("none"), qPrintable(info.error));
  limits.importer.clear();
  read({file}, {});
  QCOMPARE(info.size.z(), 4.0);
  QVERIFY2(!info.picture.isNull() && info.error.isEmpty(), qPrintable(info.error));
  write_text(file, "v 0 0\nf 1 2 3\n");
  read({file}, {});
  QVERIFY(info.picture.isNull());
  QVERIFY2(info.error.contains("brick.obj"), qPrintable(info.error));
}

void collect_objects(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString box = folder + "/box.obj";
  write_boxes(box.toStdString(), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.1}}});
  document.new_scene();
  for (const char* const name : {"a", "b", "c"}) {
    ImportModel model;
    model.file = box.toStdString();
    model.name = name;
    model.put = Pose{{}, Vec3(0.2 * (name[0] - 'a'), 0, 0.1)};
    document.import_model(model);
  }
  QVERIFY(user.wait());
  Outliner& outliner = window.control().outliner();
  const auto collection = [&](const char* name) { return document.looks().collections.find(name); };
  user.select("a");
  user.press_key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  auto* field = outliner.findChild<QLineEdit*>();
  QVERIFY2(field && field->isVisible(), "a new collection asks for its name");
  field->selectAll();
  user.type(*field, "set");
  user.press_key_in(*field, Qt::Key_Return);
  QTRY_VERIFY_WITH_TIMEOUT(collection("set"), kPatienceMs);
  // Dragged into it, and out of it.
  user.select("b");
  const auto drop = [&](const QString& onto) {
    QTreeWidgetItem* const item = outliner.findItems(onto, Qt::MatchExactly).front();
    send_drop(*outliner.viewport(),
              outliner.model()->mimeData(outliner.selectionModel()->selectedIndexes()),
              outliner.visualItemRect(item).center());
  };
  drop("set");
  QCOMPARE(collection("set")->objects.size(), size_t{2});
  QVERIFY(user.wait());
  user.look("collection");
  user.select("b");
  drop("Floor");
  QCOMPARE(collection("set")->objects.size(), size_t{1});
  user.select("b");
  drop("set");
  // What is found is selected once, though the tree shows it twice.
  window.control().search().setText("a");
  outliner.select_found();
  QCOMPARE(document.selection().objects, std::vector{document.snapshot()->find("a")->id});
  window.control().search().clear();
  // A click on it selects all of it; its menu hides it.
  document.select({});
  user.select("set");
  QCOMPARE(document.selection().objects.size(), size_t{2});
  const auto choose = [&](int entry) {
    QTreeWidgetItem* const item = outliner.findItems("set", Qt::MatchExactly).front();
    const QPoint at = outliner.visualItemRect(item).center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, outliner.viewport()->mapToGlobal(at));
    QApplication::sendEvent(outliner.viewport(), &event);
    auto* const menu = outliner.findChild<QMenu*>("collection menu");
    QVERIFY(menu && menu->isVisible());
    user.look("collection_menu");
    user.click_in(*menu, menu->actionGeometry(menu->actions()[entry]).center());
    QTest::qWait(50);
  };
  choose(2);
  QVERIFY(collection("set")->hidden);
  QVERIFY(document.selection().objects.empty());
  QVERIFY(user.wait());
  user.look("collection_hidden");
  choose(2);
  choose(3);
  QVERIFY(!collection("set")->hidden && collection("set")->not_selectable);
  choose(4);
  QVERIFY(user.wait());
  QVERIFY(user.object("a").locked && user.object("b").locked && !user.object("c").locked);
  choose(7);
  QVERIFY(!collection("set"));
  document.go_to_step(0);
  QVERIFY(user.wait());
}

// A scene is opened; models are imported.
void drop_files(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString box = folder + "/box.obj", scene = folder + "/scene.glb";
  write_boxes(box.toStdString(), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.1}}});
  document.new_scene();
  QVERIFY(user.wait());
  user.drop({box}, [&](QWidget& dialog) {
    user.click_in(*dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), {5, 5});
  });
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("box"), kPatienceMs);
  document.save_as(scene.toStdString());
  document.new_scene();
  QVERIFY(user.wait());
  auto* const data = new QMimeData;
  data->setUrls({QUrl::fromLocalFile(scene)});
  send_drop(window, data, window.rect().center());
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("box"), kPatienceMs);
  QVERIFY(user.wait());
  QVERIFY(!document.is_modified());
}

}  // namespace trivet::edit::test
