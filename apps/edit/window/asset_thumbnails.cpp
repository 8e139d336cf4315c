#include "apps/edit/window/asset_thumbnails.h"

#include <sys/resource.h>

#include <QByteArray>
#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QMetaObject>
#include <QSaveFile>
#include <algorithm>
#include <functional>
#include <utility>

#include "apps/edit/document/words.h"
#include "apps/edit/window/units.h"
#include "core/base/arena.h"
#include "core/base/image.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/read_model.h"
#include "core/io/sentence_json.h"
#include "ops/files/report/model_info.h"
#include "raster/path/picture.h"

namespace trivet::edit {
namespace {

constexpr int kPixels = 160, kSamples = 8;
constexpr int kMostFiles = 5000;        // of a folder
constexpr int kMostLookedAt = 200'000;  // files and folders, for these
constexpr int kMostKept = 5000;         // in the cache: about 100 MB
constexpr qsizetype kMostHeld = 300;    // pictures in memory: 30 MB, unless more are in sight
constexpr double kMostSeconds = 10;
constexpr std::int64_t kMostTriangles = 5'000'000;
constexpr int kLeastUrgent = 19;  // of nice(): the window's threads come first
constexpr int kVersion = 3;       // of what is kept

QImage picture_of(const Model& model, UpAxis up, double metres, const std::atomic<bool>& stop) {
  const PictureMesh mesh = picture_mesh(model);
  PictureScene scene;
  scene.floor = false;
  scene.objects.push_back({&mesh, world_from_object({}, up, metres), std::nullopt});
  PictureOptions options;
  options.width = options.height = kPixels;
  options.samples = kSamples;
  options.background = {1, 1, 1, 0};
  PathOptions path;
  path.bounces = 1;
  path.cancel = &stop;
  Image image;
  in_arena(1, [&] { image = trace_picture(scene, std::nullopt, options, path); });
  return QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
}

// The oldest go.
void prune(const QString& cache) {
  const QFileInfoList kept = QDir(cache).entryInfoList({"*.png"}, QDir::Files, QDir::Time);
  for (qsizetype i = kMostKept; i < kept.size(); ++i) QFile::remove(kept[i].filePath());
}

bool is_model(const QFileInfo& file) {
  return file.isFile() && AssetThumbnails::patterns().contains("*." + file.suffix().toLower());
}

// One by one, so that it can be stopped where there are no models, too.
QStringList models_in(const QString& folder, const std::function<bool()>& is_stopped) {
  QStringList out;
  QDirIterator it(folder, QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot | QDir::Readable,
                  QDirIterator::Subdirectories);
  for (int i = 0; i < kMostLookedAt && it.hasNext() && out.size() < kMostFiles; ++i) {
    if (is_stopped()) break;
    it.next();
    if (is_model(it.fileInfo())) out << it.filePath();
  }
  out.sort(Qt::CaseInsensitive);
  return out;
}

}  // namespace

FileStamp FileStamp::of(const QString& file) {
  const QFileInfo now(file);
  return {now.size(), now.lastModified().toMSecsSinceEpoch()};
}

const QStringList& AssetThumbnails::patterns() {
  static const QStringList all = {"*.obj", "*.glb",  "*.gltf", "*.ply",   "*.stl", "*.fbx",
                                  "*.dae", "*.3ds",  "*.off",  "*.blend", "*.x3d", "*.step",
                                  "*.stp", "*.iges", "*.igs",  "*.brep"};
  return all;
}

AssetThumbnails::AssetThumbnails(QString cache, ImportLimits limits, QObject* parent)
    : QObject(parent), m_cache(std::move(cache)), m_limits(std::move(limits)) {
  if (m_limits.importer.empty()) m_limits.importer = find_importer();
  m_thread = std::thread([this] { run(); });
}

ImportLimits AssetThumbnails::quick(ImportLimits limits) {
  if (!(limits.max_seconds > 0)) limits.max_seconds = kMostSeconds;
  limits.max_triangles = std::min(limits.max_triangles, kMostTriangles);
  return limits;
}

AssetThumbnails::~AssetThumbnails() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
  }
  m_wake.notify_all();
  m_thread.join();
}

void AssetThumbnails::list(const QString& folder) {
  {
    const std::lock_guard lock(m_mutex);
    m_folder = folder;
    m_lists_another = true;
  }
  m_wake.notify_all();
}

void AssetThumbnails::want(const QStringList& seen, const QStringList& rest) {
  hold(seen);
  std::deque<QString> wanted;
  for (const QString& file : seen) {
    const AssetInfo* const info = find(file);
    if (!info || (info->picture.isNull() && info->error.empty())) wanted.push_back(file);
  }
  for (const QString& file : rest)
    if (!find(file)) wanted.push_back(file);
  {
    const std::lock_guard lock(m_mutex);
    m_wanted = std::move(wanted);
  }
  m_wake.notify_all();
}

// Folders may have thousands of models: only some pictures are in memory.
void AssetThumbnails::hold(const QStringList& seen) {
  m_in_sight = QSet<QString>(seen.begin(), seen.end());
  m_held.removeIf([this](const QString& file) { return m_in_sight.contains(file); });
  m_held += seen;
  while (m_held.size() > std::max(kMostHeld, seen.size())) {
    const QString file = m_held.takeFirst();
    const auto known = m_known.find(file);
    if (known == m_known.end() || known->picture.isNull()) continue;
    known->picture = QImage();
    Q_EMIT dropped(file);
  }
}

