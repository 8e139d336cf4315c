#include "apps/edit/window/painter.h"

#include <QElapsedTimer>
#include <QMetaObject>

#include "core/base/error.h"
#include "gpu/live/view.h"

namespace trivet::edit {
namespace {

/// Shares the pixels without copying.
QImage qt_image(Image image) {
  auto* const kept = new Image(std::move(image));
  return QImage(
      kept->rgba.data(), kept->width, kept->height, 4 * kept->width, QImage::Format_RGBX8888,
      [](void* it) { delete static_cast<Image*>(it); }, kept);
}

}  // namespace

Painter::Painter(QObject* parent) : QObject(parent), m_thread([this] { run(); }) {}

Painter::~Painter() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
  }
  m_wake.notify_all();
  m_thread.join();
}

void Painter::paint(PaintRequest request) {
  {
    const std::lock_guard lock(m_mutex);
    const int view = request.view;
    if (m_waiting.insert_or_assign(view, std::move(request)).second) m_order.push_back(view);
  }
  m_wake.notify_all();
}

std::optional<PaintRequest> Painter::next() {
  std::unique_lock lock(m_mutex);
  m_wake.wait(lock, [this] { return m_stop || !m_order.empty(); });
  if (m_stop) return std::nullopt;
  auto node = m_waiting.extract(m_order.front());
  m_order.pop_front();
  return std::move(node.mapped());
}

void Painter::run() {
  try {
    EglContext context;
    LiveView live(context);
    const QString device = QString::fromStdString(context.description());
    QMetaObject::invokeMethod(this, [this, device] { m_device = device; });
    while (const std::optional<PaintRequest> request = next()) {
      QElapsedTimer timer;
      timer.start();
      const QImage image = qt_image(live.draw(request->scene, request->camera, request->options));
      const LiveView::Work& work = live.work();
      const bool whole = request->options.coarse || !(work.still_kept || work.still_reused);
      Q_EMIT painted(request->view, request->number, image, 1e-6 * double(timer.nsecsElapsed()),
                     whole);
    }
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    while (next()) continue;
  }
}

}  // namespace trivet::edit
