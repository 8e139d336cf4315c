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
  sum.bytes_read_back += work.bytes_read_back;
}

// Everything that a motion may come near.
Aabb swept_box(Aabb box, const Motion& motion, double margin) {
  if (motion.kind == Motion::Kind::Translation) {
    const Vec3 way = motion.limit * motion.axis;
    box.extend(Aabb{box.lower + way, box.upper + way});
  } else {
    const Vec3 far = (box.centre() - motion.centre).cwiseAbs() + box.half_extent();
    const Vec3 reach = Vec3::Constant(far.norm() * (1 + 1e-14));
    box = {motion.centre - reach, motion.centre + reach};
  }
  box.lower -= Vec3::Constant(margin), box.upper += Vec3::Constant(margin);
  return box;
}

// Of the fixed bodies, those in the box that the motion sweeps.
std::vector<Index> near(const FirstContactQuery& query) {
  Aabb box;
  for (const Body& body : query.moving)
    if (!body.world_box.empty()) box.extend(body.world_box);
  const double margin = 1.01 * query.clearance.largest_stop() + 1e-13 * box.max_abs_coordinate();
  const Aabb swept = swept_box(box, query.motion, margin);
  std::vector<Index> out;
  for (Index i = 0; i < static_cast<Index>(query.fixed.size()); ++i)
    if (overlaps(swept, query.fixed[i].world_box)) out.push_back(i);
  return out;
}

FirstContact answer(const FirstContactQuery& query, Detector* detector) {
  return detector ? detector->first_contact(query) : first_contact(query);
}

}  // namespace

FirstContact Detector::first_contact(const FirstContactQuery& query) {
  ++m_work.num_queries;
  FirstContact found;
  if (m_stage) {
    CandidatePairs proposal;
    found = trivet::first_contact(query, *m_stage, &proposal);
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

FirstContact first_contact(const FirstContactQuery& query, Detector* detector) {
  const std::vector<Index> fixed = near(query);
  if (fixed.size() == query.fixed.size()) return answer(query, detector);
  std::vector<Body> bodies;
  for (const Index i : fixed) bodies.push_back(query.fixed[i]);
  FirstContactQuery local = query;
  local.fixed = bodies;
  FirstContact found = answer(local, detector);
  if (found.status != FirstContact::Status::Free && found.fixed != FirstContact::kFloor)
    found.fixed = fixed[found.fixed];
  return found;
}

DropBracketFunction drop_brackets_of(Detector* detector) {
  if (!detector) return drop_brackets;
  return [detector](const HeightMap& object, const HeightMap& scene, int columns, int rows) {
    return detector->drop_brackets(object, scene, columns, rows);
  };
}

}  // namespace trivet
