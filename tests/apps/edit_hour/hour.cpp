#include "apps/edit_hour/hour.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QProcess>
#include <QTabBar>

#include "apps/edit_document/boxes.h"
#include "apps/edit_hour/hour_steps.h"
#include "support/textured_square.h"

namespace trivet::edit::test {
namespace {

/// Null: none is open.
QFileDialog* open_file_dialog() {
  for (QWidget* const widget : QApplication::topLevelWidgets())
    if (auto* const files = qobject_cast<QFileDialog*>(widget); files && files->isVisible())
      return files;
  return nullptr;
}

QString text_of(const QWidget& widget) {
  if (const auto* const label = qobject_cast<const QLabel*>(&widget))
    return label->wordWrap() || label->textFormat() == Qt::RichText ? QString() : label->text();
  const auto* const button = qobject_cast<const QAbstractButton*>(&widget);
  return button ? button->text() : QString();
}

// Red, green, blue and white, a quarter of the image each.
std::string four_colours() {
  constexpr int kSide = 64;
  Image image{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int quarter = 2 * (y / (kSide / 2)) + x / (kSide / 2);
      for (int channel = 0; channel < 3; ++channel)
        image.rgba.push_back(quarter == 3 || quarter == channel ? 230 : 10);
      image.rgba.push_back(255);
    }
  return encode_png(image);
}

}  // namespace

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
  QFile poster(kitchen + "/poster.gltf"), picture(kitchen + "/c.png");
  QVERIFY(poster.open(QIODevice::WriteOnly) && picture.open(QIODevice::WriteOnly));
  poster.write(trivet::testing::square_json().dump().c_str());
  picture.write(QByteArray::fromStdString(four_colours()));
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
        &Hour::rename, &Hour::collect, &Hour::save_and_reopen, &Hour::export_and_render,
        &Hour::put_textured, &Hour::lay_out_in_a_circle, &Hour::paint, &Hour::show_and_hide,
        &Hour::look_around, &Hour::copy_one_by_one}) {
    (hour.*step)();
    if (QTest::currentTestFailed()) {
      user.look("failed");
      return;
    }
  }
}

}  // namespace trivet::edit::test
