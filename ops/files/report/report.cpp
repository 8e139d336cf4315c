#include "ops/files/report/report.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "ops/check/pair_classes.h"
#include "ops/files/json/settle_json.h"
#include "ops/files/json/text.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/models_of_shapes.h"

namespace trivet {
namespace {

constexpr int kReportVersion = 1;

// The load-support list, with whom the forces that balance the whole have carry an object, too.
LoadSupport with_carriers(const Scene& scene, const Stability& stability, LoadSupport list) {
  std::map<std::uint32_t, LoadSupport::Entry*> entry_of;
  for (LoadSupport::Entry& e : list.entries) entry_of[e.object.index] = &e;
  for (const CarriedBy& c : carried_by_forces(scene, stability)) {
    LoadSupport::Entry& e = *entry_of.at(c.object.index);
    if (c.by.is_floor())
      e.on_floor = true;
    else if (std::find(e.supports.begin(), e.supports.end(), c.by.object()) == e.supports.end())
      e.supports.push_back(c.by.object());
  }
  for (LoadSupport::Entry& e : list.entries)
    std::sort(e.supports.begin(), e.supports.end(),
              [](ObjectId a, ObjectId b) { return a.index < b.index; });
  return list;
}

OrderedJson objects_json(const Scene& scene, const Stability& stability,
                         const ReportOptions& options) {
  const LoadSupport load_support_list = with_carriers(scene, stability, load_support(scene));
  std::map<std::uint32_t, const LoadSupport::Entry*> entry_of;
  for (const LoadSupport::Entry& e : load_support_list.entries) entry_of[e.object.index] = &e;

  OrderedJson json = OrderedJson::array();
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    const auto it = entry_of.find(id.index);
    json.push_back(object_json(scene, object, it == entry_of.end() ? nullptr : it->second,
                               joined_path(options.model_folder, model_path(object))));
  }
  return json;
}

OrderedJson operation_json(const OperationRecord& record) {
  const OperationResult& result = record.result;
  OrderedJson json = {
      {"op", record.op}, {"object", record.object}, {"status", result.ok() ? "ok" : "refused"}};
  add_refusal(result, json);
  json["motions"] = result.num_motions;
  json["milliseconds"] = result.milliseconds;
  if (result.ok()) add_outcome(result, json);
  return json;
}

OrderedJson operations_json(const std::vector<OperationRecord>& operations) {
  OrderedJson json = OrderedJson::array();
  for (const OperationRecord& record : operations) json.push_back(operation_json(record));
  return json;
}

void append_pairs(const std::vector<SceneCheck::PairFinding>& findings, const char* kind,
                  OrderedJson& json) {
  for (const SceneCheck::PairFinding& f : findings)
    json.push_back({{"a", f.a},
                    {"b", f.b},
                    {"kind", kind},
                    {"count", f.count},
                    {"depth", f.depth},
                    {"point", to_json(f.point)}});
}

OrderedJson check_json(const Scene& scene, const SceneCheck& check) {
  OrderedJson pairs = OrderedJson::array();
  append_pairs(check.crossings, "crossing", pairs);
  append_pairs(check.float32_crossings, "float32_crossing", pairs);
  append_pairs(check.contained, "contained", pairs);
  append_pairs(check.touching, "touching", pairs);
  OrderedJson hovering = OrderedJson::array();
  for (const SceneCheck::Hovering& h : check.hovering)
    hovering.push_back({{"name", h.name},
                        {"above", h.above.empty() ? OrderedJson() : OrderedJson(h.above)},
                        {"height", h.above.empty() ? OrderedJson() : OrderedJson(h.height)}});
  const PairClasses classes = pair_classes(scene, check);
  return {{"interpenetrating_pairs", check.interpenetrating_pairs()},
          {"pairs_passing_through", classes.num_through},
          {"pairs_touching", classes.touching.size()},
          {"pairs_apart", classes.num_apart},
          {"smallest_gap", check.smallest_gap},
          {"all_at_rest", check.not_at_rest.empty()},
          {"pairs", std::move(pairs)},
          {"not_at_rest", check.not_at_rest},
          {"hovering", std::move(hovering)}};
}

OrderedJson importer_json(const Protection& protection) {
  return {{"sandbox", parts_of(protection)}, {"lacking", lacking_in(protection)}};
}

OrderedJson work_json(const DetectionWork& work) {
  return {{"queries", work.num_queries},
          {"early_queries", work.early},
          {"body_pairs", work.zlist.body_pairs},
          {"pixels", work.zlist.pixels},
          {"doubtful_pixels", work.zlist.doubtful_pixels},
          {"proposed_face_pairs", work.zlist.face_pairs},
          {"asked_face_pairs", work.zlist.asked_pairs},
          {"confirmed_face_pairs", work.zlist.confirmed_pairs},
          {"lists_by_gpu", work.zlist.gpu_lists},
          {"lists_in_software", work.zlist.software_lists},
          {"draws", work.zlist.draws},
          {"read_backs", work.zlist.read_backs},
          {"bytes_read_back", work.zlist.bytes_read_back},
          {"fallbacks", work.fallbacks},
          {"places", work.places},
          {"places_on_gpu", work.places_on_gpu},
          {"node_pairs", work.node_pairs},
          {"decided_face_pairs", work.face_pairs},
          {"stalled_queries", work.stalled}};
}

}  // namespace

std::string report_json(const LayoutRun& run, const ReportOptions& options) {
  OrderedJson json = {{"trivet", kReportVersion},
                      {"version", options.version},
                      {"backend", options.backend},
                      {"device", options.device},
                      {"gpu_method", options.gpu_method},
                      {"gpu_lists", options.gpu_lists},
                      {"confirmation", options.confirmation}};
  if (options.importer) json["importer"] = importer_json(*options.importer);
  if (options.work) json["work"] = work_json(*options.work);
  if (!options.arrangement.empty()) json["arrange"] = OrderedJson::parse(options.arrangement);
  json["settle"] = settle_rules_json(rules_of(run.settle));
  json["objects"] = objects_json(run.scene, run.stability, options);
  json["operations"] = operations_json(run.operations);
  json["check"] = check_json(run.scene, run.check);
  json["stability"] = stability_json(run.scene, run.stability);
  return readable_json(json);
}

std::string joined_path(const std::string& folder, const std::string& path) {
  if (folder.empty() || path.empty()) return path;  // "": of no file
  return (std::filesystem::path(folder) / path).lexically_normal().generic_string();
}

}  // namespace trivet
