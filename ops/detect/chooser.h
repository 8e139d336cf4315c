// The choice of `auto`: for each query the source of candidates that is expected to be fastest.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/base/sentence.h"
#include "ops/detect/machine.h"

namespace trivet {

/// One per detector. A GPU's context, shaders and self-test are made when the queries so far would
/// have paid for them, as one buys skis when the rents reach their price: what is asked a few times
/// ends without a GPU. BVHs of new meshes are not weighed against that: the proofs after a motion
/// need them anyhow. A source that fails is given up with one note.
class BackendChooser {
 public:
  /// @param note       told what is given up in software.
  /// @param gpu_notes  told what is given up on a GPU, and of losses.
  explicit BackendChooser(std::shared_ptr<Machine> machine,
                          std::function<void(const Sentence&)> note = {}, GpuNotes gpu_notes = {});

  /// The stage to ask; null: BVHs. Valid until answered().
  CandidateFinder* stage_for(const FirstContactQuery& query);
  /// To be told whether the stage's proposal was usable: several failures in a row end its use.
  void answered(bool usable, const std::string& why);

  /// Sources used so far, such as "bvh" or "bvh, gpu compute"; "bvh" before the first query.
  std::string names() const;
  /// Renderer of the last GPU source used, and how it is used; "cpu" and empty if none was.
  const std::string& device() const { return m_device; }
  const std::string& method() const { return m_method; }
  const std::string& lists() const { return m_lists; }

 private:
  using Stages = std::map<std::string, std::unique_ptr<CandidateFinder>>;

  bool is_small(Motion::Kind kind, double triangles) const;
  double ms(const SourceCost& source, const QuerySize& size) const;
  double to_pay_ms(const SourceCost& source) const;
  const SourceCost* choose(const QuerySize& size);
  bool make_ready(const SourceCost& source);
  CandidateFinder* use(const std::string& name);
  void give_up(const std::string& name, const Sentence& why);

  std::shared_ptr<Machine> m_machine;
  std::function<void(const Sentence&)> m_note;
  GpuNotes m_gpu_notes;
  std::shared_ptr<const Calibration> m_calibration;  // null: not asked for yet
  Stages m_ready;
  std::map<std::string, double> m_saved_ms;  // savings missed so far, by source not ready
  std::set<std::string> m_given_up, m_used;
  std::string m_current = Calibration::kBvh, m_device = "cpu", m_method, m_lists;
  bool m_recalibrated = false;
  int m_failures = 0;  // of the current source, in a row
};

}  // namespace trivet
