#include "apps/edit/window/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QStringList>

#include "core/base/error.h"

namespace trivet::edit {
namespace {

constexpr const char* kKey = "window/language";

QString file_of(const QString& code) { return ":/languages/trivet-edit_" + code + ".qm"; }

}  // namespace

std::vector<Language> languages() {
  std::vector<Language> out{{"en", "English"}};
  for (const char* const code : {"de"})
    if (QFile::exists(file_of(code))) out.push_back({code, QLocale(code).nativeLanguageName()});
  return out;
}

void check_language(const QString& code) {
  QStringList codes;
  for (const Language& language : languages()) codes << language.code;
  if (!codes.contains(code))
    throw Error(Error::Kind::BadInput, "--language %1: accepted: %2", code.toStdString(),
                codes.join(", ").toStdString());
}

QString saved_language() { return QSettings().value(kKey).toString(); }

void save_language(const QString& code) { QSettings().setValue(kKey, code); }

QString Translation::translate(const char* context, const char* text, const char* remark,
                               int n) const {
  for (const char* const known : {context, "trivet::edit", "trivet::edit::FormDialog"})
    if (QString found = QTranslator::translate(known, text, remark, n); !found.isNull())
      return found;
  return {};
}

void speak(QCoreApplication& application, const QString& code) {
  const QString chosen = code.isEmpty() ? QLocale::system().name().section('_', 0, 0) : code;
  if (!code.isEmpty()) QLocale::setDefault(QLocale(code));
  auto* const own = new Translation(&application);
  if (!own->load(file_of(chosen)) && !own->load(file_of("en"))) return;
  // Qt's own dialogs, where its translations are installed.
  auto* const of_qt = new QTranslator(&application);
  if (of_qt->load("qtbase_" + chosen, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(of_qt);
  QCoreApplication::installTranslator(own);
}

}  // namespace trivet::edit
