// notes.jsonl: what people may want to know of how a batch was made. No unit depends on it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trivet::farm {

struct BatchNote {
  std::uint64_t scene = 0;  // with which it came
  std::string text;
};

/// Adds a line. Several processes may add at the same time.
/// @return false if it cannot be written: no scene fails for that.
bool add_note(const std::string& out, const BatchNote& note);

/// The first notes, at most so many; empty where there are none. Lines that are none are left out.
std::vector<BatchNote> read_notes(const std::string& out, size_t most);

}  // namespace trivet::farm
