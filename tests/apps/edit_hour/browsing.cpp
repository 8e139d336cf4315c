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

QListWidgetItem* item_of(AssetBrowser& assets, const QString& name) {
  const auto found = assets.list().findItems(name, Qt::MatchExactly);
  return found.isEmpty() ? nullptr : found.front();
}

/// The window answers while models are read.
void list_models(AssetBrowser& assets, User& user, const QString& folder) {
  QElapsedTimer timer;
  qint64 longest = 0;
  assets.add_folder(folder);
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
}

/// In the unit of its folder: by a double click into the hand, dragged to where it is dropped.
void put_bricks(Document& document, MainWindow& window, User& user) {
  double_click_asset(window, "brick");
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("brick"), kPatienceMs);
  QVERIFY(user.wait());
  QCOMPARE(user.object("brick").scale, 0.001);
  QVERIFY(window.toolbox().in_hand() == "brick");
  user.click(WindowKind::Perspective, Vec3::Zero());
  QVERIFY(user.wait());
  QVERIFY(user.object("brick").state == ObjectState::Stable);
  drag_asset(window, user, "brick", WindowKind::ThreeView, Vec3(0.13, 0, 0));
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("brick_2"), kPatienceMs);
  QVERIFY(QTest::qWaitFor([&] { return user.object("brick_2").placed; }, kPatienceMs));
  QVERIFY(std::abs(user.object("brick_2").pose.translation.x() - 0.13) < 0.02);
  QVERIFY(user.wait());
}

}  // namespace

void browse_models(Document& document, MainWindow& window, User& user, const QString& folder) {
  write_models(folder);
  document.new_scene();
  QVERIFY(user.wait());
  user.press_key(Qt::Key_M);
  AssetBrowser& assets = window.assets();
  QVERIFY(QTest::qWaitFor([&] { return assets.isVisible(); }, kPatienceMs));
  list_models(assets, user, folder);
  auto* const unit = assets.findChild<QComboBox*>("asset unit");
  unit->setCurrentIndex(unit->findData(0.001));
  put_bricks(document, window, user);
  // A file that has changed is measured again; the unit is the one of the double click.
  unit->setCurrentIndex(0);
  write_boxes((folder + "/brick.obj").toStdString(), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.21}}});
  double_click_asset(window, "brick");
  unit->setCurrentIndex(unit->findData(0.0254));
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("brick_3"), kPatienceMs);
  QVERIFY(user.wait());
  QCOMPARE(user.object("brick_3").scale, 1.0);
  // The axis of the nearest folder for which one was chosen, whatever is likely.
  FolderChoice{0.0254, UpAxis::Y}.remember(folder);
  double_click_asset(window, "crate");
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("crate"), kPatienceMs);
  QVERIFY(user.wait());
  QVERIFY(user.object("crate").up == UpAxis::Y);
  FolderChoice{0, UpAxis::Z}.remember(folder + "/below");
  double_click_asset(window, "crate");
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("crate_2"), kPatienceMs);
  QVERIFY(user.wait());
  QVERIFY(user.object("crate_2").up == UpAxis::Z);
  double_click_asset(window, "bad");
  QTRY_VERIFY_WITH_TIMEOUT(window.message_bar().isVisible(), kPatienceMs);
  QVERIFY(user.wait());
  user.look("assets_used");
  user.press_key(Qt::Key_M);
  document.go_to_step(0);
  QVERIFY(user.wait());
}

namespace {

/// A model's file, and what is known of it by a new AssetThumbnails each time.
class Brick {
 public:
  explicit Brick(const QString& folder) : file(folder + "/brick.obj"), m_cache(folder + "/cache") {
    limits.max_seconds = kPatienceMs / 1000.0;  // by the clock
  }

  void write(double height) { write_boxes(file.toStdString(), {{{-1, -1, 0}, {1, 1, height}}}); }
  void set_time(const QDateTime& when) {
    QFile opened(file);
    QVERIFY(opened.open(QIODevice::ReadWrite));
    QVERIFY(opened.setFileTime(when, QFileDevice::FileModificationTime));
  }
  AssetInfo read(bool seen = true) {
    AssetThumbnails thumbnails(m_cache, limits);
    seen ? thumbnails.want({file}, {}) : thumbnails.want({}, {file});
    const bool made =
        QTest::qWaitFor([&] { return thumbnails.find(file) != nullptr; }, kPatienceMs);
    return made && thumbnails.is_current(file) ? *thumbnails.find(file) : AssetInfo();
  }

  QString file;
  ImportLimits limits;

 private:
  QString m_cache;
};

}  // namespace

void keep_thumbnails(const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  Brick brick(folder);
  brick.write(2);
  const AssetInfo first = brick.read();
  QCOMPARE(first.size.z(), 2.0);
  QVERIFY(!first.picture.isNull());
  // Other content of the same size and time is not noticed: the kept one is shown.
  const QDateTime time = QFileInfo(brick.file).lastModified();
  brick.write(3);
  brick.set_time(time);
  QCOMPARE(brick.read().size.z(), 2.0);
  brick.set_time(time.addSecs(2));
  const AssetInfo second = brick.read();
  QCOMPARE(second.size.z(), 3.0);
  QVERIFY(second.picture != first.picture);
  // An asset out of sight has its size, and its picture is in the cache alone.
  const AssetInfo unseen = brick.read(false);
  QCOMPARE(unseen.size.z(), 3.0);
  QVERIFY(unseen.picture.isNull());
}

void forget_errors(const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  Brick brick(folder);
  brick.write(4);
  brick.limits.importer = folder.toStdString() + "/none";
  const AssetInfo refused = brick.read();
  QVERIFY(refused.picture.isNull());
  const QString why = QString::fromStdString(in_english(refused.error));
  QVERIFY2(why.contains("none"), qPrintable(why));
  brick.limits.importer.clear();
  const AssetInfo now = brick.read();
  QVERIFY2(!now.picture.isNull() && now.error.empty(), in_english(now.error).c_str());
  QCOMPARE(now.size.z(), 4.0);
  write_text(brick.file, "v 0 0\nf 1 2 3\n");
  const AssetInfo bad = brick.read();
  QVERIFY(bad.picture.isNull());
  const QString fault = QString::fromStdString(in_english(bad.error));
  QVERIFY2(fault.contains("brick.obj"), qPrintable(fault));
}

// A scene is opened; models are imported.
void drop_files(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QString box = folder + "/box.obj", scene = folder + "/scene.glb";
  write_boxes(box.toStdString(), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.1}}});
  document.new_scene();
  QVERIFY(user.wait());
  user.drop({box}, [&](QWidget& dialog) {
    auto* const done = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    user.click_in(*done, {5, 5});
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
