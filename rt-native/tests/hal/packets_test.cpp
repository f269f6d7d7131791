#include "udp/packets.h"

#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "udp/sequence_gate.h"

namespace robotui::rt::hal::udp {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Packets, a_command_is_read_as_it_was_written) {
  Buffer buffer{};
  const std::array<Reference, 2> references{{{1, 2, 3, 4, 5, link::kPosition}, {-1, 0, 0, 0, 0, link::kEffort}}};
  Header header{};
  header.cycle = 77;
  const auto packet = writeCommand(buffer, header, references);
  Header read_header{};
  ASSERT_TRUE(read(packet, read_header));
  EXPECT_EQ(read_header.cycle, 77U);
  std::array<Reference, 2> out{};
  ASSERT_TRUE(readReferences(packet, out));
  EXPECT_EQ(out[0].damping, 5);
  EXPECT_EQ(out[1].mode, link::kEffort);
}

TEST(Packets, of_another_version_length_or_number_of_joints_are_refused) {
  Buffer buffer{};
  const std::array<Reference, 2> references{};
  Header header{};
  auto packet = writeCommand(buffer, header, references);
  std::array<Reference, 3> more{};
  EXPECT_FALSE(readReferences(packet, more));
  EXPECT_FALSE(read(packet.first(packet.size() - 1), header));
  EXPECT_FALSE(read(packet.first(3), header));
  buffer[4] = std::byte{9};
  EXPECT_FALSE(read(packet, header));
}

TEST(Packets, with_what_is_no_number_change_nothing) {
  Buffer buffer{};
  std::array<link::JointState, 2> sent{};
  sent[1].effort = kNaN;
  Measurements from{sent, {}, {}};
  const auto packet = writeState(buffer, {}, from);
  std::array<link::JointState, 2> received{};
  received[0].link_position = 3;
  Measurements into{received, {}, {}};
  EXPECT_FALSE(readState(packet, into));
  EXPECT_EQ(received[0].link_position, 3);
}

TEST(Packets, of_random_bytes_are_no_packets_and_never_read_beyond) {
  std::mt19937 random(3);
  std::array<Reference, 4> references{};
  for (int i = 0; i < 20000; ++i) {
    std::vector<std::byte> bytes(random() % 300);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    if (bytes.size() >= 8 && i % 2 == 0) {
      const std::uint32_t magic = kMagic;
      std::memcpy(bytes.data(), &magic, 4);
      bytes[4] = std::byte{1};
      bytes[5] = std::byte{0};
    }
    Header header{};
    if (read(bytes, header)) readReferences(bytes, references);
  }
}

TEST(SequenceGateTest, admits_each_once_in_order_and_one_sender_at_a_time) {
  SequenceGate gate(1000);
  EXPECT_TRUE(gate.admit(1, 10, 5, 100));
  EXPECT_FALSE(gate.admit(1, 10, 5, 200));
  EXPECT_FALSE(gate.admit(1, 10, 4, 200));
  EXPECT_TRUE(gate.admit(1, 10, 8, 200));
  EXPECT_EQ(gate.lost(), 2U);
  EXPECT_FALSE(gate.admit(2, 11, 1, 300));
  EXPECT_FALSE(gate.admit(1, 12, 9, 300));
  EXPECT_TRUE(gate.admit(2, 11, 1, 5000));
  EXPECT_EQ(gate.refused(), 4U);
}

}  // namespace
}  // namespace robotui::rt::hal::udp
