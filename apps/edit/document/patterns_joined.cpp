// Patterns of English sentences how sentences are joined, and what the system says.
#include <QtGlobal>

#include "apps/edit/document/sentence_patterns.h"

namespace trivet::edit {
namespace {

constexpr const char* kJoining[] = {
    QT_TRANSLATE_NOOP("refusal", "%1: %2"),
    QT_TRANSLATE_NOOP("refusal", "%1; %2"),
    QT_TRANSLATE_NOOP("refusal", "%1, %2"),
    QT_TRANSLATE_NOOP("refusal", "%1; accepted: %2"),
    QT_TRANSLATE_NOOP("refusal", "accepted: %1"),
    QT_TRANSLATE_NOOP("refusal", "%1; accepted for \"%2\": %3"),
    QT_TRANSLATE_NOOP("refusal", "%1; did you mean \"%2\"?"),
    QT_TRANSLATE_NOOP("refusal", "\"listed\" or \"any\""),
    QT_TRANSLATE_NOOP("refusal", "No such file or directory"),
    QT_TRANSLATE_NOOP("refusal", "Permission denied"),
    QT_TRANSLATE_NOOP("refusal", "No space left on device"),
    QT_TRANSLATE_NOOP("refusal", "Read-only file system"),
    QT_TRANSLATE_NOOP("refusal", "Is a directory"),
    QT_TRANSLATE_NOOP("refusal", "Not a directory"),
    QT_TRANSLATE_NOOP("refusal", "File exists"),
    QT_TRANSLATE_NOOP("refusal", "Input/output error"),
    QT_TRANSLATE_NOOP("refusal", "Too many open files"),
    QT_TRANSLATE_NOOP("refusal", "Cannot allocate memory"),
};

}  // namespace

std::span<const char* const> joining_patterns() { return kJoining; }

}  // namespace trivet::edit
