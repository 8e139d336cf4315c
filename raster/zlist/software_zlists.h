// Candidate finder for first contact by z-lists in software.
#pragma once

#include <memory>

#include "core/candidates/doubtful_lists.h"

namespace trivet {

struct SoftwareZListOptions {
  int resolution = 0;   // pixels along the image's longer side; 0: chosen by the number of faces
  int num_threads = 1;  // 0: all cores
  int zoom_levels = 3;  // each 8 times finer, in pixels with many pairs; 0: none
  std::size_t most_fragments = std::size_t{1}
                               << 24;  // memory limit: 16 bytes each; gives up beyond
  std::size_t most_pairs = std::size_t{1} << 22;
};

/// The paper's three stages [Shinya 1995, section 5.1] as branch and bound along the motion: boxes;
/// minimal and maximal depths per pixel, with an upper bound of the time from lines that meet both
/// sides; lists only in pixels whose lower bound does not exceed it, zoomed in where they are long.
/// README.md proves that no pair is missed. Needs no preprocessing of the meshes. Cost O(vertices +
/// faces + touched pixels + pairs left). The same candidates with any number of threads.
class SoftwareZLists : public CandidateFinder {
 public:
  /// @throws Error (BadInput) for options out of range.
  explicit SoftwareZLists(const SoftwareZListOptions& options = {});
  std::string name() const override { return "software"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override;

 private:
  SoftwareZListOptions m_options;
};

/// Lists in the pixels that another stage's depths leave in doubt: the second half of the above.
/// Moving and fixed faces are drawn once each, cut to those pixels. The
/// resolution is the frame's, not the options'. The same candidates with any number of threads.
class SoftwareDoubtfulLists : public DoubtfulLists {
 public:
  /// @throws Error (BadInput) for options out of range.
  explicit SoftwareDoubtfulLists(const SoftwareZListOptions& options = {});
  CandidatePairs find_candidates(const FirstContactQuery& query, const ZListFrame& frame,
                                 const Doubt& doubt) override;

 private:
  SoftwareZListOptions m_options;
};

}  // namespace trivet
