// Arrangement files: a layout with a section "arrange".
#pragma once

#include <cstdint>
#include <string>

#include "ops/arrange/arrange.h"
#include "ops/files/layout/layout.h"

namespace trivet {

/// A layout of what stands, and a problem to arrange on it.
struct Problem {
  Layout layout;
  Arrangement arrangement;
};

/// Reads strictly; the language is described in ops/arrange/README.md and `trivet schema`.
/// @param file  name for messages.
/// @throws Error (BadInput) naming the file, the place as a JSON pointer, the value and what is
///   accepted; unknown names with the nearest known one.
Problem parse_problem(const std::string& text, const std::string& file);
Problem read_problem(const std::string& path, std::uintmax_t max_bytes = std::uintmax_t{1} << 30);

/// The layout that gives the arranged scene again: its things stand where they came to rest.
Layout arranged_layout(const Layout& layout, const Scene& scene, const ArrangeResult& result);

/// "arrange" of a report, as JSON text: status, seed, counts, relations with their costs, or the
/// conflict.
std::string arrangement_json(const Arrangement& arrangement, const ArrangeResult& result);

/// For people: a line on how it went, and the conflict.
std::string arrangement_text(const ArrangeResult& result);

}  // namespace trivet
