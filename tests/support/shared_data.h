// Real data outside the repository: tests that need it skip with a message.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace trivet::test {

inline std::string shared_data(const std::string& path) {
  return std::string(TRIVET_SHARED_DIR "/data/") + path;
}

}  // namespace trivet::test

#define TRIVET_NEEDS_DATA(path)                                    \
  if (!std::filesystem::exists(::trivet::test::shared_data(path))) \
  GTEST_SKIP() << "no data at " << ::trivet::test::shared_data(path)
