// Strict JSON from files that people write: every complaint names the file, the place as a JSON
// pointer, the value and what is accepted.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/sentence.h"

namespace trivet {

/// The whole file; pipes too.
/// @throws Error (BadInput): missing, a folder, unreadable, larger than `max_bytes`.
std::string read_text_file(const std::string& path, std::uintmax_t max_bytes);

/// @param file  the name for messages.
/// @throws Error (BadInput): syntax errors with line and column, numbers beyond double, the same
///   key twice in one object, more than 64 levels.
nlohmann::json parse_json(const std::string& text, const std::string& file);

/// A value inside a JSON file, with the way to it. Refers to the document, which must live on.
class JsonPlace {
 public:
  JsonPlace(const nlohmann::json& document, std::string file)
      : m_value(&document), m_file(std::move(file)) {}

  /// An object that has all `required` keys and beside them only `optional` ones.
  void expect_object(std::span<const char* const> required,
                     std::span<const char* const> optional) const;
  void expect_object(std::initializer_list<const char*> required,
                     std::initializer_list<const char*> optional) const;
  /// The same; `explain` adds to the message about an unknown key.
  void expect_object(const std::vector<const char*>& required,
                     const std::vector<const char*>& optional,
                     const std::function<Sentence(const std::string& key)>& explain) const;
  JsonPlace at(const char* key) const;  // refuses when it is missing
  std::optional<JsonPlace> find(const char* key) const;
  std::vector<JsonPlace> items() const;  // of an array

  std::string text() const;  // not empty, without control characters
  bool boolean() const;
  double number() const;  // any
  double number(double lower, double upper) const;
  std::vector<double> numbers(size_t count) const;
  std::vector<double> numbers(size_t count, double lower, double upper) const;

  const nlohmann::json& value() const { return *m_value; }
  /// "FILE: /objects/3/scale"
  std::string where() const;
  /// @throws Error "FILE: /objects/3/scale: 0 is not accepted; accepted: ..."
  [[noreturn]] void refuse(const Sentence& accepted) const;
  /// @throws Error "FILE: /objects/3/scale: `what`"
  [[noreturn]] void fail(const Sentence& what) const;

 private:
  JsonPlace(const nlohmann::json& value, std::string file, std::string pointer)
      : m_value(&value), m_file(std::move(file)), m_pointer(std::move(pointer)) {}
  JsonPlace child(const std::string& token, const nlohmann::json& value) const;

  const nlohmann::json* m_value;
  std::string m_file, m_pointer;
};

/// JSON text with a line per entry, and lists of plain values, such as vectors, on one line. What
/// is no UTF-8 is replaced.
std::string readable_json(const nlohmann::ordered_json& value);

/// A number as people write it: 1e-15, 0.25.
std::string short_number(double value);

}  // namespace trivet
