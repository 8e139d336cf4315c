#include "apps/edit/document/words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "core/base/error.h"

namespace trivet::edit {
namespace {

// For lupdate; they are looked up by name.
[[maybe_unused]] constexpr const char* kOperations[] = {
    QT_TRANSLATE_NOOP("operations", "put"),      QT_TRANSLATE_NOOP("operations", "push"),
    QT_TRANSLATE_NOOP("operations", "turn"),     QT_TRANSLATE_NOOP("operations", "pick up"),
    QT_TRANSLATE_NOOP("operations", "move"),     QT_TRANSLATE_NOOP("operations", "rotate"),
    QT_TRANSLATE_NOOP("operations", "append"),   QT_TRANSLATE_NOOP("operations", "duplicate"),
    QT_TRANSLATE_NOOP("operations", "delete"),   QT_TRANSLATE_NOOP("operations", "lock"),
    QT_TRANSLATE_NOOP("operations", "unlock"),   QT_TRANSLATE_NOOP("operations", "fix"),
    QT_TRANSLATE_NOOP("operations", "unfix"),    QT_TRANSLATE_NOOP("operations", "group"),
    QT_TRANSLATE_NOOP("operations", "ungroup"),  QT_TRANSLATE_NOOP("operations", "rename"),
    QT_TRANSLATE_NOOP("operations", "stand"),    QT_TRANSLATE_NOOP("operations", "unplace"),
    QT_TRANSLATE_NOOP("operations", "material"), QT_TRANSLATE_NOOP("operations", "arrange"),
    QT_TRANSLATE_NOOP("operations", "drape"),    QT_TRANSLATE_NOOP("operations", "mend"),
    QT_TRANSLATE_NOOP("operations", "settle"),   QT_TRANSLATE_NOOP("operations", "move joint")};

// Messages of the system about files.
[[maybe_unused]] constexpr const char* kSystem[] = {
    QT_TRANSLATE_NOOP("refusal", "No such file or directory"),
    QT_TRANSLATE_NOOP("refusal", "Permission denied"),
    QT_TRANSLATE_NOOP("refusal", "No space left on device"),
    QT_TRANSLATE_NOOP("refusal", "Read-only file system"),
    QT_TRANSLATE_NOOP("refusal", "Is a directory"),
    QT_TRANSLATE_NOOP("refusal", "Not a directory"),
    QT_TRANSLATE_NOOP("refusal", "File exists"),
    QT_TRANSLATE_NOOP("refusal", "Input/output error"),
    QT_TRANSLATE_NOOP("refusal", "Too many open files"),
    QT_TRANSLATE_NOOP("refusal", "Cannot allocate memory")};

std::string translated(const char* context, const std::string& text) {
  return QCoreApplication::translate(context, text.c_str()).toStdString();
}

std::string number_in_words(const Sentence& number) {
  QLocale locale;
  if (locale.decimalPoint() == ".") return in_english(number);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(*number.number, 'g', number.digits).toStdString();
}

bool rescales(const std::vector<Operation>& all, size_t first) {
  return all.size() >= first + 2 && std::holds_alternative<DeleteOperation>(all[first]) &&
         std::holds_alternative<AppendOperation>(all[first + 1]) &&
         object_name(all[first]) == object_name(all[first + 1]);
}

}  // namespace

std::string in_words(const Sentence& sentence) {
  if (sentence.is_verbatim) return sentence.text;
  if (sentence.number) return number_in_words(sentence);
  std::vector<std::string> parts;
  parts.reserve(sentence.parts.size());
  for (const Sentence& part : sentence.parts) parts.push_back(in_words(part));
  return filled(translated("refusal", sentence.text), parts);
}

Sentence sentence_of(const std::exception& error) {
  const auto* const known = dynamic_cast<const Error*>(&error);
  return known ? known->sentence() : Sentence(std::string(error.what()));
}

std::string in_words(const std::exception& error) { return in_words(sentence_of(error)); }

// No number says where a hand lets go: the view shows the place, and how deep it is.
std::string reason_in_words(const OperationResult& result) {
  if (!result.refusal) return "";
  Refusal refusal = *result.refusal;
  if (refusal.at == Refusal::At::Start &&
      !(refusal.number("depth") == 0 && !refusal.numbers.empty())) {
    refusal.at = Refusal::At::End;
    refusal.numbers.clear();
  }
  return in_words(sentence_of(refusal));
}

// As menus call them.
std::string in_words(const char* operation) {
  const std::string name = operation;
  if (name == op_name(PickUpOperation())) return translated("operations", "pick up");
  if (name == op_name(TranslateOperation())) return translated("operations", "move");
  if (name == op_name(MoveJointOperation())) return translated("operations", "move joint");
  return translated("operations", name);
}

std::string with_name(const QString& text, const std::string& name) {
  return text.arg(QString::fromStdString(name)).toStdString();
}

std::string label_of(const SessionStep& step) {
  const std::vector<Operation>& all = step.operations;
  const size_t first = std::holds_alternative<LockOperation>(all.front()) ? 1 : 0;
  if (rescales(all, first))
    return with_name(QCoreApplication::translate("operations", "scale \"%1\""),
                     object_name(all[first]));
  const std::string name = op_name(all.front());
  const bool same =
      std::all_of(all.begin(), all.end(), [&](const Operation& o) { return op_name(o) == name; });
  const int count = static_cast<int>(all.size());
  if (same && count > 1)
    return with_name(QCoreApplication::translate("operations", "%1 %n objects", nullptr, count),
                     in_words(name.c_str()));
  std::string out = in_words(name.c_str());
  if (!object_name(all.front()).empty())
    out.append(" \"").append(object_name(all.front())).append("\"");
  if (same) return out;
  return QCoreApplication::translate("operations", "%1 and %2")
      .arg(QString::fromStdString(out), QString::fromStdString(in_words(op_name(all.back()))))
      .toStdString();
}

}  // namespace trivet::edit
