// Units: the same scenes are the same bytes, the first one wins, and no changed bit stays unseen.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "apps/farm/scene/model_store.h"
#include "apps/farm/store/publish.h"
#include "apps/farm/store/run_file.h"
#include "apps/farm/store/unit.h"
#include "core/base/error.h"
#include "support/effort.h"
#include "support/temporary_folder.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

const std::string kBatch(64, 'a');
constexpr UnitFormat kFormats[] = {UnitFormat::Tar, UnitFormat::Dir, UnitFormat::Poses};

struct TemporaryFolder : test::TemporaryFolder {
  std::string path() const { return file(""); }
};

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

Json scene(std::uint64_t k) {
  return {{"k", k},
          {"status", k % 3 == 0 ? "refused" : "ok"},
          {"margin", 0.1 / static_cast<double>(k + 1)},
          {"objects",
           {{{"name", "a"}, {"position", {0.1, -0.0, 1e-300}}},
            {{"name", "b"}, {"position", nullptr}}}}};
}

bool write_unit(const std::string& out, UnitFormat format, bool more) {
  UnitWriter writer(out, 1, format, kBatch);
  for (std::uint64_t k = 4; k < 8; ++k) {
    SceneMembers members{scene(k), {}};
    if (more && format != UnitFormat::Poses)
      members.more.push_back({member_name(k, ".glb"), "binary " + std::to_string(k)});
    writer.add(members);
  }
  return writer.publish();
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

TEST(Unit, IsTheSameBytesAndTheFirstWins) {
  for (const UnitFormat format : kFormats) {
    const TemporaryFolder a, b;
    EXPECT_TRUE(write_unit(a.path(), format, true));
    EXPECT_TRUE(write_unit(b.path(), format, true));
    const auto of_a = files_of(a.path()), of_b = files_of(b.path());
    ASSERT_EQ(of_a.size(), of_b.size());
    ASSERT_EQ(of_a.size(), is_folder(format) ? 9u : 1u);
    for (size_t i = 0; i < of_a.size(); ++i) EXPECT_EQ(bytes_of(of_a[i]), bytes_of(of_b[i]));
    EXPECT_FALSE(write_unit(a.path(), format, false)) << "the second is dropped";
    EXPECT_EQ(files_of(a.path()), of_a) << "and leaves nothing";
    EXPECT_EQ(check_unit(a.path(), 1, format, kBatch, {}), "");
  }
}

TEST(Unit, IsReadBack) {
  for (const UnitFormat format : kFormats) {
    const TemporaryFolder out;
    ASSERT_TRUE(write_unit(out.path(), format, true));
    std::vector<Json> rows;
    visit_rows(out.path(), 1, format, kBatch, [&](const Json& row) { rows.push_back(row); });
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[2].at("k"), 6);
    EXPECT_EQ(rows[2].at("objects"), 1);
    SceneReader reader(out.path(), format);
    for (const std::uint64_t k : {5u, 7u, 4u, 4u, 5u, 6u})  // back, too
      EXPECT_EQ(json_line(reader.read(1, k)), json_line(scene(k)));
    EXPECT_THROW(reader.read(1, 8), Error);
    EXPECT_THROW(reader.read(1, 3), Error);
    EXPECT_EQ(json_line(reader.read(1, 6)), json_line(scene(6))) << "after an error";
    EXPECT_THROW(reader.read(2, 8), Error) << "no such unit";
  }
}

TEST(Unit, OfADataSetIsAFolderOfOneScene) {
  for (const UnitFormat format : {UnitFormat::Bop, UnitFormat::Coco}) {
    const TemporaryFolder out;
    UnitWriter writer(out.path(), 7, format, kBatch);
    SceneMembers members{scene(7), {}};
    for (const char* name : {"000000.png", "annotations.json", "mask/000000_000000.png",
                             "mask_visib/000000_000000.png", "scene_gt.json", "scene_gt_info.json"})
      members.more.push_back({name, std::string("bytes of ") + name});
    writer.add(members);
    ASSERT_TRUE(writer.publish());
    EXPECT_EQ(check_unit(out.path(), 7, format, kBatch, {}), "");
    EXPECT_EQ(json_line(SceneReader(out.path(), format).read(7, 7)), json_line(scene(7)));
    size_t num_rows = 0;
    visit_rows(out.path(), 7, format, kBatch, [&](const Json& row) {
      EXPECT_EQ(row.at("k"), 7);
      EXPECT_EQ(row.at("members").size(), 7u);
      ++num_rows;
    });
    EXPECT_EQ(num_rows, 1u);
    for (const fs::path& file : files_of(out.path())) {
      const std::string bytes = bytes_of(file);
      std::string changed = bytes;
      changed[changed.size() / 2] ^= 1;
      write(file, changed);
      EXPECT_NE(check_unit(out.path(), 7, format, kBatch, {}), "") << file;
      write(file, bytes);
    }
  }
}

