// Playback of objects along their settling paths: only on the screen, as the scene has its final
// state already. A key or a click jumps to the end; nothing waits for it.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <map>
#include <optional>

#include "apps/edit/document/snapshot.h"
#include "core/motion/motion.h"

namespace trivet::edit {

class Playback : public QObject {
  Q_OBJECT

 public:
  explicit Playback(QObject* parent = nullptr);
  ~Playback() override;

  /// Plays from the visible state to the committed one; objects without a known path go straight.
  void play(const SceneSnapshot& before, std::shared_ptr<const SceneSnapshot> now);
  void end();
  bool is_on() const { return m_now != nullptr; }
  bool moves(ObjectId id) const;
  /// Objects that go along the known path, the first one first; empty: none.
  std::vector<ObjectId> on_the_way() const;
  /// Motion of the first object, from here; nullopt: none, or it stands still.
  std::optional<Motion> motion() const;
  /// Displayed pose.
  Pose pose_of(const ObjectSnapshot& object) const;

 Q_SIGNALS:
  void changed();

 protected:
  /// Active for the whole program during playback: consumes Escape, passes on all other events.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move_on();
  double progress() const;  // 0 to 1

  std::shared_ptr<const SceneSnapshot> m_now;  // null: not playing
  std::map<std::uint32_t, Pose> m_straight;    // by slot: start poses
  double m_milliseconds = 0;                   // duration
  QElapsedTimer m_since;
  QTimer m_tick;
};

}  // namespace trivet::edit
