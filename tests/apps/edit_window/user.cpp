#include "apps/edit_window/user.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QToolBar>
#include <QTreeWidgetItemIterator>

#include "apps/edit/tools/picking.h"

namespace trivet::edit::test {
namespace {

constexpr int kDragSteps = 12, kStepMs = 15;

QWidget* open_dialog() {
  for (QWidget* const widget : QApplication::topLevelWidgets())
    if (widget->isVisible() && qobject_cast<QDialog*>(widget)) return widget;
  return nullptr;
}

}  // namespace

User::User(Document& document, MainWindow& window, const QString& pictures)
    : m_document(document), m_window(window), m_pictures(pictures) {
  m_pictures.mkpath(".");
}

void User::press_key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  QApplication::setActiveWindow(&m_window);  // no window manager does so
  ++m_effort.keys;
  QWidget* const focus = m_window.focusWidget();
  QTest::keyClick(focus ? focus : &m_window, key, modifiers);
}

void User::move_to(QWidget& widget, const QPoint& at) {
  QTest::mouseMove(m_window.windowHandle(), in_window(widget, at));
  QTest::qWait(kStepMs);
}

void User::press(QWidget& widget, const QPoint& at, Qt::MouseButton button) {
  move_to(widget, at);
  QTest::mousePress(m_window.windowHandle(), button, {}, in_window(widget, at));
}

void User::send_move(QWidget& widget, const QPoint& at) {
  QTest::mouseMove(m_window.windowHandle(), in_window(widget, at));
}

void User::release(QWidget& widget, const QPoint& at, Qt::MouseButton button) {
  QTest::mouseRelease(m_window.windowHandle(), button, {}, in_window(widget, at));
}

void User::click(QWidget& widget, const QPoint& at, Qt::KeyboardModifiers modifiers) {
  ++m_effort.clicks;
  move_to(widget, at);
  QTest::mouseClick(m_window.windowHandle(), Qt::LeftButton, modifiers, in_window(widget, at));
  QTest::qWait(kStepMs);
}

void User::drag(QWidget& widget, const QPoint& from, const QPoint& to) {
  ++m_effort.drags;
  move_to(widget, from);
  QTest::mousePress(m_window.windowHandle(), Qt::LeftButton, {}, in_window(widget, from));
  for (int i = 1; i <= kDragSteps; ++i) move_to(widget, from + (to - from) * i / kDragSteps);
  QVERIFY(m_document.wait_until_idle(kPatienceMs));  // the dragged object has followed
  QTest::mouseRelease(m_window.windowHandle(), Qt::LeftButton, {}, in_window(widget, to));
}

void User::click_in(QWidget& widget, const QPoint& at) {
  ++m_effort.clicks;
  QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
}

void User::type(QWidget& widget, const QString& text) {
  m_effort.keys += static_cast<int>(text.size());
  QTest::keyClicks(&widget, text);
}

void User::press_key_in(QWidget& widget, Qt::Key key, Qt::KeyboardModifiers modifiers) {
  ++m_effort.keys;
  QTest::keyClick(&widget, key, modifiers);
}

void User::choose(const QString& name) {
  QAction* const chosen = m_window.action(name);
  QMenuBar& bar = *m_window.menuBar();
  for (QAction* const title : bar.actions()) {
    if (!title->menu() || !title->menu()->actions().contains(chosen)) continue;
    click(bar, bar.actionGeometry(title).center());
    QVERIFY(QTest::qWaitFor([&] { return title->menu()->isVisible(); }, kPatienceMs));
    return click_in(*title->menu(), title->menu()->actionGeometry(chosen).center());
  }
  QFAIL(qPrintable("no menu has " + name));
}

QPoint User::pixel(WindowKind kind, const Vec3& world) {
  const auto px = m_window.view(kind).view().project(world);
  return px ? QPoint(static_cast<int>(std::lround(px->x())), static_cast<int>(std::lround(px->y())))
            : QPoint(-1, -1);
}

QPoint User::pixel_on(const std::string& name, WindowKind kind) {
  const auto snapshot = m_document.snapshot();
  const View view = m_window.view(kind).view();
  const QPoint centre = pixel(kind, object(name).centre_of_mass());
  QPoint best = centre;
  constexpr int kStepPx = 4, kRoomPx = 2;
  const auto is_seen = [&](const QPoint& at) {
    const auto seen = pick(*snapshot, view.ray(Vec2(at.x(), at.y())));
    return seen && seen->object && snapshot->find(*seen->object)->object->name == name;
  };
  for (int y = 0; y < view.height_px; y += kStepPx)
    for (int x = 0; x < view.width_px; x += kStepPx) {
      const QPoint at(x, y);
      if ((at - centre).manhattanLength() <= (best - centre).manhattanLength()) continue;
      const bool room = is_seen(at) && is_seen(at + QPoint(kRoomPx, kRoomPx)) &&
                        is_seen(at - QPoint(kRoomPx, kRoomPx)) &&
                        is_seen(at + QPoint(kRoomPx, -kRoomPx)) &&
                        is_seen(at - QPoint(kRoomPx, -kRoomPx));
      if (room) best = at;
    }
  return best;
}