TEST(Unit, OfAnotherBatchOrNumberIsFound) {
  for (const UnitFormat format : kFormats) {
    const TemporaryFolder out;
    ASSERT_TRUE(write_unit(out.path(), format, true));
    const auto read = [&](std::uint64_t unit, const std::string& batch) -> std::string {
      std::string finding = check_unit(out.path(), unit, format, batch, {});
      try {
        visit_rows(out.path(), unit, format, batch, [](const Json&) {});
      } catch (const Error& e) {
        EXPECT_EQ(finding, e.what());
        return finding;
      }
      EXPECT_EQ(finding, "");
      return "";
    };
    EXPECT_EQ(read(1, kBatch), "");
    const std::string of_another = "is a unit of another batch than run.json says";
    EXPECT_NE(read(1, std::string(64, 'b')).find(of_another), std::string::npos);
    EXPECT_NE(read(1, "").find(of_another), std::string::npos);
    const fs::path folder(out.path());
    fs::rename(folder / unit_name(1, format), folder / unit_name(2, format));
    EXPECT_NE(read(2, kBatch).find("is another unit of the batch"), std::string::npos);
  }
}

// Bytes that this process has read, as the kernel counts them.
std::uint64_t bytes_read() {
  std::ifstream in("/proc/self/io");
  std::uint64_t count = 0;
  std::string key;
  return in >> key >> count ? count : 0;
}

TEST(SceneReader, ReadsAUnitOnce) {
  if (bytes_read() == 0) GTEST_SKIP() << "no /proc/self/io here";
  constexpr std::uint64_t kCount = 100;
  for (const UnitFormat format : kFormats) {
    const TemporaryFolder out;
    {
      UnitWriter writer(out.path(), 0, format, kBatch);
      for (std::uint64_t k = 0; k < kCount; ++k) {
        Json large = scene(k);
        large["reason"] = std::string(10'000, 'x');
        writer.add({large, {}});
      }
      ASSERT_TRUE(writer.publish());
    }
    SceneReader reader(out.path(), format);
    const std::uint64_t before = bytes_read();
    for (std::uint64_t k = 0; k < kCount; ++k) EXPECT_EQ(reader.read(0, k).at("k"), k);
    EXPECT_LT(bytes_read() - before, 4 * 10'000 * kCount);
  }
}

// One bit of every 41st byte of every file; of every byte with TRIVET_TEST_EFFORT=41.
TEST(Unit, DetectsEveryFlippedBit) {
  for (const UnitFormat format : kFormats) {
    const TemporaryFolder out;
    ASSERT_TRUE(write_unit(out.path(), format, true));
    const auto step = static_cast<size_t>(std::max(1, 41 / test::with_effort(1)));
    unsigned bit = 0;
    for (const fs::path& file : files_of(out.path())) {
      const std::string good = bytes_of(file);
      for (size_t i = 0; i < good.size(); i += step) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ (1 << (bit++ * 5 % 8)));
        write(file, bad);
        ASSERT_NE(check_unit(out.path(), 1, format, kBatch, {}), "") << file << " byte " << i;
      }
      write(file, good.substr(0, good.size() / 2));
      EXPECT_NE(check_unit(out.path(), 1, format, kBatch, {}), "") << "truncated";
      write(file, good + '\0');
      EXPECT_NE(check_unit(out.path(), 1, format, kBatch, {}), "") << "longer";
      write(file, good);
    }
    EXPECT_EQ(check_unit(out.path(), 1, format, kBatch, {}), "");
  }
}

