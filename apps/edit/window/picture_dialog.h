// A picture of what a view shows, in full quality: soft shadows, no overlays.
#pragma once

#include <QObject>
#include <QProgressBar>
#include <atomic>
#include <thread>

#include "gpu/live_scene.h"
#include "gpu/picture.h"

class QWidget;

namespace trivet::edit {

/// Asks for the size and the file, then makes the picture on a thread of its own, with progress.
/// @return in a message what became of it, through `done(ok, text)` on the caller's thread.
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
/// Nothing: cancelled.
std::optional<PictureWish> ask_for_picture(QWidget* parent, const QString& folder);

}  // namespace trivet::edit
