// Reading extras of foreign, truncated and hostile files.
#include <cstring>

#include "core/io/export.h"
#include "core/io/io_testing.h"

namespace trivet {
namespace {

using testing::error_of;
using testing::expect_parts;

class SceneExtrasTest : public testing::IoTest {
 protected:
  void expect_refused(const std::string& bytes, std::vector<std::string> parts) const {
    const std::string file = write("s.glb", bytes);
    parts.push_back(file + ":");
    expect_parts(error_of([&] { read_scene_extras(file); }), parts);
  }
};

std::string glb_of(const std::string& json) {
  const auto number = [](size_t value) {
    const auto number32 = static_cast<std::uint32_t>(value);
    std::string out(4, '\0');
    std::memcpy(out.data(), &number32, 4);
    return out;
  };
  return "glTF" + number(2) + number(20 + json.size()) + number(json.size()) + "JSON" + json;
}

TEST_F(SceneExtrasTest, ReadsForeignScenes) {
  const std::string file = write("t.glb", testing::tetrahedron_glb());
  EXPECT_EQ(read_scene_extras(file).scene_json, "");
  EXPECT_TRUE(read_scene_extras(file).node_json.empty());
  const SceneExtras extras = read_scene_extras(
      write("e.glb",
            glb_of(R"({"asset":{"version":"2.0"},"scene":1,"scenes":[{},{"extras":7}],)"
                   R"("nodes":[{"extras":[]},{"name":"x"},{"name":"y","extras":{"k":null}}]})")));
  EXPECT_EQ(extras.scene_json, "7");
  ASSERT_EQ(extras.node_json.size(), 2u);
  EXPECT_EQ(extras.node_json[0], std::make_pair(std::string(), std::string("[]")));
  EXPECT_EQ(extras.node_json[1], std::make_pair(std::string("y"), std::string(R"({"k":null})")));
}

TEST_F(SceneExtrasTest, ReportsMissingFile) {
  expect_parts(error_of([&] { read_scene_extras(path("none.glb")); }),
               {path("none.glb"), "No such file"});
  expect_parts(error_of([&] { read_scene_extras(folder().string()); }), {"is a folder"});
}

TEST_F(SceneExtrasTest, ReportsBrokenFiles) {
  const std::string good = testing::tetrahedron_glb();
  expect_refused("", {"not binary glTF", "0 bytes"});
  expect_refused(good.substr(0, 19), {"not binary glTF", "19 bytes"});
  expect_refused(testing::tetrahedron_obj() + std::string(40, '\n'),
                 {"does not begin with 'glTF'"});
  expect_refused(good.substr(0, good.size() - 1), {"truncated"});
  std::string bytes = good;
  bytes[4] = 1;
  expect_refused(bytes, {"version 1", "accepted: 2"});
  bytes = good;
  bytes[16] = 'X';
  expect_refused(bytes, {"not JSON"});
  bytes = good;
  bytes[15] = '\x7f';
  expect_refused(bytes, {"longer than the file"});
  bytes = good;
  bytes[20] = '[';
  expect_refused(bytes, {"malformed"});
  bytes = good;
  std::memset(bytes.data() + 8, 0, 4);
  expect_refused(bytes, {});
  expect_refused(glb_of("[]  "), {"no asset"});
  expect_refused(glb_of(std::string(1'000'000, '[')), {"nested"});
}

TEST_F(SceneExtrasTest, RejectsEveryTruncation) {
  const std::string good = testing::tetrahedron_glb();
  for (size_t length = 0; length < good.size(); ++length)
    expect_refused(good.substr(0, length), {});
}

}  // namespace
}  // namespace trivet
