// JSON that is not trusted: linear, with limits, each key once, and messages that name the place.
#include <ctime>

#include "core/io/io_testing.h"
#include "core/io/json.h"

namespace trivet {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

constexpr int kMany = 100'000;

std::string repeated(const std::string& text, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += text;
  return out;
}

std::string object_of_many_keys() {
  std::string out = "{";
  for (int i = 0; i < kMany; ++i)
    out += "\"k" + std::to_string(i) + "\":" + std::to_string(i) + ",";
  return out + "\"last\":{}}";
}

template <class F>
double cpu_seconds(F f) {
  const std::clock_t begin = std::clock();
  f();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

template <class T>
class ParsedJson : public ::testing::Test {
 protected:
  static std::string refusal(const std::string& text, const JsonLimits& limits = {}) {
    return testing::error_of([&] { json_from_text<T>(text, "a.json", limits); });
  }
};
using Kinds = ::testing::Types<Json, Ordered>;
TYPED_TEST_SUITE(ParsedJson, Kinds);

TYPED_TEST(ParsedJson, EqualsThatOfTheLibrary) {
  for (const char* text :
       {"7", "\"\"", "null", "true", "-3", "18446744073709551615", "1.5e-7", "[]", "{}", "[[],{}]",
        R"({"z":[1,{"b":[[[0],5,[]]]},"x"],"a":{"c":{},"b":null},"":-0.0})",
        "\xef\xbb\xbf [\"\\u00e9\xc3\xa9\", 1]\n"}) {
    const auto json = json_from_text<TypeParam>(text, "a.json");
    EXPECT_EQ(json.dump(), TypeParam::parse(text).dump()) << text;
  }
}

TYPED_TEST(ParsedJson, TakesTimeLinearInItsLength) {
  size_t objects = 0, keys = 0;
  const double seconds = cpu_seconds([&] {
    objects = json_from_text<TypeParam>("[" + repeated("{},", kMany) + "0]", "a.json").size();
    keys = json_from_text<TypeParam>(object_of_many_keys(), "a.json").size();
  });
  EXPECT_EQ(objects, kMany + 1u);
  EXPECT_EQ(keys, kMany + 1u);
  EXPECT_LT(seconds, 1.0);  // in the square: 10 s and more
}

TYPED_TEST(ParsedJson, RefusesKeysThatComeTwice) {
  EXPECT_EQ(this->refusal(R"({"a":[1,2,{"b":1,"c":[{}],"b":3}]})"),
            "a.json: /a/2/b: this key comes twice; accepted: each key once");
  EXPECT_EQ(this->refusal(R"([[0],{"x/y":{},"~":[],"x/y":1}])"),
            "a.json: /1/x~1y: this key comes twice; accepted: each key once");
  EXPECT_EQ(this->refusal("{\"last\":0," + object_of_many_keys().substr(1)),
            "a.json: /last: this key comes twice; accepted: each key once");
}

TYPED_TEST(ParsedJson, RefusesDeepNesting) {
  const std::string most = repeated("[", 64) + repeated("]", 64);
  EXPECT_EQ(json_from_text<TypeParam>(most, "a.json").dump(), most);
  testing::expect_parts(this->refusal("[" + most + "]"),
                        {"a.json: /0/0/0", "nested too deep", "accepted: up to 64 levels"});
  EXPECT_EQ(this->refusal("{\"a\":[7,[[[0],5],{\"b\":[[[", {.max_depth = 6}),
            "a.json: /a/1/1/b/0/0: nested too deep; accepted: up to 6 levels");
  for (const char* open : {"[", "{\"a\":", "[{\"a\":["})
    testing::expect_parts(this->refusal(repeated(open, 200'000)), {"nested too deep"});
}

TYPED_TEST(ParsedJson, RefusesLongTexts) {
  EXPECT_EQ(this->refusal("[1,2]", {.max_bytes = 4}), "a.json: 5 bytes, more than the limit of 4");
}

TYPED_TEST(ParsedJson, NamesThePlaceOfErrors) {
  testing::expect_parts(this->refusal("[1,\n 2"), {"a.json: line 2, column 3: syntax error"});
  testing::expect_parts(this->refusal(""), {"a.json: line 1, column 1: syntax error"});
  testing::expect_parts(this->refusal("[1]x"), {"column 4"});
  testing::expect_parts(this->refusal("{\"a\":\n-1e999}"),
                        {"a.json: line 2, column 1: -1e999 is not accepted", "1.797e308"});
  testing::expect_parts(this->refusal("[\"\xff\"]"), {"UTF-8"});
}

TYPED_TEST(ParsedJson, IsEmptyWhereTheReasonDoesNotMatter) {
  EXPECT_TRUE(json_if_valid<TypeParam>("{\"a\":1}").has_value());
  EXPECT_FALSE(json_if_valid<TypeParam>("{\"a\":1,\"a\":1}").has_value());
  EXPECT_FALSE(json_if_valid<TypeParam>(repeated("[", 200'000)).has_value());
  EXPECT_FALSE(json_if_valid<TypeParam>("[1").has_value());
}

TEST(OrderedJson, KeepsTheOrderOfKeys) {
  EXPECT_EQ(json_from_text<Ordered>(R"({"b":1,"a":{"d":2,"c":3}})", "a").dump(),
            R"({"b":1,"a":{"d":2,"c":3}})");
  EXPECT_EQ(json_from_text<Json>(R"({"b":1,"a":2})", "a").dump(), R"({"a":2,"b":1})");
}

}  // namespace
}  // namespace trivet
