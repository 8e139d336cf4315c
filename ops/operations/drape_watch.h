// Objects that come down, shown while they do: for programs that people watch.
#pragma once

#include <chrono>
#include <functional>

#include "core/flex/drape.h"
#include "core/scene/object.h"

namespace trivet {

/// While it lives, DRAPE of this thread shows its object, at most `rate` times a second. No result
/// depends on it. Nested ones: the last.
class DrapeWatch {
 public:
  /// @param object  as it is now, with its thickness; not in the scene. @param net_force  the
  ///   largest at a vertex, of its weight.
  using Show = std::function<void(std::shared_ptr<const Object> object, double net_force)>;

  explicit DrapeWatch(Show show, double rate = 10);
  ~DrapeWatch();
  DrapeWatch(const DrapeWatch&) = delete;
  DrapeWatch& operator=(const DrapeWatch&) = delete;

 private:
  friend class DrapeShow;
  using Clock = std::chrono::steady_clock;
  Show m_show;
  Clock::duration m_pause;
  Clock::time_point m_next;
  DrapeWatch* m_outer;
};

/// The side of DRAPE: one for each thing that comes down. Private.
class DrapeShow {
 public:
  DrapeShow(std::string name, const flex::DrapeProblem& problem);
  void step(const flex::Progress& progress) const;

 private:
  std::string m_name;
  const flex::DrapeProblem& m_problem;
};

}  // namespace trivet
