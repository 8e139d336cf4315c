// Pictures and sizes of models' files, made on a thread of their own and kept in the user's cache.
#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/sentence.h"
#include "core/base/types.h"
#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet::edit {

/// Size and time of a file: another content has others.
struct FileStamp {
  qint64 bytes = -1, modified_ms = 0;
  static FileStamp of(const QString& file);
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Content of a model file, without taking it into the scene.
struct AssetInfo {
  FileStamp stamp;  // when it was read
  QImage picture;   // square, transparent around the model; null: not at hand, or there is an error
  Sentence error;
  Vec3 size = Vec3::Zero();  // of its box, in the file's units and axes
  double metres = 1;         // per unit: stated by the file, else likely by its size
  QString unit;              // "cm": a guess; empty: the file states it
  UpAxis up = UpAxis::Z;     // stated by the file, else likely by its shape
  bool states_up = false;
  std::vector<Sentence> notes;  // on what was left out
};

class AssetThumbnails : public QObject {
  Q_OBJECT

 public:
  /// @param cache  folder, made when the first picture is; empty: none are kept.
  /// @param limits  of reading a model.
  explicit AssetThumbnails(QString cache, ImportLimits limits = {}, QObject* parent = nullptr);
  /// These limits, or less: for folders, of which a single large model may not hold up the others.
  static ImportLimits quick(ImportLimits limits);
  /// Stops what reads a model.
  ~AssetThumbnails() override;

  /// Lists the models in the folder and below: listed(). An older list that is not done is given
  /// up.
  void list(const QString& folder);
  /// Makes what is not known yet, the first ones first, and the pictures of what is `seen`; those
  /// of the `rest` go into the cache alone. What was wanted before is forgotten.
  void want(const QStringList& seen, const QStringList& rest);
  /// Null until made(). Pictures are at hand of what was seen last.
  const AssetInfo* find(const QString& file) const;
  /// False if the file has changed since it was read, or is not known.
  bool is_current(const QString& file) const;
  /// It is read again when it is wanted.
  void forget(const QString& file);

  /// "*.obj", "*.glb", ...
  static const QStringList& patterns();

 Q_SIGNALS:
  void listed(const QString& folder, const QStringList& files);
  void made(const QString& file);
  void dropped(const QString& file);  // its picture

 private:
  void run();
  void take(const QString& file, AssetInfo info);
  void hold(const QStringList& seen);
  AssetInfo info_of(const QString& file) const;
  AssetInfo made_of(const QString& file) const;
  QString cached_file(const QString& file, const FileStamp& stamp) const;
  void keep(const QString& cached, const AssetInfo& info) const;

  QString m_cache;
  ImportLimits m_limits;
  QHash<QString, AssetInfo> m_known;
  QSet<QString> m_in_sight;
  QStringList m_held;  // with pictures, the last seen at the end

  std::atomic<bool> m_stop = false, m_lists_another = false;
  std::mutex m_mutex;  // guards the members below
  std::condition_variable m_wake;
  std::optional<QString> m_folder;
  std::deque<QString> m_wanted;
  std::thread m_thread;
};

}  // namespace trivet::edit
