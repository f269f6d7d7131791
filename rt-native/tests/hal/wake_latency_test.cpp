#include "wake_latency.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "../link/temporary_folder.h"

namespace robotui::rt::hal {
namespace {

struct WakeLatencyTest : testing::Test {
  std::string asked() const {
    std::ifstream file(device, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  TemporaryFolder folder;
  std::filesystem::path device = folder.path() / "cpu_dma_latency";
};

TEST_F(WakeLatencyTest, tells_the_kernel_four_bytes) {
  std::ofstream{device};
  const WakeLatency latency(20, device);
  EXPECT_FALSE(latency.refusal());
  std::int32_t value = -1;
  ASSERT_EQ(asked().size(), sizeof(value));
  std::memcpy(&value, asked().data(), sizeof(value));
  EXPECT_EQ(value, 20);
}

TEST_F(WakeLatencyTest, asks_nothing_below_zero_or_of_a_kernel_that_cannot_be_asked) {
  EXPECT_FALSE(WakeLatency(0, device).refusal());
  std::ofstream{device};
  EXPECT_FALSE(WakeLatency(-1, device).refusal());
  EXPECT_TRUE(asked().empty());
}

TEST_F(WakeLatencyTest, says_what_was_refused_and_how_to_allow_it) {
  const WakeLatency latency(0, folder.path());  // a folder cannot be written, whoever one is
  ASSERT_TRUE(latency.refusal());
  EXPECT_NE(latency.refusal()->find("cpu_dma_latency_us: -1"), std::string::npos);
}

}  // namespace
}  // namespace robotui::rt::hal
