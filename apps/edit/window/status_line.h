// The status bar: what is in hand, hints, the running job, who answers, whether the scene stands.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include "apps/edit/window/scene_drawing.h"

namespace trivet::edit {

class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(Document& document, Toolbox& toolbox, const SceneDrawing& drawing, QStatusBar& bar);

  /// Shows what the tool, the ghost and the selection are now.
  void follow_tool();
  /// Shows a note for a while.
  void show_note(const QString& note);
  void show_stored(int number);
  /// Work that is no job of the document. @param what  empty: it has ended.
  void show_work(const QString& what);
  /// @param total  0: unknown.
  void show_progress(const QString& what, int done, int total);

 Q_SIGNALS:
  void cancel_wanted();

 private:
  void make_widgets(QStatusBar& bar);
  void follow_document();
  QString hint() const;
  QString count() const;
  void follow_busy();
  void show_busy();
  void show_detection();
  void show_verdict();

  Document& m_document;
  Toolbox& m_toolbox;
  const SceneDrawing& m_drawing;
  QStatusBar& m_bar;
  QLabel *m_hand, *m_hint, *m_count, *m_busy, *m_answering, *m_stands;
  QProgressBar* m_progress;
  QToolButton* m_cancel;
  QTimer m_busy_for_long;
  bool m_other_work = false;
};

}  // namespace trivet::edit
