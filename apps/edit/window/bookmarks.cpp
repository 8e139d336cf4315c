#include "apps/edit/window/bookmarks.h"

#include <QFileInfo>
#include <QSettings>
#include <QUrl>
#include <QVariant>
#include <cmath>

namespace trivet::edit {
namespace {

constexpr int kNumbers = 12;  // of a bookmark: window, eye, target, up, angle, height (0: none)

QString group_of(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  return "bookmarks/" + QString::fromLatin1(QUrl::toPercentEncoding(path));
}

QVariantList numbers_of(const Bookmark& bookmark) {
  const LiveCamera& camera = bookmark.camera.camera();
  QVariantList out{static_cast<int>(bookmark.window)};
  for (const Vec3& v : {camera.eye, camera.target, camera.up})
    for (const double x : v) out << x;
  out << camera.fov_deg << camera.height.value_or(0);
  return out;
}

/// Nullopt: the settings were changed by hand.
std::optional<Bookmark> bookmark_of(const QVariantList& numbers) {
  if (numbers.size() != kNumbers) return std::nullopt;
  std::vector<double> all;
  all.reserve(kNumbers);
  for (const QVariant& number : numbers) {
    bool is_number = false;
    all.push_back(number.toDouble(&is_number));
    if (!is_number || !std::isfinite(all.back())) return std::nullopt;
  }
  View view;
  view.eye = Vec3(all[1], all[2], all[3]), view.target = Vec3(all[4], all[5], all[6]);
  view.up = Vec3(all[7], all[8], all[9]);
  view.fov_deg = all[10], view.height = all[11];
  view.orthographic = view.height > 0;
  const bool sound = all[0] >= 0 && all[0] <= 2 && view.fov_deg >= 1 && view.fov_deg <= 170 &&
                     view.height >= 0 && (view.eye - view.target).norm() > 0 && view.up.norm() > 0;
  if (!sound) return std::nullopt;
  return Bookmark{static_cast<WindowKind>(static_cast<int>(all[0])), ViewCamera::of(view)};
}

}  // namespace

void Bookmarks::store(int number, const Bookmark& bookmark) {
  m_bookmarks[number] = bookmark;
  save();
}

const Bookmark* Bookmarks::find(int number) const {
  const auto found = m_bookmarks.find(number);
  return found != m_bookmarks.end() ? &found->second : nullptr;
}

void Bookmarks::load(const QString& file) {
  m_bookmarks.clear();
  m_file = file;
  if (file.isEmpty()) return;
  QSettings settings;
  settings.beginGroup(group_of(file));
  for (int number = 1; number <= kMost; ++number)
    if (const auto bookmark = bookmark_of(settings.value(QString::number(number)).toList()))
      m_bookmarks[number] = *bookmark;
}

void Bookmarks::keep_for(const QString& file) {
  m_file = file;
  save();
}

void Bookmarks::save() const {
  if (m_file.isEmpty()) return;
  QSettings settings;
  settings.beginGroup(group_of(m_file));
  settings.remove("");
  for (const auto& [number, bookmark] : m_bookmarks)
    settings.setValue(QString::number(number), numbers_of(bookmark));
}

}  // namespace trivet::edit
