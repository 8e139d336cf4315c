// Collision detection in the paper's three stages [Shinya 1995, 5.1], from whichever source of
// candidates there is; what all operations ask.
#pragma once

#include <memory>
#include <string>

#include "core/candidates/height_map.h"
#include "core/candidates/zlist_stage.h"
#include "ops/detect/bracket_source.h"

namespace trivet {

/// Summed cost of queries.
struct DetectionWork {
  std::int64_t num_queries = 0;    // whose answers were used
  std::int64_t early = 0;          // asked together with others before they were needed
  double seconds = 0;              // of these queries, wall clock
  std::int64_t node_pairs = 0;     // of BVHs
  std::int64_t face_pairs = 0;     // decided exactly
  std::int64_t stalled = 0;        // queries whose answer may be early, see FirstContact::stalled
  std::int64_t fallbacks = 0;      // queries that a z-list stage gave up; BVHs answered
  std::int64_t places = 0;         // judged by height maps, see drop_brackets()
  std::int64_t places_on_gpu = 0;  // of these
  ZListWork zlist;
};

class BackendChooser;

/// Answers are the same bits whatever the stage. One thread at a time.
class Detector {
 public:
  /// BVHs alone.
  Detector();
  Detector(std::unique_ptr<CandidateFinder> stage, std::string name);
  /// The stage that `chooser` takes for each query.
  explicit Detector(std::unique_ptr<BackendChooser> chooser);
  ~Detector();

  FirstContact first_contact(const FirstContactQuery& query);

  /// False if a stage was asked for by name: else other detectors may answer some queries by BVHs,
  /// at the same time.
  bool may_ask_bvhs() const { return !m_stage; }
  /// Counts what such a detector has done.
  void add_work(const DetectionWork& work);

  /// True if a GPU answers, which draws many queries at the cost of few.
  bool asks_together() const { return !method().empty(); }
  /// Answers to queries of which some may be used, see used_early().
  std::vector<FirstContact> first_contacts_early(std::span<const FirstContactQuery> queries);
  /// To be told when an early answer is used: it counts as a query then.
  void used_early() { ++m_work.num_queries; }

  /// Sets how a stage's proposals are confirmed from now on.
  void set_confirmation(const Confirmation& confirmation) { m_confirmation = confirmation; }
  const Confirmation& confirmation() const { return m_confirmation; }

  /// Source of brackets of falls from now on; without, software computes them.
  void use_brackets(std::unique_ptr<BracketSource> source);
  /// Drops of an object at many places; the same bits from software and GPU.
  std::vector<DropBracket> drop_brackets(const HeightMap& object, const HeightMap& scene,
                                         int columns, int rows);

  const DetectionWork& work() const { return m_work; }
  /// "bvh", "software" or "gpu"; of a chooser, those that have answered so far: "bvh, gpu compute".
  std::string name() const;
  /// Device: "cpu", or the renderer of OpenGL.
  std::string device() const;
  /// Use of the GPU, see CandidateFinder::method(); empty without one.
  std::string method() const;
  /// Who lists the faces of its doubtful pixels, see CandidateFinder::lists(); likewise.
  std::string lists() const;

 private:
  FirstContact ask_stage(const FirstContactQuery& query, CandidateFinder& stage);
  void note(const CandidatePairs& proposal);

  std::unique_ptr<CandidateFinder> m_stage;
  std::unique_ptr<BackendChooser> m_chooser;
  std::string m_name = "bvh";
  Confirmation m_confirmation;
  std::unique_ptr<BracketSource> m_brackets;  // null: software
  DetectionWork m_work;
};

/// By `detector`, or in software when it is null.
DropBracketFunction drop_brackets_of(Detector* detector);

}  // namespace trivet
