#include "apps/trivet/outputs.h"

#include <algorithm>
#include <cstring>
#include <iostream>
#include <set>
#include <sstream>

#include "core/base/count_of.h"
#include "core/base/extension.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/staged_files.h"
#include "core/mesh/part_masses.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/report/repaired.h"
#include "ops/files/report/verdict.h"
#include "ops/placement/clearance.h"
#include "ops/simulation/scene_formats.h"

namespace trivet::apps {
namespace {

/// @param what, one  in the plural, and of a single one.
void append_findings(std::ostringstream& out, const std::vector<SceneCheck::PairFinding>& findings,
                     const char* what, const char* one) {
  for (const SceneCheck::PairFinding& f : findings)
    out << "  \"" << f.a << "\" and \"" << f.b << "\": " << f.count << " "
        << (f.count == 1 ? one : what) << ", " << f.depth << " m deep near (" << f.point.x() << ", "
        << f.point.y() << ", " << f.point.z() << ")\n";
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "\"" : ", \"") + name + "\"";
  return out;
}

// Summary of a completed move for display: a line, or "" if done as requested.
std::string end_of(const OperationRecord& record) {
  const OperationResult& r = record.result;
  using End = OperationResult::End;
  std::string out;
  if (record.op == "stand" && r.moved > 0) out += ": moved apart from what it touches";
  if (r.end == End::Blocked) out += ": blocked by \"" + r.blocked_by.name + "\"";
  if (r.end == End::Step) out += ": stopped by a step, \"" + r.blocked_by.name + "\"";
  if (r.end == End::Edge) out += ": stopped at an edge";
  if (r.end == End::Limit) out += ": stopped at its limit";
  if (r.tried && r.tried->number > 1) out += ": " + start_text(*r.tried);
  if (!r.interpenetrates.empty()) out += "; passes through " + quoted_list(r.interpenetrates);
  if (!r.gave_way.empty()) out += "; gave way: " + gave_way_text(r.gave_way);
  if (!r.unsound.empty())
    out += "; below it " + quoted_list(r.unsound) + (r.unsound.size() > 1 ? " are" : " is") +
           " held, unsupported or invalid";
  if (!r.unsupported.empty()) out += "; leaves unsupported: " + quoted_list(r.unsupported);
  if (r.repaired) return record.op + ": " + mended_text(*r.repaired);
  return out.empty() ? "" : record.op + " \"" + record.object + "\"" + out + "\n";
}

std::string hovering_text(const SceneCheck& check, const std::string& name) {
  for (const SceneCheck::Hovering& h : check.hovering) {
    if (h.name != name) continue;
    if (h.above.empty()) return ": it hovers above nothing";
    std::ostringstream out;
    out << ": it hovers " << h.height << " m above \"" << h.above << "\"";
    return out.str();
  }
  return "";
}

std::string check_summary(const SceneCheck& check) {
  std::ostringstream out;
  out << "check: " << (check.ok() ? "ok" : "failed") << ", " << check.interpenetrating_pairs()
      << " interpenetrating pairs of faces, ";
  if (check.smallest_gap < kInfinity) out << "smallest gap " << check.smallest_gap << " m, ";
  out << (check.not_at_rest.empty() ? "all at rest" : "not all at rest") << "\n";
  append_findings(out, check.crossings, "pairs of faces interpenetrate",
                  "pair of faces interpenetrates");
  append_findings(out, check.float32_crossings, "pairs of faces interpenetrate in float32",
                  "pair of faces interpenetrates in float32");
  append_findings(out, check.contained, "parts of the first are inside the second",
                  "part of the first is inside the second");
  for (const SceneCheck::PairFinding& f : check.touching)
    out << "  note: \"" << f.a << "\" and \"" << f.b << "\" only touch, by " << f.depth << " m\n";
  for (const std::string& name : check.not_at_rest)
    out << "  \"" << name << "\" is not at rest" << hovering_text(check, name) << "\n";
  return out.str();
}

// Empty without a GPU.
std::string lists_summary(const Detector& detector) {
  if (detector.lists().empty()) return "";
  const ZListWork& work = detector.work().zlist;
  return "    by the GPU (" + detector.method() + ") in " + std::to_string(work.gpu_lists) +
         " queries, in software in " + std::to_string(work.software_lists) + " (" +
         detector.lists() + ")\n    " + std::to_string(work.draws) + " draws, " +
         std::to_string(work.read_backs) + " read-backs; " + std::to_string(detector.work().early) +
         " queries asked together with others, early\n";
}

std::string pairs_summary(const LayoutRun& run) {
  const PairClasses pairs = pair_classes(run.scene, run.check);
  if (pairs.num_judged() == 0) return "";
  const double given = run.settle.clearance;
  return pairs_text(pairs, given > 0 ? given : default_clearance(run.scene)) + "\n";
}

// Statistics of the paper's three stages and of the narrow phase, for display.
std::string work_summary(const Detector& detector) {
  const DetectionWork& work = detector.work();
  std::ostringstream out;
  out << "work of " << detector.name() << " (" << detector.device() << "): " << work.num_queries
      << " queries\n";
  if (detector.name() != "bvh")
    out << "  stage 1, boxes: " << work.zlist.body_pairs << " candidate pairs of objects\n"
        << "  stage 2, depths: " << work.zlist.pixels << " pixels with both sides\n"
        << "  stage 3, lists: " << work.zlist.doubtful_pixels << " doubtful pixels, "
        << work.zlist.face_pairs << " candidate pairs of faces, " << work.zlist.bytes_read_back
        << " bytes read back\n"
        << lists_summary(detector) << "  stage 4, Embree (" << to_string(detector.confirmation())
        << "): " << work.zlist.confirmed_pairs << " of " << work.zlist.asked_pairs
        << " pairs of faces confirmed\n"
        << "  given up, answered by BVHs: " << work.fallbacks << " queries\n";
  if (work.places > 0)
    out << "  places judged: " << work.places << ", on the GPU " << work.places_on_gpu << "\n";
  out << "  BVHs: " << work.node_pairs << " pairs of boxes\n"
      << "  narrow phase: " << work.face_pairs << " pairs of faces\n";
  return out.str();
}

}  // namespace

