#include "ops/session/journal_text.h"

#include "core/base/hash.h"
#include "ops/files/json/operation_json.h"
#include "ops/files/json/settle_json.h"
#include "ops/files/layout/layout.h"

namespace trivet {
namespace {

constexpr int kJournalVersion = 1;
constexpr double kMaxBytes = 1e15;
const char* const kSumKey = ",\"sum\":\"";
constexpr size_t kSumSize = 8 + 16 + 2;  // ,"sum":"0123456789abcdef"}

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
  nlohmann::json json = nlohmann::json::parse(text + "}", nullptr, false);
  if (!json.is_object()) return std::nullopt;
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
                           "max_motions", "accept_wedged"});
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

JournalJson start_json(const JournalStart& start) {
  return {{"trivet_journal", kJournalVersion},
          {"start", {{"file", start.file}, {"bytes", start.bytes}, {"hash", start.hash}}},
          {"settle", settle_json(start.settle)},
          {"state", hash_text(start.state)}};
}

JournalStart read_start(const JsonPlace& place) {
  place.expect_object({"trivet_journal", "start", "settle", "state"}, {});
  const JsonPlace version = place.at("trivet_journal");
  if (version.value() != kJournalVersion)
    version.refuse(say("%1, the version of the journal", kJournalVersion));
  const JsonPlace file = place.at("start");
  file.expect_object({"file", "bytes", "hash"}, {});
  JournalStart start;
  start.file = file.at("file").text();
  start.bytes = static_cast<std::uintmax_t>(file.at("bytes").number(0, kMaxBytes));
  start.hash = file.at("hash").text();
  start.settle = read_settle(place.at("settle"));
  start.state = read_state(place.at("state"));
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
    place.expect_object({"do", "settle", "state"}, {});
    record.kind = JournalRecord::Kind::Step;
    if (!operation->value().is_array())
      record.operations.push_back(read_operation(*operation));
    else
      for (const JsonPlace& item : operation->items())
        record.operations.push_back(read_operation(item));
    if (record.operations.empty()) operation->refuse("an operation or several");
    record.settle = read_settle(place.at("settle"));
  } else {
    const bool undo = place.find("undo").has_value();
    place.expect_object({undo ? "undo" : "redo", "state"}, {});
    record.kind = undo ? JournalRecord::Kind::Undo : JournalRecord::Kind::Redo;
  }
  record.state = read_state(place.at("state"));
  return record;
}

}  // namespace trivet
