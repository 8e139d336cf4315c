// Files dropped onto the window: what the import dialog tells of each, and what it remembers.
#include <signal.h>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QFile>
#include <QPushButton>
#include <QTableWidget>

#include "apps/edit/window/import_dialog.h"
#include "apps/edit_document/boxes.h"
#include "apps/edit_hour/browsing.h"
#include "apps/edit_hour/dragging.h"

namespace trivet::edit::test {
namespace {

constexpr int kModel = 0, kSize = 1, kUnit = 2, kScale = 3, kUp = 4, kNotes = 5;  // columns

/// The dialog's parts.
struct Import {
  explicit Import(QWidget& dialog)
      : table(*dialog.findChild<QTableWidget*>("models")),
        button(*dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)) {}

  void wait() {
    QVERIFY(QTest::qWaitFor([this] { return button.isEnabled(); }, kPatienceMs));
  }
  QComboBox& choice(int row, int column) {
    return *qobject_cast<QComboBox*>(table.cellWidget(row, column));
  }
  QString text(int row, int column) { return table.item(row, column)->text(); }

  QTableWidget& table;
  QPushButton& button;
};

/// A brick that stands along y, 100 x 200 x 100 mm; a crate of 0.4 m; a file that is no model.
QStringList write_files(const QString& folder) {
  QStringList files{folder + "/brick.obj", folder + "/crate.obj", folder + "/bad.obj"};
  write_boxes(files[0].toStdString(), {{{-50, 0, -50}, {50, 200, 50}}});
  write_boxes(files[1].toStdString(), {{{-0.2, -0.2, 0}, {0.2, 0.2, 0.4}}});
  QFile bad(files[2]);
  if (bad.open(QIODevice::WriteOnly)) bad.write("v 0 0\nf 1 2 3\n");
  return files;
}

}  // namespace

void import_files(Document& document, MainWindow& window, User& user, const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QStringList files = write_files(folder);
  document.new_scene();
  QVERIFY(user.wait());
  user.drop(files, [&](QWidget& dialog) {
    Import import(dialog);
    import.wait();
    user.look("import_dialog");
    QVERIFY2(import.text(0, kSize).contains("likely cm"), qPrintable(import.text(0, kSize)));
    QCOMPARE(import.choice(0, kUp).currentText(), QString("likely y"));
    QCOMPARE(import.choice(1, kUp).currentText(), QString("likely z"));
    QVERIFY2(import.text(2, kNotes).contains("bad.obj"), qPrintable(import.text(2, kNotes)));
    QVERIFY(!import.table.item(0, kModel)->icon().isNull());
    import.choice(0, kUnit).setCurrentIndex(import.choice(0, kUnit).findData(0.001));
    user.click_in(import.button, {5, 5});
  });
  QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find("crate"), kPatienceMs);
  QVERIFY(user.wait());
  QCOMPARE(user.object("brick").scale, 0.001);
  QVERIFY(user.object("brick").up == UpAxis::Y && user.object("crate").up == UpAxis::Z);
  QCOMPARE(user.object("crate").scale, 1.0);
  QVERIFY(!document.snapshot()->find("bad"));
  // The last choice among the folder's files counts: the brick's, when it comes alone.
  for (const char* const name : {"brick_2", "brick_3"}) {
    user.drop({files[0]}, [&](QWidget& dialog) {
      Import import(dialog);
      import.wait();
      QComboBox& unit = import.choice(0, kUnit);
      if (std::string(name) == "brick_2") unit.setCurrentIndex(unit.findData(0.0254));
      QCOMPARE(unit.currentData().toDouble(), 0.0254);
      user.click_in(import.button, {5, 5});
    });
    QTRY_VERIFY_WITH_TIMEOUT(document.snapshot()->find(name), kPatienceMs);
    QVERIFY(user.wait());
    QCOMPARE(user.object(name).scale, 0.0254);
  }
  // Changed afterwards, and back.
  user.select("brick");
  auto* const up = window.findChild<QComboBox*>("up");
  QVERIFY(up && up->currentIndex() == 0);
  user.press_key_in(*up, Qt::Key_Down);
  QTRY_VERIFY_WITH_TIMEOUT(user.object("brick").up == UpAxis::Z, kPatienceMs);
  document.go_to_step(0);
  QVERIFY(user.wait());
}

// The dialog is closed while a program reads a file, which would take 1,000 s.
void stop_reading(const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  const QStringList files = write_files(folder);
  const QString importer = folder + "/importer", number = folder + "/process";
  QFile program(importer);
  QVERIFY(program.open(QIODevice::WriteOnly));
  program.write("#!/bin/sh\necho $$ > " + number.toUtf8() + ".new\nmv " + number.toUtf8() +
                ".new " + number.toUtf8() + "\nexec sleep 1000\n");
  program.close();
  QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
  ImportLimits limits;
  limits.importer = importer.toStdString();
  limits.max_seconds = 1000;
  QElapsedTimer timer;
  {
    ImportDialog dialog(files, "", limits);
    dialog.show();
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(number); }, kPatienceMs));
    timer.start();
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
    QCOMPARE(dialog.result(), int{QDialog::Rejected});
  }
  QVERIFY(timer.elapsed() < kPatienceMs);
  QFile process(number);
  QVERIFY(process.open(QIODevice::ReadOnly));
  const int id = process.readAll().trimmed().toInt();
  QVERIFY(id > 0 && kill(id, 0) != 0 && errno == ESRCH);
}

}  // namespace trivet::edit::test
