// Steps of the hour. Private.
#pragma once

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

class Hour {
 public:
  Hour(Document& document, MainWindow& window, User& user, const QString& folder)
      : m_document(document), m_window(window), m_user(user), m_folder(folder) {}

  void import_folders();
  void put_shelf();
  void put_book_into_shelf();
  void put_ten_in_a_row();
  void put_forty_apples();
  void push_and_turn();
  void type_numbers();
  void rename();
  void collect();
  void save_and_reopen();
  void export_and_render();
  void put_textured();
  void lay_out_in_a_circle();
  void paint();
  void show_and_hide();
  void look_around();
  void copy_one_by_one();

 private:
  void show_folder(const QString& name);
  void show_room();
  size_t num_objects() const { return m_document.snapshot()->objects.size(); }
  void undo();
  void wait_for(const std::string& object);
  void begin() { m_before = m_user.effort(); }
  /// Since begin(), and what was done in the asset browser.
  void print_effort(const char* what, int asset_clicks = 0, int asset_drags = 0) const;
  void enter_file(const QString& file);
  void enter_file_once_asked(const QString& file);
  void with_row(QWidget& dialog, const char* row, const QString& text);
  Vec3 centre(const std::string& name) { return world_box(m_user.object(name)).centre(); }

  Document& m_document;
  MainWindow& m_window;
  User& m_user;
  QString m_folder;
  User::Effort m_before;
};

/// A row of a dialog, in the language of the window.
QString in_words(const char* text);

}  // namespace trivet::edit::test
