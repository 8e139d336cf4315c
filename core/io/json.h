// JSON of files, lines and requests, none of which is trusted: all readers parse here. Private:
// exposes the JSON library.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/base/sentence.h"

namespace trivet {

struct JsonLimits {
  size_t max_depth = 64;                 // the library prints and copies documents recursively
  size_t max_bytes = size_t{256} << 20;  // a document takes up to 20 times that in memory
};

/// Words of the error about too many levels.
inline constexpr const char* kTooDeep = "nested too deep";

/// A document in UTF-8, with or without a byte order mark, in time linear in its length. `Json` is
/// nlohmann::json or nlohmann::ordered_json.
/// @param name  begins every message, as "layout.json".
/// @throws Error (BadInput): syntax errors with line and column, numbers beyond double; with the
///   place as a JSON pointer, the same key twice in one object and too many levels; too long a
///   text.
template <class Json>
Json json_from_text(const std::string& text, const Sentence& name, const JsonLimits& limits = {});

/// The same where the reason does not matter: empty for all that is refused.
template <class Json>
std::optional<Json> json_if_valid(const std::string& text, const JsonLimits& limits = {});

/// The library's complaint, without its codes.
std::string complaint_of(const nlohmann::detail::exception& e);

/// One step of a JSON pointer, escaped: "~" as "~0", "/" as "~1" [RFC 6901].
std::string pointer_token(const std::string& key);

}  // namespace trivet
