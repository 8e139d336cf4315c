// Binary glTF with damage where readers trust it: numbers, types and references of its JSON, its
// chunks, its data.
#pragma once

#include <cstdint>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace trivet::test {

namespace mutation {

using Json = nlohmann::ordered_json;

inline void collect(const Json& value, const std::string& place, std::vector<std::string>& out) {
  if (!place.empty()) out.push_back(place);
  if (value.is_array())
    for (size_t i = 0; i < value.size(); ++i)
      collect(value[i], place + "/" + std::to_string(i), out);
  if (value.is_object())
    for (const auto& [key, item] : value.items())
      if (key.find_first_of("~/") == key.npos) collect(item, place + "/" + key, out);
}

/// Small numbers are references to other items, large ones overflow.
template <class Random>
Json value(Random& random) {
  static const char* const texts[] = {"0",
                                      "1",
                                      "2",
                                      "3",
                                      "-1",
                                      "7",
                                      "255",
                                      "5121",
                                      "5123",
                                      "5125",
                                      "5126",
                                      "65536",
                                      "2147483648",
                                      "4294967295",
                                      "1e300",
                                      "0.5",
                                      "-0.0",
                                      "9007199254740992",
                                      "18446744073709551615",
                                      "null",
                                      "true",
                                      "\"\"",
                                      "\"VEC3\"",
                                      "\"SCALAR\"",
                                      "[]",
                                      "{}",
                                      "[0]",
                                      "[[]]",
                                      "{\"a\":0}"};
  return Json::parse(texts[random.below(std::size(texts))]);
}

template <class Random>
void change_json(Json& json, Random& random) {
  std::vector<std::string> places;
  collect(json, "", places);
  if (places.empty()) return;
  const Json::json_pointer at(places[random.below(places.size())]);
  const Json::json_pointer from(places[random.below(places.size())]);
  switch (random.below(4)) {
    case 0:
      json = json.patch(Json::array({{{"op", "remove"}, {"path", at.to_string()}}}));
      break;
    case 1: {
      const Json copy = json[from];
      json[at] = copy;
      break;
    }
    case 2:
      if (json[at].is_array() && !json[at].empty()) {
        const Json first = json[at].front();
        json[at].push_back(first);
        break;
      }
      [[fallthrough]];
    default:
      json[at] = value(random);
  }
}

}  // namespace mutation

/// @param glb  whole and padded. @param random  has below(limit).
template <class Random>
std::string mutated_gltf(const std::string& glb, Random& random) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof length);
  mutation::Json json = mutation::Json::parse(glb.substr(20, length));
  std::string data = glb.size() > 28 + length ? glb.substr(28 + length) : "";
  for (size_t i = 0, times = random.below(4); i < times; ++i) mutation::change_json(json, random);
  for (size_t i = 0, times = random.below(3); !data.empty() && i < times; ++i)
    data[random.below(data.size())] = static_cast<char>(random.below(256));
  std::string text = json.dump();
  text.append(random.below(8) ? (4 - text.size() % 4) % 4 : random.below(4), ' ');
  const auto word = [](size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&number), sizeof number);
  };
  std::string out = glb.substr(0, 8) + word(28 + text.size() + data.size()) + word(text.size()) +
                    "JSON" + text + word(data.size()) + std::string("BIN\0", 4) + data;
  if (random.below(8) == 0) out[random.below(28)] = static_cast<char>(random.below(256));
  if (random.below(8) == 0) out.resize(random.below(out.size()));
  return out;
}

}  // namespace trivet::test
