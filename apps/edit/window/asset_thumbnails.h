// Pictures and sizes of models' files, made on a thread of their own and kept in the user's cache.
#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QStringList>
#include <QWaitCondition>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/base/types.h"
#include "core/io/model.h"

namespace trivet::edit {

/// Content of a model file, without taking it into the scene.
struct AssetInfo {
  QImage picture;  // square, transparent around the model; null: `error` says why
  QString error;
  Vec3 size = Vec3::Zero();  // of its box, in the file's units and axes
  double metres = 1;         // per unit: stated by the file, else likely by its size
  QString unit;              // "cm": a guess; empty: the file states it
};

class AssetThumbnails : public QObject {
  Q_OBJECT

 public:
  /// @param cache  folder, made when the first picture is; empty: none are kept.
  explicit AssetThumbnails(QString cache, ImportLimits limits = {}, QObject* parent = nullptr);
  /// Waits for the model that is being read, for some seconds at most.
  ~AssetThumbnails() override;

  /// Lists the models in the folder and below: listed().
  void list(const QString& folder);
  /// Makes what is not known yet, the first ones first; what was wanted before is forgotten.
  void want(QStringList files);
  /// Null until made().
  const AssetInfo* find(const QString& file) const;

  /// "*.obj", "*.glb", ...
  static const QStringList& patterns();

 Q_SIGNALS:
  void listed(const QString& folder, const QStringList& files);
  void made(const QString& file);

 private:
  void run();
  AssetInfo info_of(const QString& file) const;
  AssetInfo made_of(const QString& file) const;
  QString cached_file(const QString& file) const;
  void keep(const QString& file, const AssetInfo& info) const;

  QString m_cache;
  ImportLimits m_limits;
  QHash<QString, AssetInfo> m_known;

  std::atomic<bool> m_stop = false;
  std::mutex m_mutex;  // guards the members below
  std::condition_variable m_wake;
  std::deque<QString> m_folders, m_wanted;
  std::thread m_thread;
};

}  // namespace trivet::edit
