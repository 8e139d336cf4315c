#include "ops/detect/chooser.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"

namespace trivet {
namespace {

constexpr int kMostFailures = 8;

double num_triangles(const FirstContactQuery& query) {
  double out = 0;
  for (const std::span<const Body> bodies : {query.moving, query.fixed})
    for (const Body& body : bodies) out += static_cast<double>(body.shape->mesh.triangles.size());
  return out;
}

}  // namespace

BackendChooser::BackendChooser(std::shared_ptr<Machine> machine,
                               std::function<void(const Sentence&)> note, GpuNotes gpu_notes)
    : m_machine(std::move(machine)), m_note(std::move(note)), m_gpu_notes(std::move(gpu_notes)) {}

double BackendChooser::ms(const SourceCost& source, const QuerySize& size) const {
  const bool is_open = source.is_for_auto() && !m_given_up.contains(source.name);
  return is_open ? source.ms(size) : kInfinity;
}

// Returns whether no source can be faster than BVHs, even if all bodies count for BVHs and none for
// the source.
bool BackendChooser::is_small(Motion::Kind kind, double triangles) const {
  // The bound is cheap to ask, and spares small queries the frame.
  double bvh = kInfinity, others = kInfinity;
  for (const SourceCost& source : m_calibration->sources)
    if (source.name == Calibration::kBvh)
      bvh = ms(source, {kind, triangles, 0});
    else
      others = std::min(others, ms(source, {kind, 0, 0}));
  return bvh <= others;
}

double BackendChooser::to_pay_ms(const SourceCost& source) const {
  return m_ready.contains(source.name) ? 0 : source.start_ms;
}

// Null: BVHs, as nothing else can be used.
const SourceCost* BackendChooser::choose(const QuerySize& size) {
  const SourceCost* best = nullptr;
  double best_ms = kInfinity;
  // A source that has to start pays that off by what it would have saved so far.
  for (const SourceCost& source : m_calibration->sources) {
    const double owed = to_pay_ms(source) - m_saved_ms[source.name];
    const double total = ms(source, size) + std::max(0.0, owed);
    if (total < best_ms) best_ms = total, best = &source;
  }
  if (!best) return nullptr;
  m_saved_ms[best->name] = 0;
  // Others gain what they would have saved at this query.
  for (const SourceCost& source : m_calibration->sources)
    if (to_pay_ms(source) > 0)
      m_saved_ms[source.name] += std::max(0.0, ms(*best, size) - ms(source, size));
  return best;
}

// False: it was given up, or the calibration is another one now.
bool BackendChooser::make_ready(const SourceCost& source) {
  // A source starts when it is chosen for the first time, not before.
  if (m_ready.contains(source.name)) return true;
  try {
    std::unique_ptr<CandidateFinder> stage = m_machine->make_stage(source.name, m_gpu_notes);
    // Costs that were measured on another device say nothing about this one: they are measured once
    // more.
    const bool is_other = stage && stage->device() != source.device && !m_recalibrated;
    m_ready[source.name] = std::move(stage);
    if (!is_other) return true;
    m_recalibrated = true;  // another renderer than the one that was measured
    m_calibration = m_machine->recalibrate(m_calibration);
  } catch (const Error& error) {
    give_up(source.name, error.sentence());
  }
  return false;
}

void BackendChooser::give_up(const std::string& name, const Sentence& why) {
  // The source is given up for the rest of the run, and the user is told once.
  m_given_up.insert(name);
  const Sentence text = say("%1; auto goes on without %2", why, name);
  if (name != Calibration::kSoftware)
    m_gpu_notes.tell_lost(text);
  else if (m_note)
    m_note(text);
}

CandidateFinder* BackendChooser::use(const std::string& name) {
  // Failures count in a row, and for one source.
  if (name != m_current) m_failures = 0;
  m_current = name;
  m_used.insert(name);
  CandidateFinder* const stage = name == Calibration::kBvh ? nullptr : m_ready.at(name).get();
  if (stage && stage->device() != "cpu") {
    m_device = stage->device();
    m_method = stage->method();
    m_lists = stage->lists();
  }
  return stage;
}

CandidateFinder* BackendChooser::stage_for(const FirstContactQuery& query) {
  // Calibration is measured when it is first needed.
  if (!m_calibration) m_calibration = m_machine->calibration();
  // A small query goes to BVHs at once.
  if (is_small(query.motion.kind, num_triangles(query))) return use(Calibration::kBvh);
  const QuerySize size = size_of(query);
  // A source that does not start is given up, and the next best is chosen.
  while (true) {
    const auto kept = m_calibration;  // `source` is in it
    const SourceCost* const source = choose(size);
    if (!source) return use(Calibration::kBvh);
    if (make_ready(*source)) return use(source->name);
  }
}

void BackendChooser::answered(bool usable, const std::string& why) {
  // A source that gives up again and again is not asked any more.
  m_failures = usable ? 0 : m_failures + 1;
  if (m_failures < kMostFailures || m_current == Calibration::kBvh) return;
  m_ready.erase(m_current);
  m_failures = 0;
  give_up(m_current, why);
}

std::string BackendChooser::names() const {
  if (m_used.empty()) return Calibration::kBvh;
  std::string out;
  for (const std::string& name : m_used) out += (out.empty() ? "" : ", ") + name;
  return out;
}

}  // namespace trivet
