#include "ops/session/dialogue.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/io/json.h"
#include "core/io/model_folder.h"
#include "ops/base/refusal.h"
#include "ops/files/json/operations.h"
#include "ops/files/report/queries.h"
#include "ops/session/others.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAccepted =
    "an operation {\"op\": ...}, {\"do\": [operations]}, {\"undo\": true}, {\"redo\": true}, "
    "{\"mend\": true}, {\"settle\": true}, {\"move_joint\": JOINT, \"to\": VALUE}, "
    "{\"save\": FILE}, {\"query\": OBJECT, \"objects\", \"joints\" or \"check\"} or "
    "{\"cancel\": true}";

// The id of a request, taken out of it.
OrderedJson take_id(nlohmann::json& document, const JsonPlace& place) {
  const auto id = place.find("id");
  // Answers name their request by it.
  if (!id) return {};
  if (!id->value().is_string() && !id->value().is_number()) id->refuse("text or a number");
  OrderedJson out = id->value();
  document.erase("id");
  return out;
}

bool is_asked(const JsonPlace& place, const char* key) {
  const auto value = place.find(key);
  if (value && value->value() != true) value->refuse("true");
  return value.has_value();
}

OrderedJson refused(const std::string& reason) {
  return {{"status", "refused"}, {"reason", reason}};
}

Dialogue::Answer answer_of(const OrderedJson& json) {
  return {json.at("status").get<std::string>(),
          json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace)};
}

void check_texts(const JsonPlace& place, size_t max_bytes) {
  const nlohmann::json& value = place.value();
  if (value.is_string() && value.get_ref<const std::string&>().size() > max_bytes)
    place.fail(say("the text is too long; accepted: up to %1 bytes", max_bytes));
  if (value.is_array())
    for (const JsonPlace& item : place.items()) check_texts(item, max_bytes);
  if (value.is_object())
    for (const auto& item : value.items()) check_texts(place.at(item.key().c_str()), max_bytes);
}

// Rules that hold for the session's steps.
SettleOptions settle_of(const OpenedSession& opened, const SettleOptions& asked) {
  SettleOptions settle = with_rules(asked, opened.rules);
  if (!(settle.clearance > 0)) settle.clearance = opened.clearance;
  return settle;
}

}  // namespace

bool is_cancel_line(const std::string& line) {
  constexpr size_t kLongest = 400;  // longer lines are not worth parsing twice
  if (line.size() > kLongest) return false;
  auto document = json_if_valid<nlohmann::json>(line);
  if (document && document->is_object()) document->erase("id");
  // An id may come along, all else makes it another request.
  return document == nlohmann::json{{"cancel", true}};
}

Dialogue::Dialogue(OpenedSession& opened, DialogueOptions options)
    : m_opened(opened),
      m_session(opened.session),
      m_options(std::move(options)),
      m_told(opened.session.scene()),
      m_state(opened.session.scene()) {
  m_options.settle = settle_of(opened, m_options.settle);
  m_session.limit_history(m_options.max_states);
  // Each step tells the dialogue which objects it changed.
  m_session.on_event([this](const SessionEvent& event) {
    m_changed = event.changed;
    if (m_opened.others && event.kind == SessionEvent::Kind::Performed)
      m_opened.others->forget_from(m_session.num_done());
    m_state.update(m_session.scene(), event.changed);
  });
}

Dialogue::~Dialogue() { m_session.on_event({}); }

Dialogue::Answer Dialogue::greeting() const { return answer_of(state()); }

Dialogue::Answer Dialogue::answer(const std::string& line, const std::atomic<bool>& cancelled) {
  // The request may be cancelled by another thread while it runs.
  m_options.context.cancel = &cancelled;
  m_changed.clear();
  const OrderedJson out = answered(line);
  m_options.context.cancel = nullptr;
  return answer_of(out);
}

OrderedJson Dialogue::answered(const std::string& line) {
  OrderedJson id, out;
  try {
    nlohmann::json document = parse_json(line, m_options.source);
    // The id is taken first, so that refusals have it, too.
    const JsonPlace place(document, m_options.source);
    id = take_id(document, place);
    out = done(document, place);
    // News of poses come with every answer: clients need not ask.
    out["poses"] = m_told.news(m_session.scene(), m_changed);
  } catch (const Error& e) {
    out = {{"status", "error"}, {"reason", e.what()}};
  }
  if (!id.is_null()) out["id"] = id;
  return out;
}

OrderedJson Dialogue::done(const nlohmann::json& document, const JsonPlace& place) {
  // Texts are bounded before any of them is looked up or kept.
  if (m_options.max_text_bytes > 0) check_texts(place, m_options.max_text_bytes);
  if (place.find("op")) {
    const std::vector<Operation> operations{read(place)};
    check_room(operations, place);
    return perform(operations);
  }
  if (place.find("move_joint")) return move_joint(place);
  // All other requests have one key alone.
  if (document.size() != 1) place.refuse(kAccepted);
  if (const auto operations = place.find("do")) return perform(read_all(*operations));
  if (is_asked(place, "undo")) return undo();
  if (is_asked(place, "redo"))
    return m_session.redo() ? state() : refused("there is nothing to redo");
  if (is_asked(place, "cancel")) return state();  // cancelled when it was read
  if (const auto how = place.find("mend")) return mend(*how);
  if (const auto how = place.find("settle")) return settle(*how);
  if (const auto file = place.find("save")) return save(*file);
  if (const auto what = place.find("query")) return query(*what);
  place.refuse(kAccepted);
}

