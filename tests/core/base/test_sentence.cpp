#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/sentence.h"

namespace trivet::test {
namespace {

TEST(Sentence, PutsItsPartsIntoThePattern) {
  EXPECT_EQ(in_english(say("%2 on %1, %3", "the floor", std::string("\"%1\""), 7)),
            "\"%1\" on the floor, 7");
  EXPECT_EQ(in_english(say("%1 of 100%", figure(0.25))), "0.25 of 100%");
  EXPECT_EQ(in_english(Sentence("a %1 that has no part")), "a %1 that has no part");
}

TEST(Sentence, HasNumbersWithTheirDigits) {
  EXPECT_EQ(in_english(figure(1.0 / 3, 4)), "0.3333");
  EXPECT_EQ(in_english(figure(1e-15)), "1e-15");
  EXPECT_EQ(in_english(say("%1", 1'000'000'000'000L)), "1000000000000");
}

TEST(Sentence, JoinsSeveral) {
  EXPECT_TRUE(listed({}).empty());
  EXPECT_EQ(in_english(listed({"a", std::string("%1; b"), "c"})), "a; %1; b; c");
}

TEST(Sentence, IsWhatAnErrorSays) {
  const Error error(Error::Kind::BadInput, "%1: no importer for %2", std::string("a.x"), ".x");
  EXPECT_STREQ(error.what(), "a.x: no importer for .x");
  EXPECT_EQ(error.sentence().text, "%1: no importer for %2");
  ASSERT_EQ(error.sentence().parts.size(), 2u);
  EXPECT_TRUE(error.sentence().parts[0].is_verbatim);
  EXPECT_FALSE(error.sentence().parts[1].is_verbatim);
}

}  // namespace
}  // namespace trivet::test
