#include "ops/files/json/text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/base/nearest_name.h"
#include "core/io/json.h"
#include "ops/files/json/input_text.h"

namespace trivet {
namespace {

using Keys = std::vector<const char*>;

std::string joined(const Keys& a, const Keys& b) {
  std::string out;
  for (const Keys* list : {&a, &b})
    for (const char* key : *list) out += (out.empty() ? "" : ", ") + std::string(key);
  return out;
}

std::vector<std::string> joined_keys(const Keys& a, const Keys& b) {
  std::vector<std::string> out(a.begin(), a.end());
  out.insert(out.end(), b.begin(), b.end());
  return out;
}

bool contains(const Keys& keys, const std::string& key) {
  return std::any_of(keys.begin(), keys.end(), [&](const char* k) { return key == k; });
}

// Long values are cut, so that a message stays a line.
std::string shown(const nlohmann::json& value) {
  constexpr size_t kMaxLength = 60;
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > kMaxLength) text = text.substr(0, kMaxLength) + "...";
  return text;
}

void append_plain(const nlohmann::ordered_json& value, std::string& out) {
  out += value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_readable(const nlohmann::ordered_json& value, const std::string& indent,
                     std::string& out) {
  const auto is_plain = [](const auto& item) { return item.is_primitive(); };
  const bool nested = value.is_structured() && !std::all_of(value.begin(), value.end(), is_plain);
  if (value.empty() || value.is_primitive()) return append_plain(value, out);
  const bool one_line = !nested && value.is_array();
  const std::string deeper = one_line ? "" : "\n" + indent + ' ';
  const char* separator = value.is_object() ? "{" : "[";
  for (const auto& [key, entry] : value.items()) {
    out += separator;
    out += deeper;
    if (value.is_object())
      out +=
          nlohmann::json(key).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + ": ";
    append_readable(entry, indent + ' ', out);
    separator = one_line ? ", " : ",";
  }
  if (!one_line) out += '\n' + indent;
  out += value.is_object() ? '}' : ']';
}

}  // namespace

std::string read_text_file(const std::string& path, std::uintmax_t max_bytes) {
  return read_input_text(path, max_bytes, TextKind::Any);
}

nlohmann::json parse_json(const std::string& text, const std::string& file) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    bad_input("%1: is empty; accepted: a JSON object", file);
  if (text.rfind("glTF", 0) == 0)
    bad_input("%1: is a scene or a model in binary glTF; accepted: JSON, as of a layout", file);
  return json_from_text<nlohmann::json>(text, file);
}

std::string readable_json(const nlohmann::ordered_json& value) {
  std::string out;
  append_readable(value, "", out);
  return out + "\n";
}

std::string short_number(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

JsonPlace JsonPlace::child(const std::string& token, const nlohmann::json& value) const {
  return JsonPlace(value, m_file, m_pointer + "/" + pointer_token(token));
}

std::string JsonPlace::where() const {
  return m_pointer.empty() ? m_file : m_file + ": " + m_pointer;
}

void JsonPlace::fail(const Sentence& what) const { bad_input("%1: %2", where(), what); }

void JsonPlace::refuse(const Sentence& accepted) const {
  fail(say("%1 is not accepted; accepted: %2", shown(*m_value), accepted));
}

void JsonPlace::expect_object(std::initializer_list<const char*> required,
                              std::initializer_list<const char*> optional) const {
  expect_object(Keys(required), Keys(optional), [](const std::string&) { return Sentence(); });
}

void JsonPlace::expect_object(std::span<const char* const> required,
                              std::span<const char* const> optional) const {
  expect_object(Keys(required.begin(), required.end()), Keys(optional.begin(), optional.end()),
                [](const std::string&) { return Sentence(); });
}

void JsonPlace::expect_object(
    const Keys& required, const Keys& optional,
    const std::function<Sentence(const std::string& key)>& explain) const {
  const std::string accepted = joined(required, optional);
  if (!m_value->is_object()) refuse(say("an object with the keys %1", accepted));
  for (const auto& [key, value] : m_value->items())
    if (!contains(required, key) && !contains(optional, key))
      child(key, value)
          .fail(say("unknown key; accepted: %1%2%3", accepted,
                    did_you_mean(key, joined_keys(required, optional)), explain(key)));
  for (const char* key : required)
    if (!m_value->contains(key))
      fail(say("the key \"%1\" is missing; required: %2", key, joined(required, {})));
}

JsonPlace JsonPlace::at(const char* key) const {
  if (const auto found = find(key)) return *found;
  fail(say("the key \"%1\" is missing", key));
}

std::optional<JsonPlace> JsonPlace::find(const char* key) const {
  if (!m_value->is_object()) return std::nullopt;
  const auto it = m_value->find(key);
  if (it == m_value->end()) return std::nullopt;
  return child(key, *it);
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (!m_value->is_array()) refuse("an array");
  std::vector<JsonPlace> out;
  out.reserve(m_value->size());
  for (const nlohmann::json& item : *m_value)
    out.push_back(child(std::to_string(out.size()), item));
  return out;
}

std::string JsonPlace::text() const {
  const Sentence accepted = "text of at least one character, without control characters";
  if (!m_value->is_string()) refuse(accepted);
  const auto& text = m_value->get_ref<const std::string&>();
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (text.empty() || std::any_of(text.begin(), text.end(), is_control)) refuse(accepted);
  return text;
}

bool JsonPlace::boolean() const {
  if (!m_value->is_boolean()) refuse("true or false");
  return m_value->get<bool>();
}

double JsonPlace::number() const {
  if (!m_value->is_number()) refuse("a number");
  return m_value->get<double>();
}

double JsonPlace::number(double lower, double upper) const {
  const double value = m_value->is_number() ? m_value->get<double>() : NAN;
  if (!(lower <= value && value <= upper))
    refuse(say("a number from %1 to %2", figure(lower), figure(upper)));
  return value;
}

std::vector<double> JsonPlace::numbers(size_t count) const {
  if (!m_value->is_array() || m_value->size() != count)
    refuse(say("an array of %1 numbers", count));
  std::vector<double> out;
  for (const JsonPlace& item : items()) out.push_back(item.number());
  return out;
}

std::vector<double> JsonPlace::numbers(size_t count, double lower, double upper) const {
  std::vector<double> out = numbers(count);
  for (const JsonPlace& item : items()) item.number(lower, upper);
  return out;
}

}  // namespace trivet
