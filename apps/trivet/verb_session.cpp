#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/trivet/cancellable_lines.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/scene/fingerprint.h"
#include "ops/layout/json_text.h"
#include "ops/layout/operation_json.h"
#include "ops/report/json_parts.h"
#include "ops/report/queries.h"
#include "ops/session/journal.h"
#include "ops/session/restore.h"

namespace trivet::apps {
namespace {

using Json = nlohmann::ordered_json;

struct SessionArguments {
  std::string start, journal;
  SettleArguments settle;
};

constexpr const char* kAccepted =
    "an operation {\"op\": ...}, {\"undo\": true}, {\"redo\": true}, {\"save\": FILE}, "
    "{\"query\": OBJECT} or {\"cancel\": true}";

OpenedSession open(const SessionArguments& arguments, const CommonOptions& common,
                   Detector& detector) {
  RunOptions options = run_options(common, arguments.settle, &detector);
  if (!arguments.start.empty())
    return open_session(arguments.start, options, common.limits(), arguments.journal);
  if (arguments.journal.empty())
    throw Error(Error::Kind::BadInput,
                "missing START; accepted: a layout, a scene, or --journal to restore");
  RestoredSession restored = restore_session(arguments.journal, options, common.limits(), true);
  if (!restored.exact) throw Error(Error::Kind::BadInput, restored.opened.notes.back());
  return std::move(restored.opened);
}

const char* to_string(OperationResult::Status status) {
  switch (status) {
    case OperationResult::Status::Ok:
      return "ok";
    case OperationResult::Status::Refused:
      return "refused";
    case OperationResult::Status::Cancelled:
      return "cancelled";
    case OperationResult::Status::OutOfTime:
      return "out of time";
  }
  return "?";
}

class Dialogue {
 public:
  Dialogue(OpenedSession& opened, const SessionArguments& arguments, Detector& detector)
      : m_opened(opened), m_session(opened.session), m_settle(arguments.settle.settle) {
    m_context.detector = &detector;
    m_context.time_budget_s = arguments.settle.operation_seconds;
    if (!(m_settle.clearance > 0)) m_settle.clearance = opened.clearance;
  }

  Json state() const {
    Json json = {{"status", "ok"}};
    json["done"] = m_session.num_done();
    json["steps"] = m_session.steps().size();
    json["state"] = hash_text(fingerprint(m_session.scene()));
    json["modified"] = m_session.is_modified();
    return json;
  }

  // Answers each line with a line; errors in a line are its answer.
  Json answer(const InputLine& line) {
    m_context.cancel = &line.cancelled;
    try {
      const nlohmann::json document = parse_json(line.text, "standard input");
      const JsonPlace place(document, "standard input");
      if (place.find("op")) return perform(read_operation(place));
      if (document.size() != 1) place.refuse(kAccepted);
      if (is_asked(place, "undo")) return step(m_session.undo(), "there is nothing to undo");
      if (is_asked(place, "redo")) return step(m_session.redo(), "there is nothing to redo");
      if (is_asked(place, "cancel")) return state();  // cancelled when it was read
      if (const auto file = place.find("save")) return save(file->text());
      if (const auto object = place.find("query")) return query(object->text());
      place.refuse(kAccepted);
    } catch (const Error& e) {
      return {{"status", "error"}, {"reason", e.what()}};
    }
  }

 private:
  Json perform(const Operation& operation) {
    const OperationResult result = m_session.perform(operation, m_settle, m_context);
    if (!result.ok()) {
      Json json = {{"status", to_string(result.status)}};
      add_refusal(result, json);
      return json;
    }
    Json json = state();
    add_outcome(result, json);
    return json;
  }

  static bool is_asked(const JsonPlace& place, const char* key) {
    const auto value = place.find(key);
    if (value && value->value() != true) value->refuse("true");
    return value.has_value();
  }

  Json step(bool done, const char* otherwise) const {
    if (done) return state();
    return {{"status", "refused"}, {"reason", otherwise}};
  }

  Json save(const std::string& file) {
    if (extension_of(file) != ".glb")
      throw Error(Error::Kind::BadInput,
                  file + ": cannot be saved; accepted: a file name ending in .glb");
    save_session(m_opened, TRIVET_VERSION, file);
    return state();
  }

  Json query(const std::string& name) const {
    const auto id = m_session.scene().find(name);
    if (!id) return {{"status", "refused"}, {"reason", "there is no object \"" + name + "\""}};
    Json json = Json::parse(object_query_json(m_session.scene(), *id, {}));
    json["status"] = "ok";
    return json;
  }

  OpenedSession& m_opened;
  Session& m_session;
  SettleOptions m_settle;
  RunContext m_context;
};

bool is_cancel(const std::string& line) {
  constexpr size_t kLongest = 100;  // longer lines are not worth parsing twice
  if (line.size() > kLongest) return false;
  const auto document = nlohmann::json::parse(line, nullptr, false);
  return document == nlohmann::json{{"cancel", true}};
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == line.npos; }

int session(const SessionArguments& arguments, const CommonOptions& common) {
  const std::unique_ptr<Detector> detector = make_detector(common);
  OpenedSession opened = open(arguments, common, *detector);
  clear_progress_line(common);
  for (const std::string& note : opened.notes) print_note(common, note);
  Dialogue dialogue(opened, arguments, *detector);
  const auto tell = [](const Json& json) {
    std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
  };
  tell(dialogue.state());
  CancellableLines lines(std::cin, is_cancel);
  while (const auto line = lines.next())
    if (!is_blank(line->text)) tell(dialogue.answer(*line));
  tell_work(*detector, common, nullptr);
  return 0;
}

}  // namespace

Verb add_session(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "session",
      "Run operations interactively: each line of JSON on standard input is answered by a line on "
      "standard output. A line is an operation as in a layout, {\"undo\": true}, {\"redo\": true}, "
      "{\"save\": \"x.glb\"}, {\"query\": \"object\"} or "
      "{\"cancel\": true}, which stops unfinished operations before it");
  const auto arguments = std::make_shared<SessionArguments>();
  verb->add_option("start", arguments->start,
                   "Initial layout or scene; default: restore the journal")
      ->type_name("SCENE.glb|LAYOUT.json");
  verb->add_option("--journal", arguments->journal,
                   "Record every step on disk, so that a crashed session can be restored");
  add_settle_options(*verb, arguments->settle);
  return {verb, [arguments, &common] { return session(*arguments, common); }};
}

}  // namespace trivet::apps
