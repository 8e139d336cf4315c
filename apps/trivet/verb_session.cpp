#include <csignal>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/trivet/cancellable_lines.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/scene_input.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/nearest_name.h"
#include "core/scene/fingerprint.h"
#include "ops/files/json/json_text.h"
#include "ops/files/json/operation_json.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/queries.h"
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
    "an operation {\"op\": ...}, {\"do\": [operations]}, {\"undo\": true}, {\"redo\": true}, "
    "{\"save\": FILE}, {\"query\": OBJECT or \"objects\"} or {\"cancel\": true}";

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

// Pose of an object as the last answer gave it.
struct ToldPose {
  std::string name;
  std::optional<Pose> pose;  // nullopt: out of the scene
};

bool same_bits(const std::optional<Pose>& a, const std::optional<Pose>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const Rotation &r = a->rotation, &s = b->rotation;
  return a->translation == b->translation && r.w == s.w && r.x == s.x && r.y == s.y && r.z == s.z;
}

std::optional<Pose> pose_of(const Object& object) {
  if (!object.placed) return std::nullopt;
  return object.pose;
}

void add_pose(const std::optional<Pose>& pose, Json& json) {
  json["position"] = pose ? to_json(pose->translation) : Json();
  json["rotation"] = Json();
  if (pose)
    json["rotation"] = {pose->rotation.w, pose->rotation.x, pose->rotation.y, pose->rotation.z};
}

// Poses that the client knows, and changes since.
class ToldPoses {
 public:
  explicit ToldPoses(const Scene& scene) {
    for (const ObjectId id : scene.ids()) {
      const Object& object = scene.at(id);
      m_told[key(id)] = {object.name, pose_of(object)};
    }
  }

  /// Every object of these that is elsewhere, came or went.
  Json news(const Scene& scene, const std::vector<ObjectId>& changed) {
    Json out = Json::array();
    for (const ObjectId id : changed) {
      const auto told = m_told.find(key(id));
      const bool known = told != m_told.end(), here = scene.contains(id);
      if (!known && !here) continue;
      const ToldPose now = here ? ToldPose{scene.at(id).name, pose_of(scene.at(id))}
                                : ToldPose{told->second.name, std::nullopt};
      if (!known || !same_bits(told->second.pose, now.pose)) {
        out.push_back({{"object", now.name}});
        add_pose(now.pose, out.back());
      }
      if (here)
        m_told[key(id)] = now;
      else
        m_told.erase(told);
    }
    return out;
  }

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;
  static Key key(ObjectId id) { return {id.index, id.generation}; }
  std::map<Key, ToldPose> m_told;
};

// The id of a request, taken out of it.
Json take_id(nlohmann::json& document, const JsonPlace& place) {
  const auto id = place.find("id");
  if (!id) return {};
  if (!id->value().is_string() && !id->value().is_number()) id->refuse("text or a number");
  Json out = id->value();
  document.erase("id");
  return out;
}

class Dialogue {
 public:
  Dialogue(OpenedSession& opened, const SessionArguments& arguments, Detector& detector)
      : m_opened(opened),
        m_session(opened.session),
        m_settle(with_rules(arguments.settle.settle, opened.rules)),
        m_told(opened.session.scene()),
        m_state(opened.session.scene()) {
    m_context.detector = &detector;
    m_context.time_budget_s = arguments.settle.operation_seconds;
    if (!(m_settle.clearance > 0)) m_settle.clearance = opened.clearance;
    m_session.on_event([this](const SessionEvent& event) {
      m_changed = event.changed;
      m_state.update(m_session.scene(), event.changed);
    });
  }
  ~Dialogue() { m_session.on_event({}); }
  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;

  Json state() const {
    Json json = {{"status", "ok"}};
    json["done"] = m_session.num_done();
    json["steps"] = m_session.steps().size();
    json["state"] = hash_text(m_state.value(m_session.scene()));
    json["modified"] = m_session.is_modified();
    return json;
  }

  // Answers each line with a line; errors in a line are its answer.
  Json answer(const InputLine& line) {
    m_context.cancel = &line.cancelled;
    m_changed.clear();
    Json id;
    Json out;
    try {
      nlohmann::json document = parse_json(line.text, "standard input");
      const JsonPlace place(document, "standard input");
      id = take_id(document, place);
      out = done(document, place);
      out["poses"] = m_told.news(m_session.scene(), m_changed);
    } catch (const Error& e) {
      out = {{"status", "error"}, {"reason", e.what()}};
    }
    if (!id.is_null()) out["id"] = id;
    return out;
  }

