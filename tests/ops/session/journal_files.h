// Sessions of two boxes with a journal, in a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "ops/files/json/text.h"
#include "ops/session/journal.h"
#include "ops/session/restore.h"
#include "session_testing.h"
#include "support/temporary_folder.h"

namespace trivet::test {

class JournalFiles : public testing::Test {
 protected:
  void SetUp() override {
    write("box.obj",
          "v 0 0 0\nv 0.2 0 0\nv 0 0.2 0\nv 0 0 0.2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    write("layout.json",
          R"({"trivet": 1, "objects": [{"name": "a", "model": "box.obj"},
              {"name": "b", "model": "box.obj"}],
              "operations": [{"op": "put", "object": "a", "position": [0, 0, 1]}]})");
  }

  std::string path(const std::string& name) const { return m_folder.file(name); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string read(const std::string& name) const { return read_text_file(path(name), 1 << 30); }
  OpenedSession open(const std::string& start = "layout.json", bool keep_models = false) const {
    return open_session(path(start), {}, {}, {path("j"), keep_models});
  }
  void remove_journal() const {
    for (const char* const name : {"j", "j.start"}) std::filesystem::remove(path(name));
  }
  RestoredSession restore(bool go_on = false) const {
    return restore_session(path("j"), {}, {}, go_on);
  }
  std::string complaint() const {
    try {
      restore();
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  }

  // Three steps, an undo, a redo, an undo.
  static void work(Session& session) {
    EXPECT_TRUE(session.perform(put_at("b", 0.05, 0.02)).ok());
    EXPECT_TRUE(session.perform(append_of("c", "box.obj")).ok());
    EXPECT_TRUE(session.perform(put_at("c", 1, 1)).ok());
    EXPECT_TRUE(session.undo());
    EXPECT_TRUE(session.redo());
    EXPECT_TRUE(session.undo());
  }

  TemporaryFolder m_folder;
};

}  // namespace trivet::test
