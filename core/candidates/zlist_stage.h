// Candidates for first contact from z-lists along the motion, instead of from BVHs.
//
// A stage only proposes; first_contact() of two triangles decides. So every stage, on any hardware,
// gives the same bits, as long as it leaves out no pair of faces that can be first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/contact/first_contact.h"

namespace trivet {

/// A pair of faces that may be the first to come into contact.
struct FacePair {
  Index moving, fixed;            // bodies: indices into the query's spans
  Index face_moving, face_fixed;  // triangles of their meshes
  double not_before;              // lower bound of its time, >= 0; see Motion
};

/// Counts of what the stages of a query left over and read back.
struct ZListWork {
  std::int64_t body_pairs = 0;       // stage 1: boxes meet during the motion
  std::int64_t pixels = 0;           // stage 2: with moving faces, and fixed ones not ruled out
  std::int64_t doubtful_pixels = 0;  // stage 3: in which the first contact may be
  std::int64_t face_pairs = 0;       // proposed
  std::int64_t asked_pairs = 0;      // of these, put to Embree; see Confirmation
  std::int64_t confirmed_pairs = 0;  // of these, visited by it, and decided in its callback
  std::int64_t gpu_lists = 0;        // queries whose lists a GPU made
  std::int64_t software_lists = 0;   // queries of a GPU whose lists software made
  std::int64_t bytes_read_back = 0;  // from a GPU
  std::int64_t draws = 0;            // times that a GPU drew queries, one or many together
  std::int64_t read_backs = 0;       // times that the processor waited for a GPU's results
};

/// Result of a stage. Every pair of faces whose first contact is no later than
/// `upper` is among `pairs`, and its time is at least its `not_before`.
struct CandidatePairs {
  bool usable = false;          // false: the stage gave up (`why`); take another
  std::string why;              // for people
  double lower = 0;             // no contact before this time
  double upper = kInfinity;     // contact by this time at the latest; infinity: perhaps none
  std::vector<FacePair> pairs;  // without duplicates, by not_before, then by indices
  ZListWork work;
};

/// Finds, by rasterising along the motion, the pairs of faces that can be first. The floor is no
/// business of a stage. Not re-entrant: one query at a time.
class CandidateFinder {
 public:
  virtual ~CandidateFinder() = default;
  virtual std::string name() const = 0;  // "software", "gpu (llvmpipe ...)"
  /// Device: "cpu", or the renderer of OpenGL.
  virtual std::string device() const { return "cpu"; }
  /// Use of the GPU: "framebuffer" or "compute"; empty: of no GPU.
  virtual std::string method() const { return ""; }
  /// Lister of the faces of a GPU's doubtful pixels: "auto", "gpu" or "software"; empty: of no GPU.
  virtual std::string lists() const { return ""; }

  /// @param horizon  contacts later than this do not matter; at most query.motion.limit.
  /// Pairs stop at distances of up to query.clearance.largest_stop(): "touch" above means that.
  virtual CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) = 0;

  /// The same for many queries (candidate places, axes of a turn): one by one, unless a stage knows
  /// better. @param horizons  of each query.
  virtual std::vector<CandidatePairs> find_candidates_for_all(
      std::span<const FirstContactQuery> queries, std::span<const double> horizons);
};

/// Pairs from which Embree pays, of drops and turns alike: with fewer, the closed form alone is
/// sooner, by a millisecond at most. Measured by trivet_perf --only confirm, see
/// docs/measurements/zlists.md.
inline constexpr std::size_t kFewestForEmbree = 5000;

/// Embree on the way from a stage's proposal to the first contact, see decide_by_embree(). The
/// first pairs are decided at once: they lower the horizon, which leaves fewer pairs to visit.
struct Confirmation {
  bool enabled = true;
  std::size_t fewest_pairs = kFewestForEmbree;  // visits so many pairs or more
};
inline constexpr Confirmation kConfirmAll{true, 0}, kConfirmNone{false, 0};

/// The same bits as first_contact(query), with pairs from `stage`; where the stage gives up or
/// proves wrong, from the BVHs.
/// @param proposal  if not null, what the stage said, less the pairs that were not confirmed; not
///   usable when the BVHs had to answer.
FirstContact first_contact(const FirstContactQuery& query, CandidateFinder& stage,
                           CandidatePairs* proposal = nullptr,
                           const Confirmation& confirmation = {});

/// The same for many queries, which the stage sees together.
std::vector<FirstContact> first_contacts(std::span<const FirstContactQuery> queries,
                                         CandidateFinder& stage,
                                         std::vector<CandidatePairs>* proposals = nullptr,
                                         const Confirmation& confirmation = {});

}  // namespace trivet
