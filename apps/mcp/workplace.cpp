#include "apps/mcp/workplace.h"

#include <filesystem>

#include "apps/mcp/wording.h"
#include "core/base/count_of.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/quoted.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/others.h"

namespace trivet::mcp {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostTextBytes = 4096;
const std::atomic<bool> kNever{false};

bool is_of_others(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".glb" || extension == ".gltf") return !is_scene_file(path);
  return extension != ".json" && is_scene_of_others(path);
}

DialogueOptions dialogue_options(const WorkplaceOptions& options) {
  DialogueOptions out;
  out.settle = options.run.settle;
  out.context = options.run.context;
  out.version = options.version;
  out.source = "arguments";
  out.own_files = !options.saves;
  out.max_states = options.max_states;
  out.max_objects = options.max_objects;
  out.max_text_bytes = kMostTextBytes;
  return out;
}

// Lines of sessions have a key "op", which is the name of the tool here.
std::string for_tools(std::string reason) {
  for (const std::string words : {"accepted: op, ", "required: op, "})
    if (const size_t at = reason.find(words); at != reason.npos)
      reason.erase(at + words.size() - 4, 4);
  return reason;
}

Answer failed(const Json& answer) {
  const std::string cause = answer.value("cause", std::string());
  Answer out;
  const std::string reason = for_tools(answer.value("reason", std::string()));
  out.text = answer.at("status").get<std::string>() + ": " + reason + "\nNext: " + next_step(cause);
  out.data = answer;
  if (!reason.empty()) out.data["reason"] = reason;
  out.is_error = true;
  return out;
}

// Without most of what is long.
Json shortened(Json answer) {
  constexpr size_t kMostPoses = 50;
  const auto poses = answer.find("poses");
  if (poses == answer.end() || poses->size() <= kMostPoses) return answer;
  answer["more_poses"] = poses->size() - kMostPoses;
  poses->erase(poses->begin() + kMostPoses, poses->end());
  return answer;
}

bool is_ok(const Json& answer) { return answer.at("status") == "ok"; }

}  // namespace

Workplace::Workplace(WorkplaceOptions options)
    : m_options(std::move(options)),
      m_root((fs::path(m_options.folder) / "scene.json").string()),
      m_cancelled(&kNever) {}
Workplace::~Workplace() = default;

void Workplace::use(Detector* detector) {
  m_options.run.context.detector = detector;
  if (m_place) m_place->dialogue.use(detector);
}

std::string Workplace::scene_file() const {
  if (place().opened.others)
    throw Error(Error::Kind::BadInput,
                "%1: a scene of another program has no such file; accepted: `trivet mcp`, which "
                "saves it",
                m_name);
  return scene_bytes(place().opened, m_options.version);
}

Workplace::Place& Workplace::place() const {
  if (m_place) return *m_place;
  throw Error(Error::Kind::BadInput,
              "no scene is open; accepted: `open` first, without \"file\" for an empty room");
}

const Scene& Workplace::scene() const { return place().opened.session.scene(); }

Json Workplace::ask(const Json& line) const {
  return Json::parse(place().dialogue.answer(line.dump(), *m_cancelled).text);
}

// The path of a file in the folder.
std::string Workplace::inside(const JsonPlace& file) const {
  std::string path = (fs::path(m_options.folder) / file.text()).lexically_normal().string();
  if (!m_root.holds(path)) file.refuse("a file in the folder of this server, or below it");
  return path;
}

OpenedSession Workplace::empty_room() const {
  const std::string file = (fs::path(m_options.folder) / "room.json").string();
  const SettleRules rules = rules_of(settle_options(m_options.run, {}));
  Layout layout;
  layout.floor = true;
  layout.settle = rules;
  return {Session(Scene(), std::move(layout),
                  models_in_folder(folder_of(file), m_options.others.limits)),
          file,
          folder_of(file),
          0,
          {},
          rules};
}

OpenedSession Workplace::opened_at(const std::string& file) const {
  RunOptions run = m_options.run;
  run.context.cancel = m_cancelled;
  run.layout_file = file;
  if (is_of_others(file)) return open_session_of_others(file, m_options.others, run.settle);
  return open_session(file, run, m_options.others.limits);
}

void Workplace::enter(OpenedSession opened) {
  m_place.reset();
  m_place = std::make_unique<Place>(std::move(opened), dialogue_options(m_options));
}