TEST(PublishedFile, VanishesUnlessPublished) {
  const TemporaryFolder out;
  const std::string path = out.file("a/file");
  {
    PublishedFile file(path);
    file.write("half");
    EXPECT_TRUE(is_temporary(fs::path(temporary_name(path)).filename().string()));
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_TRUE(files_of(out.path()).empty());
}

TEST(PublishedFile, IsKnownWhileItIsWritten) {
  const TemporaryFolder out;
  std::string left;
  const auto temporary = [&] {
    for (const auto& entry : fs::directory_iterator(out.path()))
      if (is_temporary(entry.path().filename().string())) return entry.path().string();
    return std::string();
  };
  {
    const PublishedFile file(out.file("file"));
    left = temporary();
    EXPECT_TRUE(is_being_written(left));
  }
  EXPECT_FALSE(is_being_written(left)) << "gone";
  write(left, "half");
  EXPECT_FALSE(is_being_written(left)) << "left by a process that was killed";
  fs::remove(left);
  const PublishedFolder folder(out.file("folder"));
  EXPECT_TRUE(is_being_written(temporary()));
}

TEST(TimeIn, IsThatOfTheFileSystem) {
  const TemporaryFolder out;
  const auto before = time_in(out.path());
  write(out.file("a"), "a");
  EXPECT_LE(before, fs::last_write_time(out.file("a")));
  EXPECT_LE(fs::last_write_time(out.file("a")), time_in(out.path()));
  EXPECT_EQ(files_of(out.path()).size(), 1u);
}

TEST(ModelStore, KeepsWhatAModelRefersTo) {
  const TemporaryFolder in, out;
  const fs::path folder(in.path());
  write(folder / "a.obj", "mtllib my look.mtl\nv 0 0 0\n");
  write(folder / "my look.mtl",
        "newmtl x\nmap_Kd -s 1 1 1 textures/wood.png\nmap_Bump ../secret.png\n");
  write(folder / "textures/wood.png", "image");
  write(folder / "b.gltf", R"({"buffers": [{"uri": "b%20c.bin"}, {"uri": "data:,x"}]})");
  write(folder / "b c.bin", "buffer");
  const BatchModel a = batch_model((folder / "a.obj").string());
  EXPECT_EQ(a.beside, (std::vector<std::string>{"my look.mtl", "textures/wood.png"}));
  const BatchModel b = batch_model((folder / "b.gltf").string());
  EXPECT_EQ(b.beside, (std::vector<std::string>{"b c.bin"}));
  store_model(a, out.path());
  store_model(a, out.path());
  EXPECT_EQ(files_of(out.path()).size(), 3u);
  EXPECT_EQ(check_stored(out.path(), a.stored_path()), "");
  write(fs::path(out.path()) / "models" / a.hash / "textures/wood.png", "imagf");
  EXPECT_NE(check_stored(out.path(), a.stored_path()), "");
  write(folder / "b c.bin", "Buffer");
  EXPECT_NE(batch_model((folder / "b.gltf").string()).hash, b.hash);
  EXPECT_THROW(batch_model((folder / "none.obj").string()), Error);
}

BatchRun small_run() {
  BatchRun run;
  run.recipe = R"({"mass":1e-05,"objects":[],"trivet_recipe":1})";
  run.count = 10;
  run.version = "1";
  return run;
}

TEST(RunFile, RefusesAnotherRun) {
  const TemporaryFolder out;
  const BatchRun run = small_run();
  claim_run(out.path(), run);
  claim_run(out.path(), run);
  EXPECT_EQ(run_json(read_run(out.path())), run_json(run));
  const auto refused = [&](auto change, const std::string& says) {
    BatchRun other = run;
    change(other);
    try {
      check_run(out.path(), other);
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
      return true;
    }
    return false;
  };
  EXPECT_TRUE(refused([](BatchRun& r) { r.seed = 1; }, "seed is 0, here 1"));
  EXPECT_TRUE(refused([](BatchRun& r) { r.count = 11; }, "count is 10, here 11"));
  EXPECT_TRUE(refused([](BatchRun& r) { r.version = "2"; }, "version is \"1\", here \"2\""));
  EXPECT_TRUE(refused([](BatchRun& r) { r.recipe = R"({"trivet_recipe":1})"; }, "recipe"));
  EXPECT_TRUE(refused([](BatchRun& r) { r.format = UnitFormat::Dir; }, "format"));
  EXPECT_FALSE(refused([](BatchRun&) {}, ""));
}

TEST(RunFile, DetectsEveryFlippedBit) {
  const TemporaryFolder out;
  const BatchRun run = small_run();
  const std::string good = run_json(run);
  for (size_t i = 0; i < 8 * good.size(); ++i) {
    std::string bad = good;
    bad[i / 8] = static_cast<char>(bad[i / 8] ^ (1 << i % 8));
    write(out.file("run.json"), bad);
    ASSERT_THROW(read_run(out.path()), Error) << bad;
    ASSERT_THROW(check_run(out.path(), run), Error) << bad;
  }
  write(out.file("run.json"), good);
  EXPECT_NO_THROW(check_run(out.path(), run));
}

TEST(RunFile, NamesWhatScenesDependOn) {
  const BatchRun run = small_run();
  BatchRun other = run;
  other.count = 20, other.per_unit = 5, other.format = UnitFormat::Dir;
  other.recipe.insert(1, R"("views":{},)");
  EXPECT_EQ(other.id(), run.id());
  other.seed = 1;
  EXPECT_NE(other.id(), run.id());
  other = run, other.version = "2";
  EXPECT_NE(other.id(), run.id());
  other = run, other.recipe = R"({"trivet_recipe":1})";
  EXPECT_NE(other.id(), run.id());
  other = run, other.views = "{}", other.scenes_sha256 = "a";
  EXPECT_NE(other.id(), run.id());
}

TEST(RunFile, OfVersion1IsReadNotContinued) {
  const TemporaryFolder out;
  BatchRun old = small_run();
  old.file_version = 1;
  EXPECT_EQ(run_json(old).find("\"sha256\""), std::string::npos);
  write(out.file("run.json"), run_json(old));
  EXPECT_EQ(read_run(out.path()).id(), "");
  EXPECT_EQ(run_json(read_run(out.path())), run_json(old));
  try {
    check_run(out.path(), small_run());
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("trivet_batch is 1, here 2"), std::string::npos);
  }
}

}  // namespace
}  // namespace trivet::farm