void tell_work(const Detector& detector, const CommonOptions& common, ReportOptions* report) {
  if (common.verbose) std::cerr << work_summary(detector);
  if (!report) return;
  report->backend = detector.name();
  report->device = detector.device();
  report->gpu_method = detector.method();
  report->gpu_lists = detector.lists();
  report->confirmation = to_string(detector.confirmation());
  report->importer = import_protection();
  report->work = detector.work();
}

void add_output_options(CLI::App& app, OutputPaths& paths) {
  app.add_option(
      "-o,--output", paths.scene,
      "Write the scene: .glb, .gltf, .obj, .ply, .stl, or a simulator format of trivet export");
  app.add_option("--report", paths.report, "Write the report, JSON");
  app.add_option("--picture", paths.picture, "Write a picture, .png");
  app.add_flag("--allow-unstable", paths.allow_unstable,
               "Exit with 0 even if the scene does not stand as a whole");
}

Outputs::Outputs(const OutputPaths& paths, const CommonOptions& common,
                 const PictureRequest& picture)
    : m_paths(paths), m_common(common) {
  PictureRequest request = picture;
  request.device = common.detection().device;
  request.num_threads = common.num_threads;
  if (!paths.picture.empty()) m_picture = std::make_unique<PictureMaker>(request);
}

namespace {

// On what the models' files have and is left out, each once.
void print_model_notes(const Scene& scene, const CommonOptions& common) {
  std::set<std::string> told;
  for (const ObjectId id : scene.ids()) {
    const std::shared_ptr<const Model> model = scene.at(id).model;
    if (!model) continue;
    std::vector<Sentence> notes = model->notes;
    for (auto& note : mass_notes(scene.at(id).shape->mass)) notes.push_back(std::move(note));
    for (const Sentence& note : notes)
      if (const Sentence said = say("%1: %2", model->path, note);
          told.insert(in_english(said)).second)
        print_note(common, said);
  }
}

// Layout that gives the same scene again.
Layout with_rules_of(const LayoutRun& run, Layout layout) {
  layout.settle = rules_of(run.settle);
  return layout;
}

}  // namespace

int Outputs::write(const LayoutRun& run, const Layout& layout, const RunOptions& options,
                   const ModelFolders& folders, const GltfScene* in_place) {
  ReportOptions report_options;
  report_options.version = TRIVET_VERSION;
  report_options.model_folder = folders.in_report;
  report_options.arrangement = m_arrangement;
  if (options.context.detector) tell_work(*options.context.detector, m_common, &report_options);
  const std::string report = report_json(run, report_options);
  // Everything that can fail, except the disk, comes first; a picture takes a while.
  check_not_inputs(m_paths.all(), {});
  const std::string png = m_picture ? m_picture->png(run.scene) : "";
  clear_progress_line(m_common);
  print_model_notes(run.scene, m_common);
  StagedFiles beside;  // a full disk leaves none of all
  if (!m_paths.report.empty()) beside.add(m_paths.report, report);
  if (m_picture) beside.add(m_paths.picture, png);
  const std::string extension = lower_extension(m_paths.scene);
  if (in_place && (extension == ".glb" || extension == ".gltf"))
    in_place->write(m_paths.scene);
  else if (!m_paths.scene.empty())
    write_in_any_format(run.scene, with_rules_of(run, layout),
                        {TRIVET_VERSION, folders.in_scene, run.settle.clearance}, m_paths.scene);
  beside.commit();
  if (m_common.json)
    std::cout << report;
  else if (!m_common.quiet)
    std::cout << summary(run);
  const bool stands = m_paths.allow_unstable || !has_finite_friction(run.settle) ||
                      run.stability.status != Stability::Status::Unstable;
  return run.ok() && stands ? 0 : 1;
}

std::string summary(const LayoutRun& run) {
  std::ostringstream out;
  size_t num_refused = 0;
  for (const OperationRecord& record : run.operations) {
    if (record.result.ok()) {
      out << end_of(record);
      continue;
    }
    ++num_refused;
    out << record.op << " \"" << record.object << "\": refused: " << record.result.reason() << "\n";
  }
  size_t num_placed = 0;
  const std::vector<ObjectId> ids = run.scene.ids();
  for (const ObjectId id : ids) num_placed += run.scene.at(id).placed;
  out << count_of(ids.size(), "object") << ", " << num_placed << " in the scene; "
      << count_of(run.operations.size(), "operation") << ", " << num_refused << " refused\n"
      << check_summary(run.check) << pairs_summary(run) << verdict_text(run.scene, run.stability);
  return out.str();
}

std::string with_name(const std::string& pattern, const std::string& name) {
  const size_t at = pattern.find(kPlaceOfName);
  return at == std::string::npos
             ? pattern
             : std::string(pattern).replace(at, std::strlen(kPlaceOfName), name);
}

}  // namespace trivet::apps
