// Importers that are started once for several files.
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "core/io/io_testing.h"
#include "core/io/model_bytes.h"
#include "core/io/process/sandboxed_import.h"

namespace trivet {
namespace {

using testing::error_of;
using testing::expect_parts;

constexpr const char* kOneTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* kOneSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

class SharedImportersTest : public testing::IoTest {
 protected:
  void SetUp() override {
    IoTest::SetUp();
    const auto build = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
    m_real = build / "apps/trivet-import";
    ASSERT_EQ(access(m_real.c_str(), X_OK), 0) << m_real;
    m_limits.importer =
        script("echo start >> " + path("starts") + "\nexec " + m_real + " \"$@\"\n");
  }
  std::string script(const std::string& text) const {
    const std::string file = write("importer", "#!/bin/sh\n" + text);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }
  size_t num_starts() const {
    std::ifstream file(path("starts"));
    size_t out = 0;
    for (std::string line; std::getline(file, line);) ++out;
    return out;
  }

  std::string m_real;
  ImportLimits m_limits;
};

TEST_F(SharedImportersTest, ReadTheSameModels) {
  const std::string files[] = {write("a.obj", kOneTriangle), write("b.obj", kOneSquare),
                               write("c.obj", kOneTriangle)};
  std::vector<std::string> alone, shared;
  for (const std::string& file : files)
    alone.push_back(bytes_of_model(read_model_sandboxed(file, m_limits)));
  EXPECT_EQ(num_starts(), 3u);
  {
    const SharedImporters importers;
    for (const std::string& file : files)
      shared.push_back(bytes_of_model(read_model_sandboxed(file, m_limits)));
  }
  EXPECT_EQ(num_starts(), 4u);
  EXPECT_EQ(alone, shared);
  read_model_sandboxed(files[0], m_limits);
  EXPECT_EQ(num_starts(), 5u) << "it lives as long as the scope";
}

TEST_F(SharedImportersTest, GoOnAfterBadFiles) {
  const std::string good = write("good.obj", kOneTriangle), bad = write("bad.obj", "v 0 0 nan\n");
  const std::string square = write("square.obj", kOneSquare);
  ImportLimits little = m_limits;
  little.max_triangles = 1;
  const SharedImporters importers;
  read_model_sandboxed(good, m_limits);
  expect_parts(error_of([&] { read_model_sandboxed(bad, m_limits); }), {"bad.obj"});
  expect_parts(error_of([&] { read_model_sandboxed(square, little); }),
               {"square.obj", "limit of 1"});
  EXPECT_EQ(read_model_sandboxed(square, m_limits).mesh.triangles.size(), 2u)
      << "limits are those of each file";
  read_model_sandboxed(good, m_limits);
  EXPECT_LE(num_starts(), 2u) << "at most one that a file ended";
}

// As if the process that reads were at fault; the next file has a new one.
TEST_F(SharedImportersTest, StartAnewAfterTheirEnd) {
  const std::string good = write("good.obj", kOneTriangle);
  const SharedImporters importers;
  ImportLimits crashing = m_limits;
  crashing.importer = script("kill -SEGV $$\n");
  expect_parts(error_of([&] { read_model_sandboxed(good, crashing); }),
               {"good.obj", "Segmentation fault"});
  crashing.importer = script("exit 5\n");
  expect_parts(error_of([&] { read_model_sandboxed(good, crashing); }), {"status 5"});
  crashing.importer = script("exec " + m_real + " \"$@\"\n");
  EXPECT_EQ(read_model_sandboxed(good, crashing).mesh.triangles.size(), 1u);
}

TEST_F(SharedImportersTest, AreKilledAtTheLimitAndWhenCancelled) {
  const std::string good = write("good.obj", kOneTriangle);
  m_limits.importer = script("echo $$ >> " + path("starts") + "\nexec sleep 1000\n");
  m_limits.max_seconds = 0.2;
  std::atomic<bool> cancel = false;
  {
    const SharedImporters importers;
    expect_parts(error_of([&] { read_model_sandboxed(good, m_limits); }),
                 {"longer than the limit"});
    m_limits.max_seconds = 1000;
    std::jthread stopping([&] {
      while (num_starts() < 2) std::this_thread::yield();
      cancel = true;
    });
    expect_parts(error_of([&] { read_model_sandboxed(good, m_limits, {}, &cancel); }),
                 {"cancelled"});
  }
  std::ifstream file(path("starts"));
  for (int id = 0; file >> id;) EXPECT_NE(kill(id, 0), 0) << id << " still runs";
}

TEST_F(SharedImportersTest, AreOfOneThread) {
  const std::string good = write("good.obj", kOneTriangle);
  const SharedImporters importers;
  std::thread([&] { read_model_sandboxed(good, m_limits); }).join();
  read_model_sandboxed(good, m_limits);
  read_model_sandboxed(good, m_limits);
  EXPECT_EQ(num_starts(), 2u);
}

}  // namespace
}  // namespace trivet