Answer Workplace::open(const JsonPlace& arguments) {
  arguments.expect_object({}, {"file"});
  const auto file = arguments.find("file");
  if (file && !m_root.has(inside(*file)))
    file->refuse("a file in the folder of this server; `list` with \"what\": \"files\" names them");
  enter(file ? opened_at(inside(*file)) : empty_room());
  m_name = file ? file->text() : "an empty room";
  size_t num_placed = 0;
  for (const ObjectId id : scene().ids()) num_placed += scene().at(id).placed;
  Answer out;
  out.text = m_name + ": " + count_of(scene().num_objects(), "object") + ", " +
             std::to_string(num_placed) + " in the scene; " +
             (scene().floor ? "a floor at z = 0" : "no floor") + "; metres, z up.";
  for (const Sentence& note : place().opened.notes) out.text += "\nnote: " + in_english(note);
  out.text += scene().num_objects() ? "\nNext: `list`, `look` or `check`."
                                    : "\nNext: `list` with \"what\": \"files\" names models; "
                                      "`append` brings them, `put` puts them down.";
  return out;
}

// Files of models: the agent is trusted with the folder alone.
void Workplace::check_model(const JsonPlace& arguments) const {
  const auto model = arguments.find("model");
  if (!model || !model->value().is_string()) return;
  const fs::path path = fs::path(place().opened.model_folder) / model->text();
  if (!m_root.has(path))
    model->refuse(
        "a file in the folder of this server; `list` with \"what\": \"files\" names them");
}

Answer Workplace::operation(const std::string& op, const JsonPlace& arguments) {
  if (!arguments.value().is_object()) arguments.refuse("an object");
  if (op == "append") check_model(arguments);
  Json line = {{"op", op}};
  line.update(Json(arguments.value()));
  line["op"] = op;
  const Json answer = ask(line);
  if (!is_ok(answer)) return failed(answer);
  Answer out;
  const std::string name = line.value("object", Json()).is_string()
                               ? " " + quoted(line["object"].get<std::string>())
                               : std::string();
  out.text = outcome_text(op + name, answer, scene());
  if (op == "append" || op == "duplicate") out.text += "\nNext: `put` it.";
  out.data = shortened(answer);
  return out;
}

Answer Workplace::repaired(const char* what, const JsonPlace& arguments) {
  const Json line = {{what, arguments.value().empty() ? Json(true) : Json(arguments.value())}};
  const Json answer = ask(line);
  if (!is_ok(answer)) return failed(answer);
  return {repair_text(what, answer), shortened(answer)};
}

Answer Workplace::mend(const JsonPlace& arguments) { return repaired("mend", arguments); }
Answer Workplace::settle(const JsonPlace& arguments) { return repaired("settle", arguments); }

Answer Workplace::move_joint(const JsonPlace& arguments) {
  arguments.expect_object({"joint"}, {"to", "by"});
  Json line = {{"move_joint", arguments.at("joint").text()}};
  for (const char* const key : {"to", "by"})
    if (const auto value = arguments.find(key)) line[key] = Json(value->value());
  const Json answer = ask(line);
  if (!is_ok(answer)) return failed(answer);
  return {joint_text(answer), shortened(answer)};
}

Answer Workplace::stepped(const char* what, const JsonPlace& arguments) {
  arguments.expect_object({}, {});
  const Json answer = ask({{what, true}});
  if (!is_ok(answer)) return failed(answer);
  Answer out{outcome_text(what, answer, scene()), shortened(answer)};
  out.text += "\n" + count_of(answer.at("done").get<size_t>(), "step") + " done of " +
              std::to_string(answer.at("steps").get<size_t>()) + ".";
  return out;
}

Answer Workplace::undo(const JsonPlace& arguments) { return stepped("undo", arguments); }
Answer Workplace::redo(const JsonPlace& arguments) { return stepped("redo", arguments); }

Answer Workplace::save(const JsonPlace& arguments) {
  arguments.expect_object({"file"}, {});
  const JsonPlace file = arguments.at("file");
  const std::string path = inside(file);
  std::error_code ignored;
  if (fs::exists(path, ignored) && !m_written.count(path))
    file.refuse("a name that no file has yet: nothing is overwritten but what was saved here");
  const Json answer = ask({{"save", path}});
  if (!is_ok(answer)) return failed(answer);
  m_written.insert(path);
  return {"saved " + file.text() + " with " + count_of(scene().num_objects(), "object") + ".",
          answer};
}

}  // namespace trivet::mcp
