// One query of SoftwareZLists, or the rest of one: from a frame to the candidate pairs of faces.
// Private.
#pragma once

#include <atomic>

#include "core/candidates/doubtful_lists.h"
#include "raster/zlist/depth_map.h"
#include "raster/zlist/software_zlists.h"

namespace trivet {

inline float rounded_up(double x) { return static_cast<float>(x) * 1.000001F; }

/// A face in a pixel.
struct Fragment {
  std::int32_t pixel;
  std::uint32_t face;  // of its layer
  float lower, upper;  // depths
};

/// Minimum over numbers from many threads.
class SharedMinimum {
 public:
  void reset(float x) { m_value.store(x, std::memory_order_relaxed); }
  float get() const { return m_value.load(std::memory_order_relaxed); }
  void lower_to(float x) {
    float old = get();
    while (x < old && !m_value.compare_exchange_weak(old, x, std::memory_order_relaxed)) {
    }
  }

 private:
  std::atomic<float> m_value;
};

class ZListSearch {
 public:
  ZListSearch(const FirstContactQuery& query, const ZListFrame& frame,
              const SoftwareZListOptions& options);
  CandidatePairs run();
  /// Only in the doubtful pixels.
  CandidatePairs run(const Doubt& doubt);

 private:
  struct Candidate {
    std::uint32_t moving, fixed;
    float bound;  // lower bound of the difference of depths
  };
  struct Lists {
    std::vector<Fragment> moving, fixed;  // in some pixels
  };
  struct Pixel {  // and its lists
    int pixel;
    float bound;
    std::span<Fragment> moving, fixed;
  };

  CandidatePairs finish(bool drawn, Lists& lists);
  bool draw_base(Lists& lists);
  bool draw_doubtful(const std::vector<std::uint32_t>& pixels, Lists& lists);
  bool collect_moving_in(const std::vector<char>& mask, const Wanted& wanted, const View& view,
                         DepthMap& map, std::vector<Fragment>& out);
  void sample_upper_bound(const View& view, const DepthMap& map);
  bool collect_fixed(const View& view, const DepthMap& map, std::vector<Fragment>& out);
  bool collect_moving(const View& view, const std::vector<Fragment>& fixed,
                      std::vector<Fragment>& out);
  static std::vector<Pixel> pixels_of(Lists& lists);
  bool resolve(const View& view, int level, size_t pairs_before, Lists& lists);
  bool resolve_pixel(const View& view, int level, const Pixel& pixel);
  bool zoom(const View& view, int level, const Pixel& pixel);
  bool add_pairs(const Pixel& pixel);
  void drop_duplicates();
  bool give_up(const char* why);
  CandidatePairs proposal();

  const FirstContactQuery& m_query;
  const ZListFrame& m_frame;
  SoftwareZListOptions m_options;
  Layer m_moving, m_fixed;
  FaceBoxes m_moving_boxes;
  float m_reach, m_tie;
  SharedMinimum m_upper;  // of the difference of depths; m_reach while unknown
  std::vector<Candidate> m_candidates;
  int m_num_zooms = 0;
  ZListWork m_work;
  std::string m_why;
};

}  // namespace trivet
