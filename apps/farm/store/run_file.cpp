#include "apps/farm/store/run_file.h"

#include <filesystem>

#include "apps/farm/recipe/set_labels.h"
#include "apps/farm/store/publish.h"
#include "core/base/bad_input.h"
#include "ops/files/json/text.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 30;

std::string path_in(const std::string& out) { return (fs::path(out) / "run.json").string(); }

Json json_of(const BatchRun& run) {
  Json json = {{"trivet_batch", run.file_version},
               {"version", run.version},
               {"seed", run.seed},
               {"count", run.count},
               {"per_unit", run.per_unit},
               {"format", to_string(run.format)},
               {"with_scene", run.with_scene},
               {"with_report", run.with_report},
               {"recipe_sha256", sha256_hex(run.recipe)},
               {"recipe", Json::parse(run.recipe)}};
  if (run.with_contacts) json["with_contacts"] = true;
  if (!run.views.empty()) {
    json["views"] = Json::parse(run.views);
    json["scenes_sha256"] = run.scenes_sha256;
    if (run.with_opengl) json["with_opengl"] = true;
  }
  if (!run.exports.empty()) {
    json["exports"] = run.exports;
    json["scenes_sha256"] = run.scenes_sha256;
  }
  if (run.file_version >= 2) json["sha256"] = sha256_hex(json.dump());
  return json;
}

UnitFormat read_format(const JsonPlace& place) {
  for (const UnitFormat format :
       {UnitFormat::Tar, UnitFormat::Dir, UnitFormat::Poses, UnitFormat::Bop, UnitFormat::Coco})
    if (place.value() == to_string(format)) return format;
  place.refuse("\"tar\", \"dir\", \"poses\", \"bop\" or \"coco\"");
}

int read_file_version(const JsonPlace& place) {
  for (int version = 1; version <= kRunVersion; ++version)
    if (place.value() == version) return version;
  place.refuse(say("1 to %1, of this version of the program", kRunVersion));
}

std::uint64_t read_count(const JsonPlace& place) {
  if (!place.value().is_number_unsigned()) place.refuse("a whole number");
  return place.value().get<std::uint64_t>();
}

std::string shown(const Json& value) {
  const std::string text = value.dump();
  return text.size() > 60 ? text.substr(0, 60) + "..." : text;
}

}  // namespace

std::string BatchRun::id() const {
  if (file_version < 2) return "";
  Json json = json_of(*this);
  for (const char* const key :
       {"trivet_batch", "count", "per_unit", "format", "recipe_sha256", "sha256"})
    json.erase(key);
  json["recipe"] = Json::parse(recipe_of_scenes(recipe));
  return sha256_hex(json.dump());
}

std::string run_json(const BatchRun& run) { return readable_json(json_of(run)); }

bool has_run(const std::string& out) {
  std::error_code ignored;
  return fs::exists(path_in(out), ignored);
}

BatchRun read_run(const std::string& out) {
  const std::string file = path_in(out);
  const std::string text = read_text_file(file, kMaxBytes);
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  root.expect_object(
      {"trivet_batch", "version", "seed", "count", "per_unit", "format", "with_scene",
       "with_report", "recipe_sha256", "recipe"},
      {"with_contacts", "views", "exports", "scenes_sha256", "with_opengl", "sha256"});
  BatchRun run;
  run.file_version = read_file_version(root.at("trivet_batch"));
  run.version = root.at("version").text();
  run.seed = read_count(root.at("seed"));
  run.count = read_count(root.at("count"));
  run.per_unit = read_count(root.at("per_unit"));
  if (run.per_unit == 0) root.at("per_unit").refuse("a whole number from 1");
  run.format = read_format(root.at("format"));
  run.with_scene = root.at("with_scene").boolean();
  run.with_report = root.at("with_report").boolean();
  if (const auto contacts = root.find("with_contacts")) run.with_contacts = contacts->boolean();
  run.recipe = root.at("recipe").value().dump();
  if (const auto views = root.find("views")) {
    run.views = views->value().dump();
    run.scenes_sha256 = root.at("scenes_sha256").text();
    if (const auto opengl = root.find("with_opengl")) run.with_opengl = opengl->boolean();
  }
  if (const auto exports = root.find("exports")) {
    for (const JsonPlace& kind : exports->items()) run.exports.push_back(kind.text());
    run.scenes_sha256 = root.at("scenes_sha256").text();
  }
  if (text != run_json(run))
    bad_file(file, "was changed after it was written: its SHA-256 are not those of its contents");
  return run;
}

void check_run(const std::string& out, const BatchRun& run) {
  if (!has_run(out)) {
    const PublishedFile trial(path_in(out));
    return;
  }
  const BatchRun there = read_run(out);
  if (std::string(run.contents()) != there.contents())
    bad_input("%1: there are %2 in this folder; accepted: another --out", path_in(out),
              there.contents());
  Json ours = json_of(run), theirs = json_of(there);
  for (Json* const json : {&ours, &theirs}) json->erase("sha256");
  ours["with_contacts"] = run.with_contacts, theirs["with_contacts"] = there.with_contacts;
  ours["with_opengl"] = run.with_opengl, theirs["with_opengl"] = there.with_opengl;
  for (const auto& [key, value] : ours.items())
    if (theirs.at(key) != value)
      bad_input(
          "%1: another batch is in this folder: %2 is %3, here %4; accepted: the same recipe, "
          "models, options and version, or another --out",
          path_in(out), key, shown(theirs.at(key)), shown(value));
}

void claim_run(const std::string& out, const BatchRun& run) {
  PublishedFile file(path_in(out));
  file.write(run_json(run));
  if (!file.publish()) check_run(out, run);
}

}  // namespace trivet::farm
