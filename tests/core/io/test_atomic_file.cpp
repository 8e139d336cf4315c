// Atomic writes: the target is the old file or the whole new one, and no other file is left.
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "core/io/atomic_file.h"
#include "core/io/export.h"
#include "core/io/io_testing.h"

namespace trivet {
namespace {

using testing::error_of;
using testing::expect_parts;
using testing::read_bytes;

class AtomicFile : public testing::IoTest {
 protected:
  std::string refusal(const std::string& file, const std::string& bytes = "new") const {
    return error_of([&] { write_file_atomically(file, bytes); }, Error::Kind::Environment);
  }
  int num_files() const {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder()))
      ++count;
    return count;
  }
};

TEST_F(AtomicFile, WritesAndReplaces) {
  write_file_atomically(path("f"), "first");
  EXPECT_EQ(read_bytes(path("f")), "first");
  write_file_atomically(path("f"), std::string("sec\0nd", 6));
  EXPECT_EQ(read_bytes(path("f")), std::string("sec\0nd", 6));
  EXPECT_EQ(num_files(), 1);
}

TEST_F(AtomicFile, KeepsModeAndLinks) {
  write("real", "old");
  chmod(path("real").c_str(), 0640);
  std::filesystem::create_symlink("real", path("link"));
  write_file_atomically(path("link"), "new");
  EXPECT_EQ(read_bytes(path("real")), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(static_cast<int>(std::filesystem::status(path("real")).permissions()), 0640);
}

TEST_F(AtomicFile, MakesMissingFolders) {
  write_file_atomically(path("none/at/all/f"), "new");
  EXPECT_EQ(read_bytes(path("none/at/all/f")), "new");
}

TEST_F(AtomicFile, LeavesNoFolderOfWhatFails) {
  const auto fail = [](const ByteSink&) { throw Error(Error::Kind::Environment, "no more"); };
  EXPECT_THROW(write_file_atomically(path("none/f"), fail), Error);
  EXPECT_EQ(num_files(), 0);
}

TEST_F(AtomicFile, ReportsFoldersThatCannotBeMade) {
  expect_parts(refusal("/proc/none/f"), {"/proc/none", "cannot be made"});
  expect_parts(refusal(""), {"cannot be written"});
}

TEST_F(AtomicFile, RejectsFolderAsTarget) {
  std::filesystem::create_directory(path("d"));
  expect_parts(refusal(path("d")), {path("d"), "Is a directory"});
  EXPECT_EQ(num_files(), 1);
}

TEST_F(AtomicFile, ReportsUnwritableFolder) {
  write("f", "old");
  chmod(path("f").c_str(), 0666);
  chmod(folder().c_str(), 0555);
  const testing::OrdinaryUser user;
  if (!user) GTEST_SKIP() << "cannot drop root privileges";
  expect_parts(refusal(path("f")), {path("f"), "Permission denied"});
  EXPECT_EQ(read_bytes(path("f")), "old");
  EXPECT_EQ(num_files(), 1);
}

TEST_F(AtomicFile, ReportsUnwritableFile) {
  write("f", "old");
  chmod(path("f").c_str(), 0444);
  chmod(folder().c_str(), 0777);
  const testing::OrdinaryUser user;
  if (!user) GTEST_SKIP() << "cannot drop root privileges";
  expect_parts(refusal(path("f")), {path("f"), "Permission denied"});
  EXPECT_EQ(read_bytes(path("f")), "old");
}

// A file size limit simulates a full disk: write() fails half-way.
TEST_F(AtomicFile, KeepsOldFileOnWriteError) {
  write("f", "old");
  rlimit old_limit;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = old_limit;
  limit.rlim_cur = 1 << 16;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  const std::string message = refusal(path("f"), std::string(1 << 20, 'x'));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);
  expect_parts(message, {path("f"), "File too large"});
  EXPECT_EQ(read_bytes(path("f")), "old");
  EXPECT_EQ(num_files(), 1);
}

TEST_F(AtomicFile, WritesThroughToDevices) {
  write_file_atomically("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  expect_parts(refusal("/dev/full"), {"/dev/full", "No space left on device"});
}

TEST_F(AtomicFile, LeavesOneWholeFileOfManyWriters) {
  std::vector<std::thread> threads;
  for (char c = 'a'; c < 'i'; ++c)
    threads.emplace_back([this, c] {
      for (int i = 0; i < 20; ++i) write_file_atomically(path("f"), std::string(10'000, c));
    });
  for (std::thread& thread : threads) thread.join();
  const std::string bytes = read_bytes(path("f"));
  EXPECT_EQ(bytes, std::string(10'000, bytes[0]));
  EXPECT_EQ(num_files(), 1);
}

TEST_F(AtomicFile, KeepsOldObjWhenMaterialsFail) {
  const auto model = std::make_shared<const Model>(testing::tetrahedron_model());
  const std::string old = "mtllib s.mtl\n";  // otherwise s.mtl would belong to another scene
  write("s.obj", old);
  std::filesystem::create_directory(path("s.mtl"));  // blocks the file
  error_of(
      [&] {
        write_scene({{{"t", model, {}, ""}}, ""}, path("s.obj"));
      },
      Error::Kind::Environment);
  EXPECT_EQ(read_bytes(path("s.obj")), old);
}

}  // namespace
}  // namespace trivet
