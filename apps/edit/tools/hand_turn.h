// The turn of the object in hand: about the vertical, and to the ways in which it can lie.
#pragma once

#include <functional>

#include "apps/edit/document/document.h"
#include "apps/edit/tools/events.h"

namespace trivet::edit {

/// Keys that turn what is in the hand: "," and "." by a step each way, "l" to the next way to lie,
/// which is 0 steps. Nullopt: another key.
std::optional<int> turns_by(const KeyEvent& event);

class HandTurn {
 public:
  /// @param changed  called when another rotation holds.
  HandTurn(Document& document, std::function<void()> changed);
  ~HandTurn();

  /// Forgets what was turned, when another object is in the hand.
  void take(std::optional<ObjectId> object);
  /// About the vertical, right-handed.
  void turn(double degrees);
  /// To the next way, the nearest first; after the last one as it was. Found on the document's
  /// thread.
  void next_way();
  /// @param steps  of turns_by().
  void by_key(int steps, double step_deg) { steps == 0 ? next_way() : turn(steps * step_deg); }
  bool is_turned() const { return m_degrees != 0 || m_way > 0; }
  /// @param now  of the object, a Pose's.
  Rotation of(const Rotation& now) const;

 private:
  void found(const WaysToLie& ways);

  Document& m_document;
  std::function<void()> m_changed;
  std::optional<ObjectId> m_object;
  double m_degrees = 0;
  std::optional<std::vector<WayToLie>> m_ways;  // but that in which it lies now
  size_t m_way = 0;                             // 0: as it lies; else of m_ways, from 1
  int m_wanted = 0;                             // steps, until the ways are known
  QMetaObject::Connection m_found;
};

}  // namespace trivet::edit
