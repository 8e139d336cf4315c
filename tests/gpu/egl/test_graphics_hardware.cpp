// Graphics hardware as the kernel shows it, in folders that imitate it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "gpu/egl/context.h"
#include "gpu/egl/graphics_hardware.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

struct Root {
  test::TemporaryFolder folder;

  std::string path() const { return folder.file(""); }
  void add(const std::string& name, const std::string& text = "") const {
    fs::create_directories(fs::path(folder.file(name)).parent_path());
    std::ofstream(folder.file(name)) << text << "\n";
  }
  void add_node(const std::string& node, const std::string& driver) const {
    add("dev/dri/" + node);
    const std::string device = "sys/class/drm/" + node + "/device/";
    add(device + "vendor", "0x8086");
    add(device + "device", "0x46a6");
    fs::create_symlink("../../../../bus/pci/drivers/" + driver, folder.file(device + "driver"));
  }
};

TEST(GraphicsHardware, IsListedWithItsDriver) {
  const Root root;
  EXPECT_EQ(graphics_hardware(root.path()), "");
  root.add_node("renderD128", "i915");
  root.add_node("renderD129", "vgem");  // has no renderer
  root.add("dev/dri/card0");            // shows, does not draw
  root.add("dev/dri/renderDx");
  EXPECT_EQ(graphics_hardware(root.path()), "renderD128 0x8086:0x46a6 i915");
  root.add("dev/nvidia0");
  root.add("dev/nvidiactl");
  root.add("proc/driver/nvidia/version", "NVRM version: 550.54.15");
  root.add("sys/module/i915/version", "1.6");
  EXPECT_EQ(graphics_hardware(root.path()),
            "renderD128 0x8086:0x46a6 i915 1.6; nvidia0 NVRM version: 550.54.15");
}

TEST(GraphicsHardware, IsThereWithoutSysfs) {
  const Root root;
  root.add("dev/dri/renderD128");
  root.add("dev/dxg");
  EXPECT_EQ(graphics_hardware(root.path()), "renderD128; dxg");
}

// A renderer on hardware is not possible without a device.
TEST(GraphicsHardware, IsThereWhereARendererIs) {
  try {
    const EglContext context(EglOptions{false});
    EXPECT_NE(graphics_hardware(), "") << context.description();
  } catch (const Error&) {
    GTEST_SKIP() << "no hardware renderer here";
  }
}

}  // namespace
}  // namespace trivet
