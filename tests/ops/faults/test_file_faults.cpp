// Sessions whose memory runs out or whose disk fails, at any allocation and any file operation of a
// step, an undo, a save or an export: the scene and every file are as before or as after, never
// between, and the journal restores the session.
//
// TRIVET_TEST_EFFORT=50 runs 1,000 sequences.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <new>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/mesh_model.h"
#include "core/scene/allocation_faults.h"
#include "core/scene/fingerprint.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/faults/random_piles.h"
#include "ops/files/layout/paths.h"
#include "ops/files/report/report.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/journal.h"
#include "ops/session/restore.h"
#include "support/effort.h"
#include "support/file_faults.h"
#include "support/temporary_folder.h"

namespace trivet::test {
namespace {

namespace fs = std::filesystem;

/// Names and bytes.
using Files = std::map<std::string, std::string>;

Files files_in(const fs::path& folder) {
  Files out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    out[entry.path().filename().string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return out;
}

/// Scene, steps and files.
struct State {
  std::uint64_t scene = 0;
  size_t num_done = 0, num_steps = 0;
  Files files;

  friend bool operator==(const State&, const State&) = default;
};

// Exit statuses of children.
constexpr int kFailed = 3, kWrong = 4;

struct Counts {
  int allocations = 0, file_calls = 0;  // that failed
  int aborts = 0;                       // of the allocations
  int refused = 0, done = 0;            // operations
};

class FaultySession {
 public:
  explicit FaultySession(unsigned seed)
      : m_random(seed), m_opened(open_random_scene(m_random, m_folder)) {}

  using Work = std::function<void()>;
  /// True if a state that is not the one before is right.
  using IsAfter = std::function<bool(const State& before, const State& now)>;

  /// Fails `work` at some allocations, then at all its file operations in turn, until it is done.
  void expect_all_or_nothing(const Work& work, const IsAfter& is_after) {
    for (int i = 0; i < kNumAllocations && !failed(); ++i) run_out_of_memory(work, is_after);
    State before = state();
    const auto kind = m_random.integer(0, 1) ? FileFault::Kind::Once : FileFault::Kind::DiskFull;
    bool done = false;
    for (int n = 0; !done && !failed(); ++n) {
      {
        const FileFault fault(kind, n);
        done = completes(work);
        m_counts.file_calls += fault.has_failed();
        EXPECT_TRUE(done || fault.has_failed());
      }
      State now = state();
      EXPECT_TRUE(now == before || is_after(before, now)) << (done ? "done" : "failed");
      EXPECT_TRUE(session().scene().is_consistent());
      before = std::move(now);
    }
  }

  Session& session() { return m_opened.session; }
  const Session& session() const { return m_opened.session; }
  OpenedSession& opened() { return m_opened; }
  Random& random() { return m_random; }
  std::string file(const std::string& name) const { return m_folder.file(name); }
  Counts& counts() { return m_counts; }

 private:
  static constexpr int kNumAllocations = 3;

  // In a process of its own: the destructors of nlohmann::json allocate, and end it when they fail.
  // Then the files count, as after any crash.
  void run_out_of_memory(const Work& work, const IsAfter& is_after) {
    const State before = state();
    const std::int64_t n = m_random.integer(0, 1 << m_random.integer(4, 13));
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      alarm(60);
      std::fclose(stderr);
      bool has_failed = false;
      {
        const AllocationFault fault(n);
        completes(work);
        has_failed = fault.has_failed();
      }
      const State now = state();
      const bool right =
          session().scene().is_consistent() && (now == before || is_after(before, now));
      _exit(!right ? kWrong : has_failed ? kFailed : 0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    const bool aborted = WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
    ASSERT_TRUE(aborted || WIFEXITED(status)) << "status " << status;
    EXPECT_TRUE(aborted || WEXITSTATUS(status) != kWrong) << "allocation " << n;
    m_counts.allocations += aborted || WEXITSTATUS(status) == kFailed;
    m_counts.aborts += aborted;
    for (const auto& [name, bytes] : files_in(m_folder.file(""))) {
      const auto old = before.files.find(name);
      if (!aborted || name.front() == '.' || (old != before.files.end() && old->second == bytes))
        continue;
      EXPECT_TRUE(is_file_of_after(name, bytes, before)) << name;
    }
    restore(before.files);
  }

  // After an abort only what is whole can be told: a journal with one more line, or another file.
  static bool is_file_of_after(const std::string& name, const std::string& bytes,
                               const State& before) {
    if (name != "journal") return !bytes.empty();
    return bytes.rfind(before.files.at(name), 0) == 0 && bytes.back() == '\n';
  }

  void restore(const Files& files) const {
    for (const auto& [name, bytes] : files_in(m_folder.file(""))) {
      const auto old = files.find(name);
      if (old == files.end())
        fs::remove(file(name));
      else if (old->second != bytes)
        std::ofstream(file(name), std::ios::binary) << old->second;  // the same file, for journals
    }
  }

  static bool failed() { return testing::Test::HasFailure(); }

  static OpenedSession open_random_scene(Random& random, const TemporaryFolder& folder) {
    Scene scene = random_scene(random);
    for (const ObjectId id : scene.ids())  // of no file: the scene file keeps the doubles
      edit_object(scene, id, [](Object& object) {
        object.model = std::make_shared<const Model>(model_of_mesh(object.shape->mesh));
      });
    write_scene_file(scene, {}, {}, folder.file("start.glb"));
    return open_session(folder.file("start.glb"), {}, {}, {folder.file("journal")});
  }

  static bool completes(const Work& work) {
    try {
      work();
      return true;
    } catch (const std::bad_alloc&) {
      return false;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), Error::Kind::Environment) << e.what();
      return false;
    }
  }

  State state() const {
    return {fingerprint(session().scene()), session().num_done(), session().steps().size(),
            files_in(m_folder.file(""))};
  }

  Random m_random;
  TemporaryFolder m_folder;
  OpenedSession m_opened;
  Counts m_counts;
};

/// True if the files are those before, but for one more line of the journal.
bool has_one_more_line(const Files& before, Files now) {
  const std::string& old = before.at("journal");
  std::string& journal = now.at("journal");
  if (journal.rfind(old, 0) != 0 || journal.empty() || journal.back() != '\n') return false;
  if (journal.find('\n', old.size()) != journal.size() - 1) return false;
  journal = old;
  return now == before;
}

void step(FaultySession& s) {
  const Operation operation = random_operation(s.random());
  Scene copy = s.session().scene();
  const OperationResult expected = perform(copy, operation);
  ++(expected.ok() ? s.counts().done : s.counts().refused);
  OperationResult result;
  s.expect_all_or_nothing([&] { result = s.session().perform(operation); },
                          [&](const State& before, const State& now) {
                            return expected.ok() && now.scene == fingerprint(copy) &&
                                   now.num_done == before.num_done + 1 &&
                                   now.num_steps == now.num_done &&
                                   has_one_more_line(before.files, now.files);
                          });
  EXPECT_EQ(result.ok(), expected.ok()) << result.reason();
}

void undo(FaultySession& s) {
  const size_t num_done = s.session().num_done();
  if (num_done == 0) return;
  s.expect_all_or_nothing([&] { s.session().undo(); },
                          [&](const State& before, const State& now) {
                            return now.num_done + 1 == before.num_done &&
                                   now.num_steps == before.num_steps &&
                                   has_one_more_line(before.files, now.files);
                          });
  EXPECT_EQ(s.session().num_done(), num_done - 1);
}

/// Files that a copy of the work writes in a folder of its own.
Files written_by(const std::function<void(const std::string& folder)>& work) {
  const TemporaryFolder folder;
  work(folder.file(""));
  return files_in(folder.file(""));
}

void save(FaultySession& s) {
  const std::string bytes =
      scene_file_bytes(s.session().scene(), s.session().layout(),
                       {"1", folder_from(s.file("scene.glb"), s.opened().model_folder),
                        settled_clearance(s.opened())});
  s.expect_all_or_nothing([&] { save_session(s.opened(), "1", s.file("scene.glb")); },
                          [&](const State& before, const State& now) {
                            State same = before;
                            same.files["scene.glb"] = bytes;
                            if (same == now) return true;  // saved, and not yet noted
                            const bool noted = has_one_more_line(same.files, now.files);
                            same.files = now.files;
                            return noted && same == now;
                          });
  EXPECT_FALSE(s.session().is_modified());
}

/// Exports for other programs: several files that belong together.
void export_files(FaultySession& s, const std::string& name) {
  const auto write = [&](const std::string& folder) {
    write_scene_file(s.session().scene(), {}, {}, folder + name);
  };
  const Files written = written_by(write);
  EXPECT_EQ(written.size(), 2u);
  s.expect_all_or_nothing([&] { write(s.file("")); },
                          [&](State before, const State& now) {
                            for (const auto& [file, bytes] : written) before.files[file] = bytes;
                            return before == now;
                          });
}

void report(FaultySession& s) {
  LayoutRun run;
  run.scene = s.session().scene();
  finish_run({}, run);
  const std::string text = report_json(run, {});
  s.expect_all_or_nothing([&] { write_file_atomically(s.file("report.json"), text); },
                          [&](State before, const State& now) {
                            before.files["report.json"] = text;
                            return before == now;
                          });
}

void expect_restored(FaultySession& s) {
  const RestoredSession restored = restore_session(s.file("journal"), {}, {}, false);
  const Session& back = restored.opened.session;
  EXPECT_TRUE(restored.exact);
  for (const Sentence& note : restored.opened.notes) ADD_FAILURE() << in_english(note);
  EXPECT_EQ(fingerprint(back.scene()), fingerprint(s.session().scene()));
  EXPECT_EQ(back.num_done(), s.session().num_done());
  EXPECT_EQ(back.steps().size(), s.session().steps().size());
  EXPECT_EQ(back.is_modified(), s.session().is_modified());
}

TEST(FileFaults, LeaveSceneAndFilesAsBeforeOrAsAfter) {
  const int num_sequences = with_effort(20);
  Counts all;
  for (int i = 0; i < num_sequences && !HasFailure(); ++i) {
    SCOPED_TRACE("sequence " + std::to_string(i));
    FaultySession s(1000 + i);
    for (int round = 0; round < 3 && !HasFailure(); ++round) {
      step(s);
      if (s.random().integer(0, 2) == 0) undo(s);
      step(s);
      save(s);
      export_files(s, s.random().integer(0, 1) ? "scene.gltf" : "scene.obj");
      report(s);
    }
    expect_restored(s);
    all.allocations += s.counts().allocations;
    all.file_calls += s.counts().file_calls;
    all.aborts += s.counts().aborts;
    all.refused += s.counts().refused;
    all.done += s.counts().done;
  }
  std::printf(
      "%d sequences: %d operations done, %d refused; %d allocations (%d in destructors of a "
      "library) "
      "and %d file calls failed\n",
      num_sequences, all.done, all.refused, all.allocations, all.aborts, all.file_calls);
  EXPECT_GT(all.done, 2 * num_sequences);
  EXPECT_GT(all.allocations, 10 * num_sequences);
  EXPECT_GT(all.file_calls, 50 * num_sequences);
}

}  // namespace
}  // namespace trivet::test
