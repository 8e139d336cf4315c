// Objects on their way from one rest to the next, as an operation brought them there: only on the
// screen, the scene is at its end already. A key or a click shows the end; nothing waits for it.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <map>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

class Playback : public QObject {
  Q_OBJECT

 public:
  explicit Playback(QObject* parent = nullptr);
  ~Playback() override;

  /// From what was seen to what is committed now; what moved without a known way goes straight.
  void play(const SceneSnapshot& before, std::shared_ptr<const SceneSnapshot> now);
  void end();
  bool is_on() const { return m_now != nullptr; }
  bool moves(ObjectId id) const;
  /// Where it is seen.
  Pose pose_of(const ObjectSnapshot& object) const;

 Q_SIGNALS:
  void changed();

 protected:
  /// Of the whole program, while it plays: Escape is taken, all others go on to where they belong.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move_on();
  double progress() const;  // 0 to 1

  std::shared_ptr<const SceneSnapshot> m_now;  // null: nothing is played
  std::map<std::uint32_t, Pose> m_straight;    // by slot: where they come from
  double m_milliseconds = 0;                   // that it takes
  QElapsedTimer m_since;
  QTimer m_tick;
};

}  // namespace trivet::edit
