#include "ops/files/foreign/findings.h"

#include <algorithm>
#include <set>

#include "core/io/foreign/primitives.h"
#include "core/io/mesh_model.h"
#include "core/scene/given_mass.h"
#include "ops/base/stopwatch.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/files/report/verdict.h"
#include "ops/placement/clearance.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

using Kind = SceneFinding::Kind;
using NamePair = std::pair<std::string, std::string>;

constexpr double kMarginSlack = 0.1;  // of a margin, by which objects may be nearer

NamePair sorted_names(const std::string& a, const std::string& b) {
  return a < b ? NamePair(a, b) : NamePair(b, a);
}

class FindingCollector {
 public:
  FindingCollector(const LayoutRun& run, double lift, SceneVerdict& out)
      : m_run(run), m_lift(lift), m_out(out) {}

  void collect() {
    for (const auto& f : m_run.check.touching) m_touching.insert(sorted_names(f.a, f.b));
    const SceneCheck& check = m_run.check;
    for (const auto* findings : {&check.crossings, &check.contained, &check.float32_crossings})
      for (const auto& f : *findings) add_pair(f);
    for (const auto& h : check.hovering) add_floating(h);
    for (const std::string& name : check.not_at_rest)
      if (m_told.insert(name).second)
        m_out.findings.push_back({Kind::NotAtRest, name, "", 0, Vec3::Zero(), way_of(name)});
    for (const ObjectStability& o : m_run.stability.objects) {
      const std::string& name = m_run.scene.at(o.object).name;
      if (o.topples && m_told.insert(name).second)
        m_out.findings.push_back({Kind::Unstable, name, "", 0, Vec3::Zero(), way_of(name)});
    }
    std::stable_sort(m_out.findings.begin(), m_out.findings.end(),
                     [](const SceneFinding& a, const SceneFinding& b) {
                       return a.kind != b.kind ? a.kind < b.kind : a.metres > b.metres;
                     });
  }

 private:
  void add_pair(const SceneCheck::PairFinding& f) {
    const NamePair pair = sorted_names(f.a, f.b);
    if (m_touching.count(pair) || !m_pairs.insert(pair).second) return;
    // The one that may move comes first.
    const bool swapped = f.b != "floor" && is_fixed(f.a) && !is_fixed(f.b);
    const std::string &a = swapped ? f.b : f.a, &b = swapped ? f.a : f.b;
    m_out.findings.push_back(
        {Kind::PassesThrough, a, b, f.depth, f.point - m_lift * Vec3::UnitZ(), ""});
    for (const std::string& name : {a, b}) m_told.insert(name);
  }

  // An object that passes through others has one finding.
  void add_floating(const SceneCheck::Hovering& h) {
    if (m_told.insert(h.name).second)
      m_out.findings.push_back({Kind::Floats, h.name, h.above, h.height, Vec3::Zero(), ""});
  }

  bool is_fixed(const std::string& name) const {
    const auto id = m_run.scene.find(name);
    return id && m_run.scene.at(*id).fixed;
  }

  std::string way_of(const std::string& name) const {
    if (const auto id = m_run.scene.find(name); id && m_run.scene.at(*id).joint)
      return "its joint does not hold it";
    for (const ObjectStability& o : m_run.stability.objects)
      if (o.topples && m_run.scene.at(o.object).name == name)
        return way_text(m_run.scene.at(o.object), o.motion);
    return "";
  }

  const LayoutRun& m_run;
  double m_lift;
  SceneVerdict& m_out;
  std::set<NamePair> m_touching, m_pairs;
  std::set<std::string> m_told;
};

// All objects of a piece as a free one, with their mass.
Object as_one(const Scene& scene, const std::vector<ObjectId>& ids) {
  Object out = scene.at(ids[0]);
  out.pose = {{}, out.pose.translation};
  out.fixed = false;
  out.contacts.clear();
  Mesh mesh;
  double newtons = 0;
  Vec3 moment = Vec3::Zero();
  for (const ObjectId id : ids) {
    const Object& object = scene.at(id);
    Affine in_piece = object.world_from_object();
    in_piece.translation -= out.pose.translation;
    append(object.shape->mesh, in_piece, mesh);
    const double weight = weight_of(object);
    newtons += weight;
    moment += weight * (object.centre_of_mass() - out.pose.translation);
  }
  auto model = std::make_shared<Model>(model_of_mesh(std::move(mesh)));
  out.up = UpAxis::Z, out.scale = 1;
  out.shape = make_shape(model->mesh);
  out.model = std::move(model);
  give_mass({newtons / kGravity, Vec3(moment / newtons), std::nullopt}, out);
  return out;
}

bool weighs(const Scene& scene, const std::vector<ObjectId>& ids) {
  return std::all_of(ids.begin(), ids.end(), [&](ObjectId id) {
    return scene.contains(id) && weight_of(scene.at(id)) > 0;
  });
}

