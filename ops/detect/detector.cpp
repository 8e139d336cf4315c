#include "ops/detect/detector.h"

namespace trivet {
namespace {

void add(const ZListWork& work, ZListWork& sum) {
  sum.body_pairs += work.body_pairs;
  sum.pixels += work.pixels;
  sum.doubtful_pixels += work.doubtful_pixels;
  sum.face_pairs += work.face_pairs;
  sum.bytes_read_back += work.bytes_read_back;
}

}  // namespace

FirstContact Detector::first_contact(const FirstContactQuery& query) {
  ++m_work.num_queries;
  FirstContact found;
  if (m_stage) {
    Proposal proposal;
    found = trivet::first_contact(query, *m_stage, &proposal);
    add(proposal.work, m_work.zlist);
    m_work.fallbacks += !proposal.usable;
  } else {
    found = trivet::first_contact(query);
  }
  m_work.node_pairs += found.work.node_pairs;
  m_work.face_pairs += found.work.face_pairs;
  return found;
}

FirstContact first_contact(const FirstContactQuery& query, Detector* detector) {
  return detector ? detector->first_contact(query) : first_contact(query);
}

}  // namespace trivet
