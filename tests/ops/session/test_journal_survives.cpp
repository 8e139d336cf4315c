// Journals survive what becomes of the files that they name.
#include <algorithm>
#include <sstream>

#include "journal_files.h"
#include "ops/session/journal_text.h"

namespace trivet::test {
namespace {

namespace fs = std::filesystem;

// The box, a tenth of a millimetre larger.
constexpr const char* kLargerBox =
    "v 0 0 0\nv 0.2001 0 0\nv 0 0.2001 0\nv 0 0 0.2001\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

bool same_bits(const Pose& a, const Pose& b) {
  const Rotation &r = a.rotation, &s = b.rotation;
  return a.translation == b.translation && r.w == s.w && r.x == s.x && r.y == s.y && r.z == s.z;
}

class JournalSurvives : public JournalFiles {
 protected:
  // Also in every state that undo and redo reach.
  static void expect_same_poses(Session& a, Session& b) {
    ASSERT_EQ(a.num_done(), b.num_done());
    ASSERT_EQ(a.steps().size(), b.steps().size());
    while (a.redo()) ASSERT_TRUE(b.redo());
    do {
      expect_same_poses_now(a.scene(), b.scene());
    } while (a.undo() && b.undo());
    EXPECT_FALSE(a.can_undo() || b.can_undo());
  }
  static void expect_same_poses_now(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.ids(), b.ids());
    for (const ObjectId id : a.ids()) {
      EXPECT_EQ(a.at(id).name, b.at(id).name);
      EXPECT_EQ(a.at(id).placed, b.at(id).placed) << a.at(id).name;
      EXPECT_EQ(a.at(id).fixed, b.at(id).fixed);
      if (a.at(id).placed) {
        EXPECT_TRUE(same_bits(a.at(id).pose, b.at(id).pose)) << a.at(id).name;
      }
    }
    EXPECT_TRUE(a.is_consistent() && b.is_consistent());
  }
  static bool notes(const RestoredSession& restored, const std::string& what) {
    return std::any_of(
        restored.opened.notes.begin(), restored.opened.notes.end(),
        [&](const Sentence& note) { return in_english(note).find(what) != std::string::npos; });
  }
  // Every kind of step; its journal is let go.
  OpenedSession worked(const std::string& start = "layout.json", bool keep_models = false) const {
    OpenedSession opened = open(start, keep_models);
    Session& session = opened.session;
    work(session);
    EXPECT_TRUE(session.perform(FixOperation{"b", true}).ok());
    EXPECT_TRUE(session.perform(put_at("c", 0.1, 0.1)).ok());
    EXPECT_TRUE(session.perform(DuplicateOperation{"c", "d"}).ok());
    EXPECT_TRUE(session.perform(RenameOperation{"d", "e"}).ok());
    EXPECT_TRUE(session.perform_all({put_at("e", 1, 0), GroupOperation{"e", "set"}}).ok());
    EXPECT_TRUE(session.perform(delete_of("a")).ok());
    UnplaceOperation unplace;
    unplace.object = "c";
    EXPECT_TRUE(session.perform(unplace).ok());
    EXPECT_TRUE(session.undo());
    session.keep_journal(nullptr);
    return opened;
  }
};

TEST_F(JournalSurvives, StartThatIsWrittenTruncatedOrReplaced) {
  OpenedSession opened = worked();
  EXPECT_EQ(fs::hard_link_count(path("j.start")), 1u);
  const std::string layout = read("layout.json");
  const std::vector<std::function<void()>> edits = {
      [&] { write("layout.json", "{}"); },  // in place
      [&] { fs::resize_file(path("layout.json"), 5); },
      [&] { fs::remove(path("layout.json")); },
      [&] {
        write("new.json", layout + " ");
        fs::rename(path("new.json"), path("layout.json"));
      },
  };
  for (const auto& edit : edits) {
    edit();
    const RestoredSession restored = restore();
    EXPECT_TRUE(restored.exact);
    EXPECT_EQ(fingerprint(restored.opened.session.scene()), fingerprint(opened.session.scene()));
  }
}

TEST_F(JournalSurvives, LeavesAFileOfTheUserAlone) {
  write("j.start", "mine");
  EXPECT_THROW(open(), Error);
  EXPECT_EQ(read("j.start"), "mine");
  EXPECT_FALSE(fs::exists(path("j")));
  // A start under that name would change with its file.
  fs::rename(path("layout.json"), path("j.start"));
  EXPECT_THROW(open_session(path("j.start"), {}, {}, {path("j")}), Error);
  fs::rename(path("j.start"), path("layout.json"));
  fs::create_hard_link(path("layout.json"), path("j.start"));
  EXPECT_THROW(open(), Error);
  fs::remove(path("j.start"));
  fs::copy_file(path("layout.json"), path("j.start"));
  EXPECT_NO_THROW(open());
}

TEST_F(JournalSurvives, ModelThatHasChanged) {
  OpenedSession opened = worked();
  write("box.obj", kLargerBox);
  RestoredSession restored = restore(true);
  EXPECT_FALSE(restored.exact);
  EXPECT_EQ(restored.opened.session.journal(), nullptr);
  EXPECT_TRUE(notes(restored, "\"box.obj\" has changed since the session"));
  const Scene& scene = restored.opened.session.scene();
  EXPECT_EQ(scene.at(*scene.find("b")).shape->box.upper.x(), 0.2001);
  expect_same_poses(restored.opened.session, opened.session);
}

TEST_F(JournalSurvives, ModelOfASceneFileThatHasChanged) {
  { save_session(*std::make_unique<OpenedSession>(worked()), "1", path("scene.glb")); }
  remove_journal();
  OpenedSession opened = open("scene.glb");
  EXPECT_TRUE(opened.session.perform(append_of("f", "box.obj")).ok());
  write("other.obj", read("box.obj"));
  EXPECT_TRUE(opened.session.perform(append_of("g", "other.obj")).ok());
  EXPECT_TRUE(opened.session.perform(put_at("g", 2, 2)).ok());
  EXPECT_TRUE(opened.session.perform(put_at("f", 2.05, 2)).ok());
  write("other.obj", kLargerBox);
  RestoredSession restored = restore();
  EXPECT_FALSE(restored.exact);
  EXPECT_TRUE(notes(restored, "\"other.obj\" has changed since the session"));
  opened.session.keep_journal(nullptr);
  expect_same_poses(restored.opened.session, opened.session);
}

TEST_F(JournalSurvives, ModelThatIsGoneOrDamaged) {
  OpenedSession opened = worked();
  for (const bool damaged : {true, false}) {
    if (damaged)
      write("box.obj", "v 0 0");
    else
      fs::remove(path("box.obj"));
    RestoredSession restored = restore();
    EXPECT_FALSE(restored.exact);
    EXPECT_TRUE(notes(restored, "a box of its size stands in for it"));
    const Scene& scene = restored.opened.session.scene();
    EXPECT_EQ(scene.at(*scene.find("b")).shape->box.upper, Vec3::Constant(0.2));
    while (opened.session.redo()) continue;
    opened.session.undo();
    expect_same_poses(restored.opened.session, opened.session);
  }
}

TEST_F(JournalSurvives, ModelsThatItKeeps) {
  OpenedSession opened = worked("layout.json", true);
  for (const bool gone : {false, true}) {
    if (gone)
      fs::remove(path("box.obj"));
    else
      write("box.obj", kLargerBox);
    const RestoredSession restored = restore();
    EXPECT_TRUE(restored.exact);
    EXPECT_TRUE(restored.opened.notes.empty());
    EXPECT_EQ(fingerprint(restored.opened.session.scene()), fingerprint(opened.session.scene()));
  }
  // Nor does it believe what it kept.
  for (const fs::directory_entry& kept : fs::directory_iterator(path("j.models")))
    write(fs::relative(kept.path(), path("")).string(), "damaged");
  EXPECT_TRUE(notes(restore(), "a box of its size stands in for it"));
}

TEST_F(JournalSurvives, OfVersion1IsDoneAgainAsFarAsItsModelsAreThere) {
  write("other.obj", read("box.obj"));
  {
    OpenedSession opened = open();
    work(opened.session);
    EXPECT_TRUE(opened.session.perform(append_of("z", "other.obj")).ok());
    EXPECT_TRUE(opened.session.perform(put_at("z", 1, 2)).ok());
    EXPECT_TRUE(opened.session.perform(put_at("z", 2, 2)).ok());
  }
  std::istringstream lines(read("j"));
  std::string old;
  for (std::string line; std::getline(lines, line);) {
    auto json = JournalJson::parse(line);
    for (const char* const key : {"sum", "models", "poses"}) json.erase(key);
    if (json.contains("trivet_journal")) json["trivet_journal"] = 1;
    old += journal_line(json);
  }
  write("j", old);
  EXPECT_TRUE(restore().exact);
  write("other.obj", kLargerBox);
  RestoredSession restored = restore();
  EXPECT_EQ(restored.opened.session.num_done(), 5u);  // it records neither models nor poses
  EXPECT_TRUE(notes(restored, "is of an earlier version"));
  fs::remove(path("other.obj"));
  EXPECT_EQ(restore().opened.session.num_done(), 2u);
}

TEST_F(JournalSurvives, NoStepIsDoneWithoutIt) {
  OpenedSession opened = open();
  ASSERT_TRUE(opened.session.perform(put_at("b", 1, 0)).ok());
  const Scene before = opened.session.scene();
  const auto complaint_of_a_step = [&]() -> std::string {
    try {
      opened.session.perform(put_at("b", 2, 0));
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), Error::Kind::Environment);
      return e.what();
    }
    return "";
  };
  const std::string journal = read("j");
  write("j", journal + "x");
  EXPECT_NE(complaint_of_a_step().find("another program has changed the journal"),
            std::string::npos);
  EXPECT_EQ(read("j"), journal + "x");
  fs::remove(path("j"));
  EXPECT_NE(complaint_of_a_step().find("the journal was deleted"), std::string::npos);
  EXPECT_THROW(opened.session.undo(), Error);
  EXPECT_EQ(difference(opened.session.scene(), before), "");
  EXPECT_FALSE(fs::exists(path("j")));
}

}  // namespace
}  // namespace trivet::test
