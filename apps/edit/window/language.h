// Language of the windows, and decimals: the system's, or one that was chosen.
#pragma once

#include <QString>
#include <QTranslator>
#include <vector>

class QCoreApplication;

namespace trivet::edit {

struct Language {
  QString code;  // "de"
  QString name;  // in itself: "Deutsch"
};
/// English, and those that this build has translations of.
std::vector<Language> languages();

/// @throws Error (BadInput) for a code of none of them.
void check_language(const QString& code);

/// Empty: the system's.
QString saved_language();
/// For the next start.
void save_language(const QString& code);

/// To be called once, before there are windows. What has no translation is English.
/// @param code  of languages(); empty: the system's, English if there is no translation.
void speak(QCoreApplication& application, const QString& code);

/// Texts by their own context, else by that of the functions of no class, which Qt's lupdate names
/// after their namespace while tr() calls it QObject.
class Translation : public QTranslator {
 public:
  using QTranslator::QTranslator;
  QString translate(const char* context, const char* text, const char* remark,
                    int n) const override;
};

}  // namespace trivet::edit