 private:
  Json done(const nlohmann::json& document, const JsonPlace& place) {
    if (place.find("op")) return perform({read_operation(place)});
    if (document.size() != 1) place.refuse(kAccepted);
    if (const auto operations = place.find("do")) return perform(read_all(*operations));
    if (is_asked(place, "undo")) return step(m_session.undo(), "there is nothing to undo");
    if (is_asked(place, "redo")) return step(m_session.redo(), "there is nothing to redo");
    if (is_asked(place, "cancel")) return state();  // cancelled when it was read
    if (const auto file = place.find("save")) return save(file->text());
    if (const auto what = place.find("query")) return query(*what);
    place.refuse(kAccepted);
  }

  static std::vector<Operation> read_all(const JsonPlace& place) {
    std::vector<Operation> operations;
    for (const JsonPlace& item : place.items()) operations.push_back(read_operation(item));
    if (operations.empty()) place.refuse("an array of at least one operation");
    return operations;
  }

  Json perform(const std::vector<Operation>& operations) {
    const OperationResult result = m_session.perform_all(operations, m_settle, m_context);
    if (!result.ok()) {
      Json json = {{"status", to_string(result.status)}};
      add_refusal(result, json);
      return json;
    }
    Json json = state();
    add_outcome(result, json);
    if (operations.size() == 1) return json;
    json["results"] = Json::array();
    for (size_t i = 0; i < operations.size(); ++i) {
      json["results"].push_back(
          {{"op", op_name(operations[i])}, {"object", object_name(operations[i])}});
      add_outcome(m_session.steps()[m_session.num_done() - 1].results[i], json["results"].back());
    }
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

  Json query(const JsonPlace& what) const {
    if (what.value() == "objects") return objects();
    if (!what.value().is_object()) return object(what.text());
    what.expect_object({"object"}, {});  // also one that is called "objects"
    return object(what.at("object").text());
  }

  Json object(const std::string& name) const {
    const auto id = m_session.scene().find(name);
    if (!id)
      return {{"status", "refused"},
              {"reason", "there is no object \"" + name + "\"" +
                             did_you_mean(name, names_of(m_session.scene()))}};
    Json json = Json::parse(object_query_json(m_session.scene(), *id, {}));
    json["status"] = "ok";
    return json;
  }

  Json objects() const {
    Json list = Json::array();
    for (const ObjectId id : m_session.scene().ids()) {
      const Object& object = m_session.scene().at(id);
      Json json = {{"object", object.name},
                   {"model", object.model->path},
                   {"state", trivet::to_string(object.state)},
                   {"fixed", object.fixed},
                   {"locked", object.locked}};
      if (!object.group.empty()) json["group"] = object.group;
      add_pose(pose_of(object), json);
      list.push_back(std::move(json));
    }
    Json out = state();
    out["objects"] = std::move(list);
    return out;
  }

  OpenedSession& m_opened;
  Session& m_session;
  SettleOptions m_settle;
  RunContext m_context;
  ToldPoses m_told;
  SceneState m_state;
  std::vector<ObjectId> m_changed;  // by the line that is being answered
};

bool is_cancel(const std::string& line) {
  constexpr size_t kLongest = 400;  // longer lines are not worth parsing twice
  if (line.size() > kLongest) return false;
  auto document = nlohmann::json::parse(line, nullptr, false);
  if (document.is_object()) document.erase("id");
  return document == nlohmann::json{{"cancel", true}};
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == line.npos; }

// Ends the session when its answers cannot be written.
void tell(const Json& json) {
  std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
  if (!std::cout)
    throw Error(Error::Kind::Environment,
                "the answers of the session cannot be written to the standard output; it ends "
                "after the last step that was done");
}

int session(const SessionArguments& arguments, const CommonOptions& common) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is an error like others
  const std::unique_ptr<Detector> detector = make_detector(common);
  OpenedSession opened = open(arguments, common, *detector);
  clear_progress_line(common);
  for (const std::string& note : opened.notes) print_note(common, note);
  Dialogue dialogue(opened, arguments, *detector);
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
      "standard output; the first line of output greets. A line is an operation as in a layout, "
      "{\"do\": [operations]} for several as one step, {\"undo\": true}, {\"redo\": true}, "
      "{\"save\": \"x.glb\"}, {\"query\": \"NAME\"} for an object, {\"query\": \"objects\"} for "
      "all, or {\"cancel\": true}, which stops unfinished operations before it. An "
      "\"id\" in a line, text or a number, comes back in its answer. Answers have \"status\" (ok, "
      "refused, cancelled, out of time, error) and \"reason\", or the number of steps done and "
      "\"poses\" of all that moved, came or went");
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
