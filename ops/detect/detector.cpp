#include "ops/detect/detector.h"

#include <utility>

#include "core/base/error.h"
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
  sum.bytes_read_back += work.bytes_read_back;
  sum.read_backs += work.read_backs;
}

}  // namespace

FirstContact Detector::first_contact(const FirstContactQuery& query) {
  ++m_work.num_queries;
  FirstContact found;
  if (m_stage) {
    CandidatePairs proposal;
    found = trivet::first_contact(query, *m_stage, &proposal, m_confirmation);
    add(proposal.work, m_work.zlist);
    m_work.fallbacks += !proposal.usable;
  } else {
    found = trivet::first_contact(query);
  }
  m_work.node_pairs += found.work.node_pairs;
  m_work.face_pairs += found.work.face_pairs;
  m_work.stalled += found.stalled;
  return found;
}

void Detector::use_gpu_brackets(std::function<DropBracketFunction()> make,
                                std::function<void(const std::string&)> note) {
  m_make_brackets = std::move(make);
  m_note = std::move(note);
}

std::vector<DropBracket> Detector::drop_brackets(const HeightMap& object, const HeightMap& scene,
                                                 int columns, int rows) {
  const auto num_places = static_cast<std::int64_t>(columns) * rows;
  m_work.places += num_places;
  try {
    if (m_make_brackets) m_gpu_brackets = std::exchange(m_make_brackets, {})();
    if (m_gpu_brackets) {
      std::vector<DropBracket> found = m_gpu_brackets(object, scene, columns, rows);
      m_work.places_on_gpu += num_places;
      return found;
    }
  } catch (const Error& error) {
    m_gpu_brackets = {};
    if (m_note) m_note(std::string(error.what()) + "; places are judged in software instead");
  }
  return trivet::drop_brackets(object, scene, columns, rows);
}

DropBracketFunction drop_brackets_of(Detector* detector) {
  if (!detector) return drop_brackets;
  return [detector](const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return detector->drop_brackets(object, scene, columns, rows);
  };
}

}  // namespace trivet
