#include "apps/edit_hour/dragging.h"

#include <QDropEvent>
#include <QMimeData>

namespace trivet::edit::test {
namespace {

/// Scrolled to, so that it is seen.
QModelIndex shown_asset(AssetList& list, const QString& name) {
  const QList<QListWidgetItem*> found = list.findItems(name, Qt::MatchExactly);
  if (found.isEmpty()) qFatal("there is no model \"%s\"", qPrintable(name));
  list.scrollToItem(found.front());
  list.setCurrentItem(found.front());
  return list.currentIndex();
}

}  // namespace

void send_drop(QWidget& widget, QMimeData* data, const QPoint& at) {
  const std::unique_ptr<QMimeData> owned(data);
  for (QWidget* to = &widget; to; to = to->parentWidget()) {
    if (!to->acceptDrops()) continue;
    const QPoint here = to->mapFromGlobal(widget.mapToGlobal(at));
    QDragEnterEvent enter(here, Qt::CopyAction, data, Qt::LeftButton, {});
    QApplication::sendEvent(to, &enter);
    if (!enter.isAccepted()) continue;
    QDropEvent drop(here, Qt::CopyAction, data, Qt::LeftButton, {});
    QApplication::sendEvent(to, &drop);
    return;
  }
  QFAIL("nowhere can it be dropped");
}

bool all_made(AssetBrowser& assets, int count) {
  int made = 0;
  for (int i = 0; i < assets.list().count(); ++i)
    made +=
        assets.thumbnails().find(assets.list().item(i)->data(Qt::UserRole).toString()) != nullptr;
  return made > 0 && made == (count > 0 ? count : assets.list().count());
}

void double_click_asset(MainWindow& window, const QString& name) {
  AssetList& list = window.assets().list();
  const QPoint at = list.visualRect(shown_asset(list, name)).center();
  QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, at);
}

void drag_asset(MainWindow& window, User& user, const QString& name, WindowKind kind,
                const Vec3& world) {
  AssetList& list = window.assets().list();
  const QModelIndex index = shown_asset(list, name);
  const QPoint at = user.pixel(kind, world);
  QVERIFY2(window.view(kind).rect().contains(at), "the place is beside the view");
  send_drop(window.view(kind), list.model()->mimeData({index}), at);
}

}  // namespace trivet::edit::test
