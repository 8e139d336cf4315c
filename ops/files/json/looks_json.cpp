#include "ops/files/json/looks_json.h"

#include <set>

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

void read_flags(const JsonPlace& place, bool& hidden, bool& not_selectable) {
  if (const auto flag = place.find("hidden")) hidden = flag->boolean();
  if (const auto flag = place.find("not_selectable")) not_selectable = flag->boolean();
}

void write_flags(bool hidden, bool not_selectable, Json& json) {
  if (hidden) json["hidden"] = true;
  if (not_selectable) json["not_selectable"] = true;
}

ObjectLook read_object_look(const JsonPlace& place) {
  place.expect_object({"name"}, {"hidden", "not_selectable", "colour"});
  ObjectLook look;
  look.object = place.at("name").text();
  read_flags(place, look.hidden, look.not_selectable);
  if (const auto colour = place.find("colour")) {
    const std::vector<double> c = colour->numbers(3, 0, 1);
    look.colour = {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
  }
  return look;
}

void expect_new(const JsonPlace& place, std::set<std::string>& known, const char* accepted) {
  if (!known.insert(place.text()).second) place.refuse(accepted);
}

}  // namespace

SceneLooks read_looks(const JsonPlace& place) {
  place.expect_object({}, {"objects", "collections"});
  SceneLooks out;
  std::set<std::string> shown, members, names;
  if (const auto looks = place.find("objects"))
    for (const JsonPlace& item : looks->items()) {
      out.objects.push_back(read_object_look(item));
      expect_new(item.at("name"), shown, "each object once");
    }
  if (const auto collections = place.find("collections"))
    for (const JsonPlace& item : collections->items()) {
      item.expect_object({"name", "objects"}, {"hidden", "not_selectable"});
      ObjectCollection& collection = out.collections.emplace_back();
      collection.name = item.at("name").text();
      expect_new(item.at("name"), names, "each name once");
      read_flags(item, collection.hidden, collection.not_selectable);
      const std::vector<JsonPlace> objects = item.at("objects").items();
      collection.objects.reserve(objects.size());
      for (const JsonPlace& object : objects) {
        collection.objects.push_back(object.text());
        expect_new(object, members, "an object in one collection");
      }
    }
  return out;
}

Json looks_json(const SceneLooks& looks) {
  Json json = Json::object();
  for (const ObjectLook& look : looks.objects) {
    Json entry = {{"name", look.object}};
    write_flags(look.hidden, look.not_selectable, entry);
    if (look.colour) entry["colour"] = *look.colour;
    json["objects"].push_back(std::move(entry));
  }
  for (const ObjectCollection& collection : looks.collections) {
    Json entry = {{"name", collection.name}};
    write_flags(collection.hidden, collection.not_selectable, entry);
    entry["objects"] = collection.objects;
    json["collections"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace trivet
