// Draws the views on a thread of its own, so that windows never wait for slow graphics.
#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include "gpu/live/scene.h"

namespace trivet::edit {

/// Drawing request of a view. Of several waiting for one view, only the last is drawn.
struct PaintRequest {
  int view = 0;
  quint64 number = 0;  // returned with the picture
  LiveScene scene;
  LiveCamera camera;
  LiveOptions options;
};

class Painter : public QObject {
  Q_OBJECT

 public:
  explicit Painter(QObject* parent = nullptr);
  ~Painter() override;

  void paint(PaintRequest request);
  /// Renderer in use; empty until the first picture.
  QString device() const { return m_device; }

 Q_SIGNALS:
  /// @param whole  of drafts: the next one takes as long. Otherwise it reuses, or is reused by,
  ///   others: in another resolution all of it would have to be drawn again.
  void painted(int view, quint64 number, const QImage& image, double milliseconds, bool whole);
  /// Drawing is impossible: no graphics driver is available.
  void failed(const QString& why);

 private:
  void run();
  std::optional<PaintRequest> next();

  std::mutex m_mutex;  // guards the members below
  std::condition_variable m_wake;
  std::map<int, PaintRequest> m_waiting;  // by view
  std::deque<int> m_order;
  bool m_stop = false;
  QString m_device;
  std::thread m_thread;
};

}  // namespace trivet::edit
