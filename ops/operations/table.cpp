#include "ops/operations/table.h"

#include <algorithm>

namespace trivet {
namespace {

bool is_one_of(const std::vector<const char*>& words, const std::string& word) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

}  // namespace

size_t OperationTable::form_of(const void* operation) const {
  // The first form whose condition holds is the operation's.
  for (size_t f = 0; f < forms.size(); ++f)
    if (!forms[f].holds || forms[f].holds(operation)) return f;
  return 0;
}

const Field* OperationTable::find(std::string_view key) const {
  for (const Field& field : fields)
    if (key == field.key) return &field;
  return nullptr;
}

std::vector<const char*> OperationTable::keys(size_t form, bool required) const {
  std::vector<const char*> out;
  if (required) out.push_back("op");
  for (const Field& field : fields)
    if (field.is_in(form) && field.required == required) out.push_back(field.key);
  return out;
}

std::optional<size_t> OperationTable::chosen(
    std::string_view op, const std::function<bool(const char* key)>& given,
    const std::function<std::string(const char* key)>& word) const {
  // Keys that are given choose the form, as JSON does not name it.
  for (size_t f = 0; f < forms.size(); ++f) {
    const Form& form = forms[f];
    if (op != form.op) continue;
    const bool is_marked = std::any_of(form.marks.begin(), form.marks.end(), given);
    if (form.marks.empty()) return f;
    if (is_marked && (form.words.empty() || is_one_of(form.words, word(form.marks[0])))) return f;
  }
  return std::nullopt;
}

Sentence in_words(const InvalidArgument& found) {
  if (!found.why.empty()) return say("%1: %2", found.key, found.why);
  return say("%1: %2 is not accepted; accepted: %3", found.key, found.value, found.accepted);
}

}  // namespace trivet
