#include "apps/edit/window/asset_facts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>
#include <QStringList>
#include <QUrl>
#include <QVariant>

#include "apps/edit/document/words.h"

namespace trivet::edit {
namespace {

QString words(const char* text) { return QCoreApplication::translate("assets", text); }

QString settings_key(const char* what, const QString& folder) {
  return QString("assets/%1/").arg(what) + QUrl::toPercentEncoding(folder);
}

void keep(const QString& key, const QVariant& value, bool is_default) {
  QSettings settings;
  if (is_default)
    settings.remove(key);
  else
    settings.setValue(key, value);
}

}  // namespace

QString size_text(const AssetInfo& info) {
  QStringList sides;
  for (int i = 0; i < 3; ++i) sides << QLocale().toString(info.size[i], 'g', 3);
  const QString size = sides.join(" × ");
  if (!info.unit.isEmpty())
    return words(QT_TRANSLATE_NOOP("assets", "%1, likely %2")).arg(size, info.unit);
  if (info.metres == 1) return words(QT_TRANSLATE_NOOP("assets", "%1 m")).arg(size);
  return words(QT_TRANSLATE_NOOP("assets", "%1 units of %2 m"))
      .arg(size, QLocale().toString(info.metres, 'g', 4));
}

QString up_text(const AssetInfo& info) {
  const QString axis = info.up == UpAxis::Y ? "y" : "z";
  return (info.states_up ? words(QT_TRANSLATE_NOOP("assets", "up: %1"))
                         : words(QT_TRANSLATE_NOOP("assets", "up: %1, likely")))
      .arg(axis);
}

QStringList notes_text(const AssetInfo& info) {
  QStringList out;
  for (const Sentence& note : info.error.empty() ? info.notes : std::vector<Sentence>{info.error})
    out << QString::fromStdString(in_words(note));
  return out;
}

QString picture_cache() {
  const QString cache = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
  return cache.isEmpty() ? cache : cache + "/models";
}

FolderChoice FolderChoice::of(const QString& folder) {
  FolderChoice out;
  out.metres = QSettings().value(settings_key("units", folder), 0.0).toDouble();
  const QString up = QSettings().value(settings_key("up", folder)).toString();
  if (!up.isEmpty()) out.up = up == "y" ? UpAxis::Y : UpAxis::Z;
  return out;
}

std::optional<UpAxis> FolderChoice::up_of(const QString& file, const QString& top) {
  const QString last = QDir(top).absolutePath();
  QString folder = QFileInfo(file).absolutePath();
  for (;;) {
    if (const auto up = of(folder).up) return up;
    const QString above = QFileInfo(folder).absolutePath();
    if (folder == last || above == folder) return std::nullopt;
    folder = above;
  }
}

void FolderChoice::remember(const QString& folder) const {
  keep(settings_key("units", folder), metres, metres == 0);
  keep(settings_key("up", folder), up == UpAxis::Y ? "y" : "z", !up);
}

}  // namespace trivet::edit