// Pieces that stand free and tip over, slide or sink with their joints as they are. Costs a check
// where there are such pieces.
std::vector<SceneFinding> tipping_pieces(const OpenedScene& opened, const RunOptions& options,
                                         const LayoutRun& run) {
  std::vector<SceneFinding> out;
  if (opened.standing.empty() || !opened.judged.moving_links) return out;
  LayoutRun whole;
  whole.scene = with_moving_links(opened.judged, run.scene);
  whole.settle = run.settle;
  std::vector<std::string> names;
  for (const std::vector<ObjectId>& ids : opened.standing) {
    if (!weighs(whole.scene, ids)) continue;
    Object piece = as_one(whole.scene, ids);
    for (const ObjectId id : ids) whole.scene.remove(id);
    names.push_back(piece.name);
    whole.scene.add(std::move(piece));
  }
  if (names.empty()) return out;
  finish_run(options, whole);
  SceneVerdict verdict = verdict_of(whole, opened.judged.lift);
  for (SceneFinding& f : verdict.findings) {
    const bool moves = f.kind == Kind::NotAtRest || f.kind == Kind::Unstable;
    if (!moves || std::find(names.begin(), names.end(), f.object) == names.end()) continue;
    f.kind = Kind::Unstable;
    out.push_back(std::move(f));
  }
  return out;
}

// Pairs nearer than the file's margins are at rest by contact, and their engine still parts them.
void note_margins(double wanted, SceneVerdict& out) {
  size_t num = 0;
  double most = 0;
  for (const TouchingPair& pair : out.pairs.touching) {
    const double lacking = wanted - pair.gap;
    if (!(lacking > kMarginSlack * wanted)) continue;
    ++num;
    most = std::max(most, lacking);
  }
  if (num > 0)
    out.notes.push_back(
        say("pairs nearer to each other than the file's margins: %1, by up to %2 "
            "mm; their engine moves them apart",
            num, figure(1000 * most)));
}

}  // namespace

const char* to_string(SceneFinding::Kind kind) {
  switch (kind) {
    case Kind::PassesThrough:
      return "passes through";
    case Kind::Floats:
      return "floats";
    case Kind::NotAtRest:
      return "not at rest";
    case Kind::Unstable:
      break;
  }
  return "unstable";
}

size_t SceneVerdict::count(SceneFinding::Kind kind) const {
  return static_cast<size_t>(std::count_if(findings.begin(), findings.end(),
                                           [&](const auto& f) { return f.kind == kind; }));
}

size_t SceneVerdict::num_flush() const {
  return static_cast<size_t>(std::count_if(pairs.touching.begin(), pairs.touching.end(),
                                           [](const TouchingPair& p) { return p.gap <= 0; }));
}

namespace {

// By the time, or as a part has too many objects for a proof.
void name_what_was_left(const LayoutRun& run, SceneVerdict& out) {
  const SceneCheck& check = run.check;
  if (check.num_pairs_not_judged > 0)
    out.unread.push_back(
        say("whether pairs interpenetrate, of %1: the time is over", check.num_pairs_not_judged));
  if (!check.not_judged.empty())
    out.unread.push_back(say("whether objects rest, of %1, among them \"%2\": the time is over",
                             check.not_judged.size(), check.not_judged.front()));
  if (run.stability.status == Stability::Status::Unknown && check.crossings.empty())
    out.unread.push_back(say("whether the whole stands: %1", Sentence(run.stability.why_unknown)));
}

}  // namespace

SceneVerdict verdict_of(const LayoutRun& run, double lift) {
  SceneVerdict out;
  out.pairs = pair_classes(run.scene, run.check);
  out.clearance = run.settle.clearance;
  for (const ObjectId id : run.scene.ids()) {
    ++out.num_objects;
    out.num_free += !run.scene.at(id).fixed;
  }
  if (!(out.clearance > 0)) out.clearance = default_clearance(run.scene);
  FindingCollector(run, lift, out).collect();
  name_what_was_left(run, out);
  return out;
}

void add_what_joints_bear(const OpenedScene& opened, const std::vector<SceneJoint>& joints,
                          const RunOptions& options, const LayoutRun& run, SceneVerdict& out) {
  for (Sentence& note : joints_moved_by_contents(run.scene, joints))
    out.notes.push_back(std::move(note));
  for (SceneFinding& piece : tipping_pieces(opened, options, run))
    out.findings.push_back(std::move(piece));
}

SceneVerdict judge(OpenedScene& opened, const RunOptions& given, LayoutRun* run) {
  const Stopwatch watch;
  RunOptions options = given;
  if (!(options.settle.clearance > 0)) options.settle.clearance = opened.judged.clearance;
  options.topples_alone = true;
  LayoutRun mine;
  LayoutRun& result = run ? *run : mine;
  result.scene = opened.judged.scene;
  result.settle = options.settle;
  result.largest_clearance = kOldClearances * default_clearance(result.scene);
  finish_run(options, result);
  SceneVerdict out = verdict_of(result, opened.judged.lift);
  out.path = opened.path, out.format = opened.format, out.key = opened.key;
  out.num_joints = opened.num_joints;
  out.notes = opened.notes;
  out.unread.insert(out.unread.begin(), opened.unread.begin(), opened.unread.end());
  if (out.num_objects == 0) out.notes.push_back(Sentence("no body of the file collides"));
  if (opened.judged.clearance > 0) note_margins(opened.judged.clearance, out);
  add_what_joints_bear(opened, opened.joints, options, result, out);
  out.milliseconds = watch.milliseconds();
  return out;
}

}  // namespace trivet
