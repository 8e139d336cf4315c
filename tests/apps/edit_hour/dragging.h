// Models of the asset browser, and drags between windows: what the window system would send.
#pragma once

#include <QMimeData>

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

/// Takes `data`. Sends the drop to the widget, and to those around it until one takes it.
void send_drop(QWidget& widget, QMimeData* data, const QPoint& at);

/// True once that many of the listed models, 0: all, were read.
bool all_made(AssetBrowser& assets, int count = 0);

void double_click_asset(MainWindow& window, const QString& name);
/// From the asset browser to a world point in a view.
void drag_asset(MainWindow& window, User& user, const QString& name, WindowKind kind,
                const Vec3& world);

}  // namespace trivet::edit::test
