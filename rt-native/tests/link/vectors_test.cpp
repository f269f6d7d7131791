#include "vectors.h"

#include <cstring>

#include <gtest/gtest.h>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/command.h"
#include "schema.h"
#include "written_file.h"

namespace robotui::rt::link {
namespace {

template <class T>
void expectVector(const std::string& name, std::string_view type, const T& value) {
  const std::string base = std::string(VECTORS_FOLDER) + "/" + name;
  expectWritten(base + ".bin", std::string(reinterpret_cast<const char*>(&value), sizeof(T)));
  expectWritten(base + ".txt", describeBytes(type, &value));
}

std::string bytesOf(const std::string& name) {
  std::ifstream file(std::string(VECTORS_FOLDER) + "/" + name, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

TEST(Vectors, are_what_this_side_writes) {
  expectVector("state-frame", "StateFrame", *stateFrameVector());
  expectVector("host", "HostSegment", *hostSegmentVector());
  expectVector("board", "BoardSegment", *boardVector());
}

TEST(Vectors, a_slot_of_the_file_is_read_as_a_living_one) {
  auto host = std::make_unique<HostSegment>();
  const std::string bytes = bytesOf("host.bin");
  ASSERT_EQ(bytes.size(), sizeof(HostSegment));
  std::memcpy(static_cast<void*>(host.get()), bytes.data(), bytes.size());
  CommandData command{};
  ASSERT_EQ(SlotReader(*host, 1, kMaxJoints).read(command), Read::kNew);
  EXPECT_EQ(command.cycle, 1234U);
  EXPECT_EQ(command.joints[0].effort, -2.5);
  EXPECT_EQ(command.joints[0].mode, kPosition | kImpedance);
  EXPECT_EQ(command.joints[127].plugin, 63);
}

TEST(Vectors, a_board_of_the_file_is_read_as_a_living_one) {
  auto board = std::make_unique<BoardSegment>();
  const std::string bytes = bytesOf("board.bin");
  ASSERT_EQ(bytes.size(), sizeof(BoardSegment));
  std::memcpy(static_cast<void*>(board.get()), bytes.data(), bytes.size());
  auto data = std::make_unique<BoardData>();
  BoardReader reader(*board);
  ASSERT_EQ(reader.read(*data), Read::kNew);
  EXPECT_EQ(view(data->joint[1].name), "lift");
  EXPECT_EQ(data->joint[1].upper, 0.75);
  EXPECT_EQ(reader.owner(0), 0);
  EXPECT_EQ(reader.grant(0), 2U);
  EXPECT_EQ(reader.owner(1), kNobody);
}

}  // namespace
}  // namespace robotui::rt::link
