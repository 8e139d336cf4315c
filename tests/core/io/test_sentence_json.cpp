#include <gtest/gtest.h>

#include <limits>

#include "core/io/sentence_json.h"

namespace trivet::test {
namespace {

TEST(SentenceJson, GivesTheSameSentenceBack) {
  const Sentence nested = say(
      "%1; accepted: %2", say("\"%1\" has %2 m", std::string("a\n\"%1\""), figure(0.1, 9)), "b");
  const std::string json = to_json(nested);
  EXPECT_EQ(json.find('\n'), std::string::npos);
  const Sentence back = sentence_from_json(json);
  EXPECT_EQ(in_english(back), in_english(nested));
  EXPECT_EQ(back.text, nested.text);
  ASSERT_EQ(back.parts.size(), 2u);
  EXPECT_EQ(back.parts[0].parts[1].number, 0.1);
  EXPECT_TRUE(back.parts[0].parts[0].is_verbatim);
  EXPECT_EQ(to_json(back), json);
}

TEST(SentenceJson, TakesPlainTextAsWords) {
  for (const std::string text :
       {"cannot be read", "", "{", "[1]", "3", "{\"text\": 4}",
        R"({"text": "%1", "parts": [null]})", R"({"number": "x", "digits": 4})"}) {
    const Sentence back = sentence_from_json(text);
    EXPECT_TRUE(back.is_verbatim) << text;
    EXPECT_EQ(in_english(back), text);
  }
  EXPECT_EQ(in_english(sentence_from_json(to_json(std::string("a \"b\"")))), "a \"b\"");
}

// Untrusted: neither deep nor wide ones are followed.
TEST(SentenceJson, IsBounded) {
  std::string wide = "\"x\"";
  std::string nested = "\"x\"";
  for (int i = 0; i < 17; ++i) nested = R"({"text": "%1", "parts": [)" + nested + "]}";
  EXPECT_TRUE(sentence_from_json(nested).is_verbatim);
  EXPECT_TRUE(sentence_from_json(std::string(1'000'000, '[')).is_verbatim);
  for (int i = 0; i < 9; ++i) wide += ", \"x\"";
  EXPECT_TRUE(sentence_from_json(R"({"text": "%1", "parts": [)" + wide + "]}").is_verbatim);
  EXPECT_EQ(in_english(sentence_from_json(R"({"number": 0.5, "digits": 1000000})")), "0.5");
  EXPECT_EQ(
      in_english(sentence_from_json(to_json(figure(std::numeric_limits<double>::infinity())))),
      "inf");
}

}  // namespace
}  // namespace trivet::test