void User::click(WindowKind kind, const Vec3& world) {
  click(m_window.view(kind), pixel(kind, world));
}

void User::drag(WindowKind kind, const Vec3& from, const Vec3& to) {
  drag(m_window.view(kind), pixel(kind, from), pixel(kind, to));
}

void User::take(const QString& tool) {
  auto* const bar = m_window.findChild<QToolBar*>("tools");
  click(*bar->widgetForAction(m_window.action(tool)));
}

void User::select(const std::string& name, Qt::KeyboardModifiers modifiers) {
  Outliner& outliner = m_window.control().outliner();
  for (QTreeWidgetItemIterator it(&outliner); *it; ++it) {
    if ((*it)->text(0).toStdString() != name) continue;
    outliner.scrollToItem(*it);
    click(*outliner.viewport(), outliner.visualItemRect(*it).center(), modifiers);
    return;
  }
  QFAIL(qPrintable(QString("no \"%1\" in the outliner").arg(QString::fromStdString(name))));
}

void User::show_tab(const QString& title) {
  auto* const tabs = m_window.control().findChild<QTabWidget*>();
  for (int i = 0; i < tabs->count(); ++i)
    if (tabs->tabText(i) == title)
      return click(*tabs->tabBar(), tabs->tabBar()->tabRect(i).center());
  QFAIL(qPrintable("no tab " + title));
}

bool User::wait() {
  const auto is_done = [this] {
    if (m_document.is_busy() || m_document.is_dragging()) return false;
    for (const WindowKind kind :
         {WindowKind::Perspective, WindowKind::ThreeView, WindowKind::Constraint}) {
      const SceneView& view = m_window.view(kind);
      if (view.isVisible() && !view.is_up_to_date()) return false;
    }
    return true;
  };
  QTest::qWait(2 * kStepMs);
  return QTest::qWaitFor(is_done, kPatienceMs);
}

bool User::wait_for_drag(const SceneView& view) {
  return m_document.wait_until_idle(kPatienceMs) && m_document.is_dragging() &&
         QTest::qWaitFor([&] { return view.shows_latest(); }, kPatienceMs);
}

QImage User::look(const QString& name) {
  QTest::qWait(4 * kStepMs);
  const QString file = QString("%1_%2.png").arg(++m_number, 2, 10, QChar('0')).arg(name);
  const QPoint corner = m_window.mapToGlobal(QPoint());
  const QImage image =
      m_window.screen()
          ->grabWindow(0, corner.x(), corner.y(), m_window.width(), m_window.height())
          .toImage();
  image.save(m_pictures.filePath(file));
  return image;
}

void User::import_model(const QString& file, const std::string& name,
                        const std::optional<Vec3>& put, bool fixed) {
  ImportModel model;
  model.file = file.toStdString();
  model.name = name;
  model.fixed = fixed;
  if (put) model.put = Pose{{}, *put};
  m_document.import_model(model);
  QVERIFY(wait());
  QVERIFY2(m_document.snapshot()->find(name), qPrintable(m_window.message_bar().text()));
  QCOMPARE(object(name).placed, put.has_value());
}

void User::enter_name(const QString& name) {
  auto* const field = m_window.control().outliner().findChild<QLineEdit*>();
  QVERIFY2(field && field->isVisible(), "there is a field for the name");
  field->selectAll();
  type(*field, name);
  press_key_in(*field, Qt::Key_Return);
}

void User::with_dialog(std::function<void()> open, std::function<void(QWidget&)> then) {
  QTimer timer;
  timer.setInterval(10 * kStepMs);
  QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
    QWidget* const dialog = open_dialog();
    if (!dialog) return;
    timer.stop();
    then(*dialog);
  });
  timer.start();
  open();
  // Non-modal dialogs are still open.
  QVERIFY(QTest::qWaitFor([&] { return !timer.isActive(); }, kPatienceMs));
}

// The dialog has read the files when it can import them.
void User::drop(const QStringList& files, std::function<void(QWidget&)> then) {
  const auto then_when_read = [&](QWidget& dialog) {
    auto* const buttons = dialog.findChild<QDialogButtonBox*>();
    QPushButton* const done = buttons ? buttons->button(QDialogButtonBox::Ok) : nullptr;
    QVERIFY(!done || QTest::qWaitFor([&] { return done->isEnabled(); }, kPatienceMs));
    then(dialog);
  };
  with_dialog(
      [&] {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files) urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter(m_window.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&m_window, &enter);
        QDropEvent event(m_window.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&m_window, &event);
      },
      then_when_read);
}

const Object& User::object(const std::string& name) {
  const ObjectSnapshot* const found = m_document.snapshot()->find(name);
  if (!found) qFatal("there is no \"%s\"", name.c_str());
  return *found->object;
}

}  // namespace trivet::edit::test
