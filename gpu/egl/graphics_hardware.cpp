#include "gpu/egl/graphics_hardware.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace trivet {
namespace {

namespace fs = std::filesystem;

/// Empty if there is no such file.
std::string first_line(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

std::string name_of_link(const fs::path& path) {
  std::error_code error;
  return fs::read_symlink(path, error).filename().string();
}

bool has_number_after(const std::string& name, const std::string& prefix) {
  return name.size() > prefix.size() && name.starts_with(prefix) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(),
                     [](unsigned char c) { return std::isdigit(c); });
}

/// Sorted names in a folder, such as renderD128.
std::vector<std::string> numbered(const fs::path& folder, const std::string& prefix) {
  std::vector<std::string> out;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (const std::string name = entry.path().filename().string(); has_number_after(name, prefix))
      out.push_back(name);
  std::sort(out.begin(), out.end());
  return out;
}

std::string joined(std::string text, const std::string& more) {
  if (!text.empty() && !more.empty()) text += " ";
  return text + more;
}

/// Kernel drivers of displays in memory.
bool has_no_renderer(const std::string& driver) { return driver == "vgem" || driver == "vkms"; }

}  // namespace

std::vector<std::string> list_graphics_hardware(const std::string& root) {
  const fs::path top(root);
  std::vector<std::string> out;
  for (const std::string& node : numbered(top / "dev/dri", "renderD")) {
    const fs::path device = top / "sys/class/drm" / node / "device";
    const std::string driver = name_of_link(device / "driver");
    if (has_no_renderer(driver)) continue;
    const std::string vendor = first_line(device / "vendor");
    const std::string ids = vendor.empty() ? "" : vendor + ":" + first_line(device / "device");
    const std::string version = first_line(top / "sys/module" / driver / "version");
    out.push_back(joined(joined(joined(node, ids), driver), driver.empty() ? "" : version));
  }
  for (const std::string& node : numbered(top / "dev", "nvidia"))
    out.push_back(joined(node, first_line(top / "proc/driver/nvidia/version")));
  std::error_code error;
  if (fs::exists(top / "dev/dxg", error)) out.emplace_back("dxg");  // of Windows, through WSL
  return out;
}

std::string graphics_hardware(const std::string& root) {
  std::string out;
  for (const std::string& device : list_graphics_hardware(root))
    out += (out.empty() ? "" : "; ") + device;
  return out;
}

}  // namespace trivet
