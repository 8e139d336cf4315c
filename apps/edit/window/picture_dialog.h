// High-quality picture of a view: soft shadows, no overlays.
#pragma once

#include <QObject>
#include <QProgressBar>
#include <atomic>
#include <thread>

#include "gpu/live/scene.h"
#include "gpu/picture/picture.h"

class QWidget;

namespace trivet::edit {

/// Asks for size and file, then renders on a thread of its own, with progress.
/// Reports the result by `done(ok, text)` on the caller's thread.
class PictureJob : public QObject {
  Q_OBJECT

 public:
  PictureJob(LiveScene scene, Camera camera, PictureOptions options, const QString& file,
             QObject* parent);
  ~PictureJob() override;
  void cancel() { m_cancelled = true; }

 Q_SIGNALS:
  void progressed(int percent);
  void done(bool ok, const QString& text);

 private:
  void run();
  Image rendered(const PictureScene& picture);

  LiveScene m_scene;
  Camera m_camera;
  PictureOptions m_options;
  QString m_file;
  std::atomic<bool> m_cancelled = false;
  std::thread m_thread;
};

struct PictureWish {
  QString file;
  int width = 1920, height = 1080, samples = 32;
  bool transparent = false;
};
/// Nullopt: cancelled.
std::optional<PictureWish> ask_for_picture(QWidget* parent, const QString& folder);

}  // namespace trivet::edit
