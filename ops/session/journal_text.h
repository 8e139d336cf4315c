// The lines of a journal. See journal.h.
#pragma once

#include <string>

#include "ops/files/json/text.h"
#include "ops/session/journal.h"

namespace trivet {

using JournalJson = nlohmann::ordered_json;

/// One line with its sum and its end.
std::string journal_line(const JournalJson& json);
/// The line without its end, checked; nullopt when it is torn.
std::optional<nlohmann::json> checked_line(const std::string& line);

JournalJson settle_json(const SettleOptions& options);  // options that are not default
SettleOptions read_settle(const JsonPlace& place);
std::uint64_t read_state(const JsonPlace& place);

JournalJson poses_json(const RecordedPoses& poses);
RecordedPoses read_poses(const JsonPlace& place);
JournalJson models_json(const RecordedModels& models);
RecordedModels read_models(const JsonPlace& place);

JournalJson start_json(const JournalStart& start);
JournalStart read_start(const JsonPlace& place);
JournalRecord read_record(const JsonPlace& place);

}  // namespace trivet
