#include "core/io/sentence_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/io/json.h"

namespace trivet {
namespace {

constexpr int kMaxLevels = 16;
constexpr size_t kMaxParts = 9;
constexpr int kMaxDigits = 17;

nlohmann::ordered_json json_of_sentence(const Sentence& sentence) {
  if (sentence.is_verbatim) return sentence.text;
  if (sentence.number && !std::isfinite(*sentence.number)) return in_english(sentence);
  if (sentence.number) return {{"number", *sentence.number}, {"digits", sentence.digits}};
  nlohmann::ordered_json out = {{"text", sentence.text}};
  for (const Sentence& part : sentence.parts) out["parts"].push_back(json_of_sentence(part));
  return out;
}

std::optional<Sentence> parsed(const nlohmann::ordered_json& json, int level);

bool parse_parts(const nlohmann::ordered_json& json, int level, std::vector<Sentence>& out) {
  if (!json.is_array() || json.size() > kMaxParts) return false;
  for (const nlohmann::ordered_json& part : json) {
    auto one = parsed(part, level + 1);
    if (!one) return false;
    out.push_back(std::move(*one));
  }
  return true;
}

std::optional<Sentence> parsed(const nlohmann::ordered_json& json, int level) {
  if (json.is_string()) return Sentence(json.get<std::string>());
  if (!json.is_object() || level == kMaxLevels) return std::nullopt;
  if (json.contains("number")) {
    const nlohmann::ordered_json digits = json.value("digits", nlohmann::ordered_json());
    if (!json["number"].is_number() || !digits.is_number_integer()) return std::nullopt;
    return figure(json["number"].get<double>(), std::clamp(digits.get<int>(), 1, kMaxDigits));
  }
  const nlohmann::ordered_json text = json.value("text", nlohmann::ordered_json());
  if (!text.is_string()) return std::nullopt;
  Sentence out(text.get_ref<const std::string&>().c_str());
  if (json.contains("parts") && !parse_parts(json["parts"], level, out.parts)) return std::nullopt;
  return out;
}

}  // namespace

std::string to_json(const Sentence& sentence) {
  return json_of_sentence(sentence).dump(-1, ' ', false,
                                         nlohmann::ordered_json::error_handler_t::replace);
}

Sentence sentence_from_json(const std::string& json) {
  const auto document = json_if_valid<nlohmann::ordered_json>(json, {.max_depth = 3 * kMaxLevels});
  const auto sentence = document ? parsed(*document, 0) : std::nullopt;
  return sentence ? *sentence : Sentence(json);
}

}  // namespace trivet
