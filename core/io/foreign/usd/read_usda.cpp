#include "core/io/foreign/usd/read_usda.h"

#include <algorithm>

#include "core/base/bad_input.h"
#include "core/io/foreign/tag_text.h"
#include "core/io/foreign/usd/usda_bodies.h"
#include "core/io/foreign/usd/usda_shapes.h"

namespace trivet {
namespace {

// Counts of a stage hold for all layers: an over layer repeats them.
constexpr const char* kStageMetadata[] = {"defaultPrim",        "endTimeCode",   "framesPerSecond",
                                          "kilogramsPerUnit",   "metersPerUnit", "startTimeCode",
                                          "timeCodesPerSecond", "upAxis"};

std::string text_in_quotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out += '"';
}

std::vector<std::pair<std::string, std::string>> metadata_of(const UsdaSpec& root) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const char* name : kStageMetadata) {
    const UsdaEntry* const entry = find_entry(root.metadata, name);
    if (!entry) continue;
    if (!entry->value.words.empty())
      out.emplace_back(name, text_in_quotes(entry->value.words[0].second));
    else if (entry->value.numbers.size() == 1)
      out.emplace_back(name, with_numbers("", entry->value.numbers));
  }
  return out;
}

double positive_unit(const UsdaLayer& layer, const char* name, double otherwise) {
  const UsdaEntry* const entry = find_entry(layer.root.metadata, name);
  if (!entry) return otherwise;
  const double value = entry->value.numbers.size() == 1 ? entry->value.numbers[0] : 0;
  if (!(value > 0) || !(value < 1e12))
    bad_file(layer.path, "line %1: %2; accepted: a number above 0", entry->line, std::string(name));
  return value;
}

UsdaUnits units_of(const UsdaLayer& layer, ForeignScene& scene) {
  UsdaUnits out;
  out.metres = positive_unit(layer, "metersPerUnit", 0.01);
  out.kilograms = positive_unit(layer, "kilogramsPerUnit", 1);
  if (!find_entry(layer.root.metadata, "metersPerUnit"))
    note_once(scene.notes, Sentence("metersPerUnit is not stated: 0.01, as USD has it"));
  const std::string up = usda_word(find_entry(layer.root.metadata, "upAxis"));
  if (!up.empty() && up != "Y" && up != "Z")
    bad_file(layer.path, "upAxis = \"%1\"; accepted: \"Y\", \"Z\"", up);
  out.root.linear = out.metres * Mat3::Identity();
  if (up == "Z")
    out.up = Vec3::UnitZ();
  else
    out.root.pose.rotation = turn_about(Vec3::UnitX(), 90).normalized();
  return out;
}

// References do not convert units: the layers' own ones have to be the same.
void note_other_units(const UsdaStage& stage, const UsdaUnits& units, ForeignScene& scene) {
  for (const auto& layer : stage.layers) {
    const UsdaEntry* const entry = find_entry(layer->root.metadata, "metersPerUnit");
    if (entry && entry->value.numbers != std::vector<double>{units.metres})
      note_once(scene.notes, say("%1: its metersPerUnit is not that of the scene, which USD does "
                                 "not convert",
                                 layer->path));
  }
}

/// Overs by the names of prims.
struct OverTree {
  std::map<std::string, OverTree> children;
  std::vector<std::string> lines;

  void add(const std::string& path, std::vector<std::string> its_lines) {
    OverTree* at = this;
    for (size_t begin = 1; begin < path.size();) {
      const size_t end = std::min(path.find('/', begin), path.size());
      at = &at->children[path.substr(begin, end - begin)];
      begin = end + 1;
    }
    at->lines = std::move(its_lines);
  }

  void write(size_t depth, std::string& out) const {
    const std::string indent(4 * depth, ' ');
    for (const std::string& line : lines) out += indent + line + "\n";
    for (const auto& [name, child] : children) {
      out += "\n" + indent + "over " + text_in_quotes(name) + "\n" + indent + "{\n";
      child.write(depth + 1, out);
      out += indent + "}\n";
    }
  }
};

bool is_same_place(const Pose& a, const Pose& b) {
  const Rotation &r = a.rotation, &s = b.rotation;
  return a.translation == b.translation && r.w == s.w && r.x == s.x && r.y == s.y && r.z == s.z;
}

}  // namespace

ForeignScene read_usda(const std::string& path, const ForeignOptions& options, const MeshSource&) {
  ForeignScene out;
  out.format = "USD";
  UsdaBodies all;
  all.stage = compose_usda(path, options.limits, options.roots, out.unread);
  for (const auto& layer : all.stage.layers) out.files.push_back({layer->path, "", 0});
  all.units = units_of(*all.stage.layers.front(), out);
  note_other_units(all.stage, all.units, out);
  collect_usda_bodies(options, all, out);
  connect_usda_bodies(all, out);
  std::erase_if(out.bodies, [](const ForeignBody& b) { return b.colliders.empty(); });
  if (out.bodies.empty())
    note_once(out.unread, Sentence("no prim has a PhysicsCollisionAPI: nothing collides"));
  out.usda = std::make_shared<UsdaSource>(
      UsdaSource{std::move(all.places), metadata_of(all.stage.layers.front()->root)});
  return out;
}

std::string usda_over_layer(const ForeignScene& scene, const std::map<size_t, Pose>& poses,
                            const std::string& below) {
  OverTree overs;
  for (const auto& [i, pose] : poses) {
    const ForeignBody& body = scene.bodies.at(i);
    if (is_same_place(body.pose, pose)) continue;
    if (body.place.kind != PosePlace::Kind::Prim)
      bad_input("\"%1\" has no place for a pose in %2: %3", body.name, scene.files[0].path,
                body.place.why_not);
    for (const UsdaPlace& place : scene.usda->places.at(body.place.number))
      overs.add(place.path, usda_pose_lines(place, composed(body.pose, place.in_body),
                                            composed(pose, place.in_body)));
  }
  const std::string mark = below.find('@') == std::string::npos ? "@" : "@@@";
  std::string out = "#usda 1.0\n(\n";
  for (const auto& [name, value] : scene.usda->metadata)
    out += "    " + name + " = " + value + "\n";
  out += "    subLayers = [\n        " + mark + below + mark + "\n    ]\n)\n";
  overs.write(0, out);
  return out;
}

}  // namespace trivet
