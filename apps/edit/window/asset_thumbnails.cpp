#include "apps/edit/window/asset_thumbnails.h"

#include <sys/resource.h>
#include <tbb/task_arena.h>

#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QSaveFile>

#include "core/io/sandboxed_import.h"
#include "core/picture/image.h"
#include "ops/files/report/model_info.h"
#include "raster/path/path_picture.h"

namespace trivet::edit {
namespace {

constexpr int kPixels = 160, kSamples = 8;
constexpr int kMostFiles = 5000;  // of a folder
constexpr int kMostKept = 5000;   // in the cache: about 100 MB
constexpr double kMostSeconds = 10;
constexpr std::int64_t kMostTriangles = 5'000'000;
constexpr int kLeastUrgent = 19;  // of nice(): the window's threads come first
constexpr int kVersion = 1;       // of what is kept

double metres_of(const std::string& unit) { return unit == "m" ? 1 : unit == "cm" ? 0.01 : 0.001; }

QImage picture_of(const Model& model, double metres, const std::atomic<bool>& stop) {
  const PictureMesh mesh = picture_mesh(model);
  PictureScene scene;
  scene.floor = false;
  scene.objects.push_back({&mesh, world_from_object({}, model.up, metres), std::nullopt});
  PictureOptions options;
  options.width = options.height = kPixels;
  options.samples = kSamples;
  options.background = {1, 1, 1, 0};
  PathOptions path;
  path.bounces = 1;
  path.cancel = &stop;
  Image image;
  tbb::task_arena(1).execute([&] { image = trace_picture(scene, std::nullopt, options, path); });
  return QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
}

// The oldest go.
void prune(const QString& cache) {
  const QFileInfoList kept = QDir(cache).entryInfoList({"*.png"}, QDir::Files, QDir::Time);
  for (qsizetype i = kMostKept; i < kept.size(); ++i) QFile::remove(kept[i].filePath());
}

QStringList models_in(const QString& folder, const std::atomic<bool>& stop) {
  QStringList out;
  QDirIterator it(folder, AssetThumbnails::patterns(), QDir::Files | QDir::Readable,
                  QDirIterator::Subdirectories);
  while (it.hasNext() && out.size() < kMostFiles && !stop) out << it.next();
  out.sort(Qt::CaseInsensitive);
  return out;
}

}  // namespace

const QStringList& AssetThumbnails::patterns() {
  static const QStringList all = {"*.obj", "*.glb",  "*.gltf", "*.ply",   "*.stl", "*.fbx",
                                  "*.dae", "*.3ds",  "*.off",  "*.blend", "*.x3d", "*.step",
                                  "*.stp", "*.iges", "*.igs",  "*.brep"};
  return all;
}

AssetThumbnails::AssetThumbnails(QString cache, ImportLimits limits, QObject* parent)
    : QObject(parent), m_cache(std::move(cache)), m_limits(std::move(limits)) {
  if (m_limits.importer.empty()) m_limits.importer = find_importer();
  m_limits.max_seconds = kMostSeconds;
  m_limits.max_triangles = kMostTriangles;
  m_thread = std::thread([this] { run(); });
}

AssetThumbnails::~AssetThumbnails() {
  m_stop = true;
  m_wake.notify_all();
  m_thread.join();
}

void AssetThumbnails::list(const QString& folder) {
  {
    const std::lock_guard lock(m_mutex);
    m_folders.push_back(folder);
  }
  m_wake.notify_all();
}

void AssetThumbnails::want(QStringList files) {
  files.removeIf([this](const QString& file) { return m_known.contains(file); });
  {
    const std::lock_guard lock(m_mutex);
    m_wanted.assign(files.begin(), files.end());
  }
  m_wake.notify_all();
}

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
      m_wake.wait(lock, [&] { return m_stop || !m_folders.empty() || !m_wanted.empty(); });
      if (m_stop) return;
      std::deque<QString>& queue = m_folders.empty() ? m_wanted : m_folders;
      (m_folders.empty() ? file : folder) = queue.front();
      queue.pop_front();
    }
    if (!folder.isEmpty()) {
      Q_EMIT listed(folder, models_in(folder, m_stop));
      continue;
    }
    const AssetInfo info = info_of(file);
    if (m_stop) return;
    QMetaObject::invokeMethod(
        this,
        [this, file, info] {
          m_known[file] = info;
          Q_EMIT made(file);
        },
        Qt::QueuedConnection);
  }
}

// Another content has another time, and so another picture.
QString AssetThumbnails::cached_file(const QString& file) const {
  const QFileInfo now(file);
  const QString key = QString("%1\n%2\n%3\n%4")
                          .arg(kVersion)
                          .arg(now.canonicalFilePath())
                          .arg(now.size())
                          .arg(now.lastModified().toMSecsSinceEpoch());
  const QByteArray hash = QCryptographicHash::hash(key.toUtf8(), QCryptographicHash::Sha1);
  return QDir(m_cache).filePath(QString::fromLatin1(hash.toHex()) + ".png");
}

AssetInfo AssetThumbnails::info_of(const QString& file) const {
  if (m_cache.isEmpty()) return made_of(file);
  AssetInfo info;
  if (info.picture.load(cached_file(file)) && !info.picture.text("metres").isEmpty()) {
    const QImage& kept = info.picture;
    const QStringList size = kept.text("size").split(' ');
    for (int i = 0; i < 3 && size.size() == 3; ++i) info.size[i] = size[i].toDouble();
    info.metres = kept.text("metres").toDouble();
    info.unit = kept.text("unit");
    info.error = kept.text("error");
    if (!info.error.isEmpty()) info.picture = QImage();
    return info;
  }
  info = made_of(file);
  if (!m_stop) keep(file, info);
  return info;
}

AssetInfo AssetThumbnails::made_of(const QString& file) const {
  AssetInfo info;
  try {
    const Model model = import_model(file.toStdString(), m_limits);
    const Aabb box = model.mesh.box();
    info.size = box.upper - box.lower;
    if (!model.metres_per_unit) info.unit = likely_unit(box);
    info.metres = model.metres_per_unit.value_or(metres_of(info.unit.toStdString()));
    info.picture = picture_of(model, info.metres, m_stop);
  } catch (const std::exception& error) {
    info.error = QString::fromUtf8(error.what());
  }
  return info;
}

// A cache that cannot be written is no error: the picture is made again next time.
void AssetThumbnails::keep(const QString& file, const AssetInfo& info) const {
  QImage kept = info.picture;
  if (kept.isNull()) kept = QImage(1, 1, QImage::Format_RGBA8888);
  kept.setText("metres", QString::number(info.metres, 'g', 17));
  kept.setText("size", QString("%1 %2 %3")
                           .arg(info.size.x(), 0, 'g', 9)
                           .arg(info.size.y(), 0, 'g', 9)
                           .arg(info.size.z(), 0, 'g', 9));
  kept.setText("unit", info.unit);
  kept.setText("error", info.error);
  QDir().mkpath(m_cache);
  QSaveFile out(cached_file(file));
  if (out.open(QIODevice::WriteOnly) && kept.save(&out, "PNG")) out.commit();
}

}  // namespace trivet::edit
