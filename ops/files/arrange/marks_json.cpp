#include "ops/files/arrange/marks_json.h"

#include "ops/files/arrange/arrangement_json.h"

namespace trivet {
namespace {

// A key of the section, for names and their marks.
nlohmann::json& list_of(const JsonPlace& section, const char* key, nlohmann::json& out) {
  if (const auto list = section.find(key); list && !list->value().is_object())
    list->refuse(say("an object of names and their %1", key));
  return out[key];
}

void add_front(const JsonPlace& front, const std::string& name, nlohmann::json& fronts) {
  read_front(front);
  if (fronts.contains(name))
    front.fail(say("/arrange/fronts has one for \"%1\"; accepted: one front for an object", name));
  fronts[name] = front.value();
}

void add_zones(const JsonPlace& zones, const std::string& name, nlohmann::json& out) {
  std::vector<Zone> read;
  read_zones(zones, name, read);
  nlohmann::json& list = out[name];
  for (const nlohmann::json& zone : zones.value()) list.push_back(zone);
}

void add_surfaces(const JsonPlace& surfaces, const std::string& name, nlohmann::json& out) {
  read_surfaces(surfaces);
  if (out.contains(name))
    surfaces.fail(say(
        "/arrange/surfaces has some for \"%1\"; accepted: those of an object in one place", name));
  out[name] = surfaces.value();
}

}  // namespace

void refuse_marks(const JsonPlace& object) {
  for (const char* const key : {"front", "zones", "surfaces"})
    if (const auto mark = object.find(key))
      mark->fail("there is no section \"arrange\" for it; accepted: beside such a section");
}

nlohmann::json section_with_marks(const JsonPlace& root) {
  const JsonPlace section = root.at("arrange");
  if (!section.value().is_object()) section.refuse("an object, as trivet schema arrange has it");
  nlohmann::json out = section.value();
  for (const JsonPlace& object : root.at("objects").items()) {
    const auto front = object.find("front"), zones = object.find("zones"),
               surfaces = object.find("surfaces");
    if (!front && !zones && !surfaces) continue;
    const std::string name = object.at("name").text();
    if (front) add_front(*front, name, list_of(section, "fronts", out));
    if (zones) add_zones(*zones, name, list_of(section, "zones", out));
    if (surfaces) add_surfaces(*surfaces, name, list_of(section, "surfaces", out));
  }
  return out;
}

}  // namespace trivet
