#include "ops/session/journal_text.h"

#include "core/base/hash.h"
#include "core/io/json.h"
#include "ops/files/json/operations.h"
#include "ops/files/json/settle_json.h"
#include "ops/files/layout/layout.h"

namespace trivet {
namespace {

constexpr int kJournalVersion = 2;  // 1: without poses and models
constexpr double kMaxBytes = 1e15;
const char* const kSumKey = ",\"sum\":\"";
constexpr size_t kSumSize = 8 + 16 + 2;  // ,"sum":"0123456789abcdef"}

// To the bit, whatever its length.
Pose read_recorded_pose(const JsonPlace& place) {
  const std::vector<double> n = place.numbers(7);
  Pose pose;
  pose.translation = Vec3(n[0], n[1], n[2]);
  const auto rotation = unit_rotation({n[3], n[4], n[5], n[6]});
  if (!rotation || !(pose.translation.cwiseAbs().maxCoeff() <= kMaxLength))
    place.refuse("a position and a rotation w, x, y, z");
  pose.rotation = *rotation;
  return pose;
}

RecordedModel read_model_record(const JsonPlace& place) {
  place.expect_object({"model", "up", "fingerprint", "box"}, {"chord", "facet_angle_deg"});
  RecordedModel model;
  model.request.name = place.at("model").text();
  model.request.tessellation = read_tessellation(place, model.request.name);
  model.up = read_up(place.at("up"));
  model.fingerprint = hash_text(read_state(place.at("fingerprint")));
  const std::vector<double> box = place.at("box").numbers(6);
  model.box = {Vec3(box[0], box[1], box[2]), Vec3(box[3], box[4], box[5])};
  if (!(model.box.lower.array() <= model.box.upper.array()).all())
    place.at("box").refuse("its lower corner, then its upper one");
  return model;
}

std::string sum_of(const std::string& text) { return Hash().add(text).text(); }

}  // namespace

std::string journal_line(const JournalJson& json) {
  std::string text = json.dump(-1, ' ', false, JournalJson::error_handler_t::replace);
  text.pop_back();  // }
  return text + kSumKey + sum_of(text) + "\"}\n";
}

std::optional<nlohmann::json> checked_line(const std::string& line) {
  if (line.size() <= kSumSize) return std::nullopt;
  const std::string text = line.substr(0, line.size() - kSumSize);
  if (line.substr(text.size()) != kSumKey + sum_of(text) + "\"}") return std::nullopt;
  std::optional<nlohmann::json> json = json_if_valid<nlohmann::json>(text + "}");
  if (!json || !json->is_object()) return std::nullopt;
  return json;
}

JournalJson settle_json(const SettleOptions& options) {
  const SettleOptions usual;
  JournalJson json = JournalJson::object();
  if (options.clearance != usual.clearance) json["clearance"] = options.clearance;
  json.update(settle_rules_json(rules_of(options)));
  if (options.max_motions != usual.max_motions) json["max_motions"] = options.max_motions;
  if (options.accept_wedged) json["accept_wedged"] = true;
  return json;
}

SettleOptions read_settle(const JsonPlace& place) {
  place.expect_object({}, {"clearance", "literal_paper_rules", "perfect_friction", "whole_at_rest",
                           "robust", "max_motions", "accept_wedged"});
  SettleOptions options = with_rules(with_rules({}, kRulesBefore), read_settle_rules(place));
  if (const auto p = place.find("clearance")) options.clearance = p->number(0, kMaxLength);
  if (const auto p = place.find("max_motions"))
    options.max_motions = static_cast<int>(p->number(1, 1e9));
  if (const auto p = place.find("accept_wedged")) options.accept_wedged = p->boolean();
  return options;
}

std::uint64_t read_state(const JsonPlace& place) {
  const std::string text = place.text();
  std::uint64_t state = 0;
  for (const char c : text) {
    const size_t digit = std::string("0123456789abcdef").find(c);
    if (text.size() != 16 || digit == std::string::npos) place.refuse("16 hexadecimal digits");
    state = state << 4 | digit;
  }
  return state;
}

JournalJson poses_json(const RecordedPoses& poses) {
  JournalJson json = JournalJson::object();
  for (const auto& [object, pose] : poses) {
    if (!pose) {
      json[object] = nullptr;
      continue;
    }
    const Vec3& t = pose->translation;
    const Rotation& r = pose->rotation;
    json[object] = {t.x(), t.y(), t.z(), r.w, r.x, r.y, r.z};
  }
  return json;
}

RecordedPoses read_poses(const JsonPlace& place) {
  if (!place.value().is_object()) place.refuse("an object of poses");
  RecordedPoses out;
  for (const auto& [name, value] : place.value().items()) {
    const JsonPlace pose = place.at(name.c_str());
    out.push_back({name, value.is_null() ? std::nullopt : std::optional(read_recorded_pose(pose))});
  }
  return out;
}

JournalJson models_json(const RecordedModels& models) {
  JournalJson out = JournalJson::array();
  for (const RecordedModel& model : models) {
    const auto& [lower, upper] = model.box;
    JournalJson json = {
        {"model", model.request.name},
        {"up", model.up == UpAxis::Y ? "y" : "z"},
        {"fingerprint", model.fingerprint},
        {"box", {lower.x(), lower.y(), lower.z(), upper.x(), upper.y(), upper.z()}}};
    write_tessellation(model.request.tessellation, json);
    out.push_back(std::move(json));
  }
  return out;
}

RecordedModels read_models(const JsonPlace& place) {
  RecordedModels out;
  for (const JsonPlace& item : place.items()) out.push_back(read_model_record(item));
  return out;
}

JournalJson start_json(const JournalStart& start) {
  JournalJson json = {
      {"trivet_journal", kJournalVersion},
      {"start", {{"file", start.file}, {"bytes", start.bytes}, {"hash", start.hash}}},
      {"settle", settle_json(start.settle)},
      {"state", hash_text(start.state)},
      {"models", models_json(start.models)}};
  if (start.poses) json["poses"] = poses_json(*start.poses);
  if (start.keep_models) json["keep_models"] = true;
  return json;
}

JournalStart read_start(const JsonPlace& place) {
  place.expect_object({"trivet_journal", "start", "settle", "state"},
                      {"models", "poses", "keep_models"});
  const JsonPlace version = place.at("trivet_journal");
  if (version.value() != 1 && version.value() != kJournalVersion)
    version.refuse(say("1 and %1, the versions of journals", kJournalVersion));
  const JsonPlace file = place.at("start");
  file.expect_object({"file", "bytes", "hash"}, {});
  JournalStart start;
  start.of_earlier_version = version.value() == 1;
  start.file = file.at("file").text();
  start.bytes = static_cast<std::uintmax_t>(file.at("bytes").number(0, kMaxBytes));
  start.hash = file.at("hash").text();
  start.settle = read_settle(place.at("settle"));
  start.state = read_state(place.at("state"));
  if (const auto models = place.find("models")) start.models = read_models(*models);
  if (const auto poses = place.find("poses")) start.poses = read_poses(*poses);
  if (const auto keep = place.find("keep_models")) start.keep_models = keep->boolean();
  return start;
}

JournalRecord read_record(const JsonPlace& place) {
  JournalRecord record{};
  if (const auto file = place.find("saved")) {
    place.expect_object({"saved"}, {});
    record.kind = JournalRecord::Kind::Saved;
    record.file = file->text();
    return record;
  }
  if (const auto operation = place.find("do")) {
    place.expect_object({"do", "settle", "state"}, {"models", "poses"});
    record.kind = JournalRecord::Kind::Step;
    if (!operation->value().is_array())
      record.operations.push_back(read_operation(*operation));
    else
      for (const JsonPlace& item : operation->items())
        record.operations.push_back(read_operation(item));
    record.settle = read_settle(place.at("settle"));
    if (const auto models = place.find("models")) record.models = read_models(*models);
    if (const auto poses = place.find("poses")) record.poses = read_poses(*poses);
    if (record.operations.empty() && !record.poses)
      operation->refuse("an operation or several, or \"poses\"");
  } else {
    const bool undo = place.find("undo").has_value();
    place.expect_object({undo ? "undo" : "redo", "state"}, {});
    record.kind = undo ? JournalRecord::Kind::Undo : JournalRecord::Kind::Redo;
  }
  record.state = read_state(place.at("state"));
  return record;
}

}  // namespace trivet
