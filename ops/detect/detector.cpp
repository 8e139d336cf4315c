#include "ops/detect/detector.h"

#include <utility>

#include "ops/base/stopwatch.h"
#include "ops/detect/chooser.h"
#include "raster/height_map/drop_brackets.h"

namespace trivet {
namespace {

void add(const ZListWork& work, ZListWork& sum) {
  sum.body_pairs += work.body_pairs;
  sum.pixels += work.pixels;
  sum.doubtful_pixels += work.doubtful_pixels;
  sum.face_pairs += work.face_pairs;
  sum.asked_pairs += work.asked_pairs;
  sum.confirmed_pairs += work.confirmed_pairs;
  sum.gpu_lists += work.gpu_lists;
  sum.software_lists += work.software_lists;
  sum.bytes_read_back += work.bytes_read_back;
  sum.draws += work.draws;
  sum.read_backs += work.read_backs;
}

}  // namespace

Detector::Detector() = default;
Detector::Detector(std::unique_ptr<CandidateFinder> stage, std::string name)
    : m_stage(std::move(stage)), m_name(std::move(name)) {}
Detector::Detector(std::unique_ptr<BackendChooser> chooser) : m_chooser(std::move(chooser)) {}
Detector::~Detector() = default;

std::string Detector::name() const { return m_chooser ? m_chooser->names() : m_name; }

std::string Detector::device() const {
  if (m_chooser) return m_chooser->device();
  return m_stage ? m_stage->device() : "cpu";
}

std::string Detector::method() const {
  if (m_chooser) return m_chooser->method();
  return m_stage ? m_stage->method() : "";
}

std::string Detector::lists() const {
  if (m_chooser) return m_chooser->lists();
  return m_stage ? m_stage->lists() : "";
}

void Detector::add_work(const DetectionWork& work) {
  m_work.num_queries += work.num_queries;
  m_work.early += work.early;
  m_work.seconds += work.seconds;
  m_work.node_pairs += work.node_pairs;
  m_work.face_pairs += work.face_pairs;
  m_work.stalled += work.stalled;
  m_work.fallbacks += work.fallbacks;
  m_work.places += work.places;
  m_work.places_on_gpu += work.places_on_gpu;
  add(work.zlist, m_work.zlist);
}

FirstContact Detector::first_contact(const FirstContactQuery& query) {
  const Stopwatch stopwatch;
  ++m_work.num_queries;
  // The chooser may take another source for each query; the answer does not depend on it.
  CandidateFinder* const stage = m_chooser ? m_chooser->stage_for(query) : m_stage.get();
  FirstContact found = stage ? ask_stage(query, *stage) : trivet::first_contact(query);
  m_work.node_pairs += found.work.node_pairs;
  m_work.face_pairs += found.work.face_pairs;
  m_work.stalled += found.stalled;
  m_work.seconds += stopwatch.milliseconds() / 1000;
  return found;
}

FirstContact Detector::ask_stage(const FirstContactQuery& query, CandidateFinder& stage) {
  CandidatePairs proposal;
  FirstContact found = trivet::first_contact(query, stage, &proposal, m_confirmation);
  note(proposal);
  return found;
}

void Detector::note(const CandidatePairs& proposal) {
  add(proposal.work, m_work.zlist);
  m_work.fallbacks += !proposal.usable;
  if (m_chooser) m_chooser->answered(proposal.usable, proposal.why);
}

std::vector<FirstContact> Detector::first_contacts_early(
    std::span<const FirstContactQuery> queries) {
  const Stopwatch stopwatch;
  m_work.early += static_cast<std::int64_t>(queries.size());
  std::vector<FirstContact> out;
  // All queries are of the same faces: the first chooses the source for all.
  CandidateFinder* const stage = m_chooser ? m_chooser->stage_for(queries.front()) : m_stage.get();
  if (stage) {
    std::vector<CandidatePairs> proposals;
    out = trivet::first_contacts(queries, *stage, &proposals, m_confirmation);
    for (const CandidatePairs& proposal : proposals) note(proposal);
  } else {
    for (const FirstContactQuery& query : queries) out.push_back(trivet::first_contact(query));
  }
  // Work counts for all queries, also for answers that are not used later.
  for (const FirstContact& found : out) {
    m_work.node_pairs += found.work.node_pairs;
    m_work.face_pairs += found.work.face_pairs;
    m_work.stalled += found.stalled;
  }
  m_work.seconds += stopwatch.milliseconds() / 1000;
  return out;
}

void Detector::use_brackets(std::unique_ptr<BracketSource> source) {
  m_brackets = std::move(source);
}

std::vector<DropBracket> Detector::drop_brackets(const HeightMap& object, const HeightMap& scene,
                                                 int columns, int rows) {
  const auto num_places = static_cast<std::int64_t>(columns) * rows;
  m_work.places += num_places;
  if (!m_brackets) return trivet::drop_brackets(object, scene, columns, rows);
  BracketSource::Answer answer = m_brackets->find(object, scene, columns, rows);
  if (answer.by_gpu) m_work.places_on_gpu += num_places;
  return std::move(answer.brackets);
}

DropBracketFunction drop_brackets_of(Detector* detector) {
  if (!detector) return drop_brackets;
  return [detector](const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return detector->drop_brackets(object, scene, columns, rows);
  };
}

}  // namespace trivet
