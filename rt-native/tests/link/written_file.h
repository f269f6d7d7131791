// Files of the repository that a test compares with what the code makes. With ROBOTUI_WRITE=1 in the environment they
// are written instead.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace robotui::rt {

inline void expectWritten(const std::string& path, const std::string& content) {
  if (std::getenv("ROBOTUI_WRITE") != nullptr) std::ofstream(path, std::ios::binary) << content;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream there;
  there << file.rdbuf();
  EXPECT_TRUE(there.str() == content)
      << path << " is not what the code makes: run this test with ROBOTUI_WRITE=1 and look at the difference.";
}

}  // namespace robotui::rt
