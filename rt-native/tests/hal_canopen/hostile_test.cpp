// Frames that nobody should send: neither the HAL nor the simulated drive is led astray by them.
#include <random>

#include <sys/socket.h>

#include "canopen/bus_watch.h"
#include "canopen/sdo.h"
#include "world.h"

namespace robotui::rt::hal::canopen {
namespace {

// Frames of a CANopen bus, changed in bits, lengths and identifiers.
class Mutator {
 public:
  Frame next() {
    Frame frame = frameOf(kIds[random_() % std::size(kIds)] + random_() % 4, {});
    frame.can_dlc = static_cast<std::uint8_t>(random_() % 10 < 8 ? 8 : random_() % 9);
    for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random_());
    if (random_() % 4 == 0) frame.can_id |= CAN_RTR_FLAG;
    if (random_() % 8 == 0) frame.can_id = random_() & (CAN_EFF_FLAG | CAN_EFF_MASK);
    if (random_() % 16 == 0) frame.can_dlc = static_cast<std::uint8_t>(random_());
    return frame;
  }

 private:
  static constexpr canid_t kIds[] = {kSyncId, 0x180, 0x280, 0x380, kSdoAnswerId, kHeartbeatId};
  std::mt19937 random_{7};
};

TEST_F(CanOpenTest, foreign_and_broken_frames_do_not_stop_what_the_drives_say) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  Mutator mutate;
  for (int i = 0; i < 100; ++i) {
    world.with([&](simulated::SimulatedBus& bus) {
      for (int k = 0; k < 20; ++k) bus.send(mutate.next());
    });
    cycle();
    for (const link::JointState& joint : joints) {
      ASSERT_TRUE(std::isfinite(joint.link_position));
      ASSERT_TRUE(std::isfinite(joint.link_velocity));
    }
  }
  hal.recover();
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
}

TEST(SimulatedDrive, answers_to_whatever_is_asked) {
  int answers = 0;
  simulated::Drive drive(1, 0, [&](const Frame& frame) {
    EXPECT_LE(frame.can_dlc, 8);
    ++answers;
  });
  std::mt19937 random(3);
  Mutator mutate;
  for (int i = 0; i < 100'000; ++i) {
    Frame frame = mutate.next();
    if (i % 2 == 0) frame.can_id = kSdoRequestId + 1;
    if (i % 2 == 0) frame.can_dlc = 8;
    if (i % 5 == 0) frame = nmtFrame(static_cast<NmtCommand>(random() % 3 == 0 ? 0x81 : 0x01), 1);
    drive.heard(frame, i);
    drive.step(i);
  }
  EXPECT_GT(answers, 1000);
}

TEST(SdoAnswers, that_are_nonsense_are_errors_and_no_end) {
  int pair[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0, pair), 0);
  const Bus ours{link::Descriptor(pair[0])};
  const Bus theirs{link::Descriptor(pair[1])};
  std::atomic<bool> ended{false};
  std::jthread nonsense([&] {
    std::mt19937 random(11);
    while (!ended) {
      theirs.wait(1);
      Frame frame{};
      while (theirs.receive(frame) == Heard::kFrame) {
      }
      frame = frameOf(kSdoAnswerId + 1, {0, 0x40, 0x60, 0, 1, 2, 3, 4});
      frame.data[0] = static_cast<std::uint8_t>(random());
      theirs.send(frame);
    }
  });
  const SdoClient sdo(ours, 1, 50);
  for (int i = 0; i < 200; ++i) {
    try {
      sdo.read(kControlWord);
      sdo.write(kControlWord, 6, 2);
    } catch (const SdoError& error) {
      EXPECT_NE(std::string(error.what()).find("0x6040:0"), std::string::npos);
    }
  }
  ended = true;
}

TEST(BusWatching, no_room_in_turn_is_told_and_room_again_too) {
  int pair[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0, pair), 0);
  const Bus ours{link::Descriptor(pair[0])};
  const Bus theirs{link::Descriptor(pair[1])};
  BusWatch watch(3);
  while (watch.sent(ours.send(frameOf(kSyncId, {})))) {
  }
  EXPECT_EQ(watch.look().cause, Cause::kNone);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(watch.works());
    watch.sent(ours.send(frameOf(kSyncId, {})));
    const Alarm alarm = watch.look();
    EXPECT_EQ(alarm.cause, i == 1 ? Cause::kBusFull : Cause::kNone);
  }
  EXPECT_FALSE(watch.works());
  Frame frame{};
  while (theirs.receive(frame) == Heard::kFrame) {
  }
  EXPECT_TRUE(watch.sent(ours.send(frameOf(kSyncId, {}))));
  EXPECT_EQ(watch.look().cause, Cause::kBusBack);
}

}  // namespace
}  // namespace robotui::rt::hal::canopen