Operation Dialogue::read(const JsonPlace& place) const {
  Operation operation = read_operation(place);
  // Scenes of other programs keep their objects: operations only move them.
  if (m_opened.others && !is_for_others(operation))
    place.at("op").refuse(
        "operations that move objects: a scene of another program keeps its objects");
  const auto* const append = std::get_if<AppendOperation>(&operation);
  if (append && m_options.own_files) {
    // A client of a server reads models of the start's folder alone.
    const fs::path file = fs::path(m_opened.model_folder) / append->model;
    if (!ModelFolder(m_opened.start_file).has(file))
      place.at("model").refuse("a file in the folder of the start, or below it");
  }
  return operation;
}

std::vector<Operation> Dialogue::read_all(const JsonPlace& place) const {
  std::vector<Operation> operations;
  for (const JsonPlace& item : place.items()) operations.push_back(read(item));
  if (operations.empty()) place.refuse("an array of at least one operation");
  check_room(operations, place);
  return operations;
}

// Before anything is done: objects that the same line deletes count, too.
void Dialogue::check_room(const std::vector<Operation>& operations, const JsonPlace& place) const {
  if (m_options.max_objects == 0) return;
  // Each of these operations adds one object.
  const auto num_new = static_cast<size_t>(
      std::count_if(operations.begin(), operations.end(), [](const Operation& o) {
        return std::holds_alternative<AppendOperation>(o) ||
               std::holds_alternative<DuplicateOperation>(o) ||
               std::holds_alternative<DrapeOperation>(o);
      }));
  const size_t there = m_session.scene().num_objects();
  if (num_new > 0 && there + num_new > m_options.max_objects)
    place.fail(say("the session has %1 objects, and %2 more are too many; accepted: up to %3",
                   there, num_new, m_options.max_objects));
}

OrderedJson Dialogue::state() const {
  OrderedJson json = {{"status", "ok"}};
  // Forgotten steps count, so that numbers never fall.
  json["done"] = m_session.num_forgotten() + m_session.num_done();
  json["steps"] = m_session.num_forgotten() + m_session.steps().size();
  json["state"] = hash_text(m_state.value(m_session.scene()));
  json["modified"] = m_session.is_modified();
  return json;
}

OrderedJson Dialogue::perform(const std::vector<Operation>& operations) {
  const OperationResult result =
      m_session.perform_all(operations, m_options.settle, m_options.context);
  // A refusal leaves the session as it was, and says why.
  if (!result.ok()) {
    OrderedJson json = {{"status", to_string(result.status)}};
    add_refusal(result, json);
    return json;
  }
  OrderedJson json = state();
  add_outcome(result, json);
  if (operations.size() == 1) return json;
  // Several operations are one step: each has its own result.
  const std::vector<OperationResult>& results = m_session.steps()[m_session.num_done() - 1].results;
  json["results"] = OrderedJson::array();
  for (size_t i = 0; i < operations.size(); ++i) {
    json["results"].push_back(
        {{"op", op_name(operations[i])}, {"object", object_name(operations[i])}});
    add_outcome(results[i], json["results"].back());
  }
  return json;
}

OrderedJson Dialogue::undo() {
  if (m_session.undo()) return state();
  const size_t forgotten = m_session.num_forgotten();
  if (forgotten == 0) return refused("there is nothing to undo");
  return refused("the first " + std::to_string(forgotten) +
                 " steps cannot be undone any more: this session keeps " +
                 std::to_string(m_options.max_states) + " states of objects");
}

OrderedJson Dialogue::save(const JsonPlace& file) {
  // A server writes no file for its clients.
  if (m_options.own_files)
    file.fail("this server writes no files; it answers with a scene's bytes");
  // Another program's scene is written back in its own format.
  if (m_opened.others) {
    m_opened.others->write(m_session, file.text());
    m_session.mark_saved(file.text());
    return state();
  }
  if (fs::path(file.text()).extension() != ".glb")
    throw Error(Error::Kind::BadInput, "%1: cannot be saved; accepted: a file name ending in .glb",
                file.text());
  save_session(m_opened, m_options.version, file.text());
  return state();
}

OrderedJson Dialogue::query(const JsonPlace& what) const {
  if (what.value() == "objects") return objects();
  if (what.value() == "joints") return joint_list();
  if (what.value() == "check") return check();
  if (!what.value().is_object()) return object(what.text());
  what.expect_object({"object"}, {});  // also one that is called "objects" or "check"
  return object(what.at("object").text());
}

OrderedJson Dialogue::object(const std::string& name) const {
  const auto id = m_session.scene().find(name);
  if (!id) return refused(message(unknown_object(m_session.scene(), name)));
  OrderedJson json = OrderedJson::parse(object_query_json(m_session.scene(), *id, {}));
  json["status"] = "ok";
  return json;
}

OrderedJson Dialogue::objects() const {
  OrderedJson list = OrderedJson::array();
  for (const ObjectId id : m_session.scene().ids()) {
    const Object& object = m_session.scene().at(id);
    OrderedJson json = {{"object", object.name},
                        {"model", object.model->path},
                        {"state", to_string(object.state)},
                        {"fixed", object.fixed},
                        {"locked", object.locked}};
    if (!object.group.empty()) json["group"] = object.group;
    add_pose(object, json);
    list.push_back(std::move(json));
  }
  OrderedJson out = state();
  out["objects"] = std::move(list);
  return out;
}

}  // namespace trivet