void AssetThumbnails::take(const QString& file, AssetInfo info) {
  if (!m_in_sight.contains(file)) info.picture = QImage();
  m_known[file] = std::move(info);
  Q_EMIT made(file);
}

bool AssetThumbnails::is_current(const QString& file) const {
  const AssetInfo* const info = find(file);
  return info && info->stamp == FileStamp::of(file);
}

void AssetThumbnails::forget(const QString& file) { m_known.remove(file); }

const AssetInfo* AssetThumbnails::find(const QString& file) const {
  const auto found = m_known.constFind(file);
  return found == m_known.constEnd() ? nullptr : &*found;
}

void AssetThumbnails::run() {
  setpriority(PRIO_PROCESS, 0, kLeastUrgent);  // of this thread
  if (!m_cache.isEmpty()) prune(m_cache);
  for (;;) {
    QString folder, file;
    {
      std::unique_lock lock(m_mutex);
      m_wake.wait(lock, [&] { return m_stop || m_folder || !m_wanted.empty(); });
      if (m_stop) return;
      m_lists_another = false;
      if (m_folder) {
        folder = *std::exchange(m_folder, std::nullopt);
      } else {
        file = m_wanted.front();
        m_wanted.pop_front();
      }
    }
    if (!folder.isEmpty()) {
      const QStringList models = models_in(folder, [this] { return m_stop || m_lists_another; });
      if (!m_lists_another) Q_EMIT listed(folder, models);
      continue;
    }
    const AssetInfo info = info_of(file);
    if (m_stop) return;
    QMetaObject::invokeMethod(
        this, [this, file, info] { take(file, info); }, Qt::QueuedConnection);
  }
}

// Another content has another picture.
QString AssetThumbnails::cached_file(const QString& file, const FileStamp& stamp) const {
  const QString key = QString("%1\n%2\n%3\n%4")
                          .arg(kVersion)
                          .arg(QFileInfo(file).canonicalFilePath())
                          .arg(stamp.bytes)
                          .arg(stamp.modified_ms);
  const QByteArray hash = QCryptographicHash::hash(key.toUtf8(), QCryptographicHash::Sha1);
  return QDir(m_cache).filePath(QString::fromLatin1(hash.toHex()) + ".png");
}

AssetInfo AssetThumbnails::info_of(const QString& file) const {
  const FileStamp stamp = FileStamp::of(file);
  AssetInfo info;
  if (!m_cache.isEmpty() && info.picture.load(cached_file(file, stamp)) &&
      !info.picture.text("metres").isEmpty()) {
    const QImage& kept = info.picture;
    const QStringList size = kept.text("size").split(' ');
    for (int i = 0; i < 3 && size.size() == 3; ++i) info.size[i] = size[i].toDouble();
    info.metres = kept.text("metres").toDouble();
    info.unit = kept.text("unit");
    info.up = kept.text("up").startsWith('y') ? UpAxis::Y : UpAxis::Z;
    info.states_up = kept.text("up").endsWith("stated");
    for (const QString& note : kept.text("notes").split('\n', Qt::SkipEmptyParts))
      info.notes.push_back(sentence_from_json(note.toStdString()));
  } else {
    info = made_of(file);
    // Errors are not kept: the next time there may be time and memory for it, or an importer.
    if (!m_cache.isEmpty() && !m_stop && info.error.empty()) keep(cached_file(file, stamp), info);
  }
  info.stamp = stamp;
  return info;
}

AssetInfo AssetThumbnails::made_of(const QString& file) const {
  AssetInfo info;
  try {
    const Model model = import_model(file.toStdString(), m_limits, {}, &m_stop);
    const Aabb box = model.mesh.box();
    info.size = box.upper - box.lower;
    if (!model.metres_per_unit) info.unit = likely_unit(box);
    info.metres = model.metres_per_unit.value_or(metres_of(info.unit));
    info.states_up = model.up_from_format;
    info.up = info.states_up ? model.up : likely_up(model.mesh).value_or(model.up);
    info.notes = model.notes;
    info.picture = picture_of(model, info.up, info.metres, m_stop);
  } catch (const std::exception& error) {
    info.error = sentence_of(error);
  }
  return info;
}

// A cache that cannot be written is no error: the picture is made again next time.
void AssetThumbnails::keep(const QString& cached, const AssetInfo& info) const {
  QImage kept = info.picture;
  kept.setText("metres", QString::number(info.metres, 'g', 17));
  kept.setText("size", QString("%1 %2 %3")
                           .arg(info.size.x(), 0, 'g', 9)
                           .arg(info.size.y(), 0, 'g', 9)
                           .arg(info.size.z(), 0, 'g', 9));
  kept.setText("unit", info.unit);
  kept.setText("up", QString(info.up == UpAxis::Y ? "y" : "z") + (info.states_up ? " stated" : ""));
  QStringList notes;
  for (const Sentence& note : info.notes) notes << QString::fromStdString(to_json(note));
  kept.setText("notes", notes.join('\n'));
  QDir().mkpath(m_cache);
  QSaveFile out(cached);
  if (out.open(QIODevice::WriteOnly) && kept.save(&out, "PNG")) out.commit();
}

}  // namespace trivet::edit
