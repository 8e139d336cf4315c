// A corpus of JSON texts that a strict reader takes, or refuses with a message: a base, and for
// each case what is set or removed in it, or a text of its own.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"

namespace trivet::test {

/// @param file  below the folder of the sources.
inline nlohmann::json read_corpus(const std::string& file) {
  std::ifstream in(std::string(TRIVET_SOURCE_DIR "/") + file);
  return nlohmann::json::parse(in);
}

/// The text of a case.
inline std::string text_of(const nlohmann::json& base, const nlohmann::json& c) {
  using nlohmann::json;
  if (c.contains("text")) return c["text"];
  json out = base;
  const json settings = c.value("set", json::object());
  for (const auto& [pointer, value] : settings.items()) out[json::json_pointer(pointer)] = value;
  json removals = json::array();
  for (const json& pointer : c.value("remove", json::array()))
    removals.push_back({{"op", "remove"}, {"path", pointer}});
  return out.patch(removals).dump();
}

/// The reader's error message; empty if there is none. @param read  a text and its name.
template <class Read>
std::string complaint(const Read& read, const std::string& text) {
  try {
    read(text, "a.json");
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), Error::Kind::BadInput);
    return e.what();
  }
  return "";
}

/// Expects of every case what it says. @return the numbers of those taken and refused.
template <class Read>
std::pair<int, int> expect_corpus(const nlohmann::json& corpus, const Read& read) {
  int num_good = 0, num_bad = 0;
  for (const nlohmann::json& c : corpus["cases"]) {
    const std::string what = c["what"], expected = c.value("message", "");
    const std::string message = complaint(read, text_of(corpus["base"], c));
    if (expected.empty()) {
      EXPECT_EQ(message, "") << what;
    } else {
      EXPECT_EQ(message.rfind("a.json: ", 0), 0u) << what << ": " << message;
      EXPECT_NE(message.find(expected), std::string::npos) << what << ": " << message;
    }
    ++(expected.empty() ? num_good : num_bad);
  }
  return {num_good, num_bad};
}

}  // namespace trivet::test
