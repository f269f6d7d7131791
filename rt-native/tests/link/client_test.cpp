#include "robotui/rt/link/client.h"

#include <cstring>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace robotui::rt::link {
namespace {

using namespace std::chrono_literals;

// A supervisor of one client that answers what the test wants.
class FakeSupervisor {
 public:
  explicit FakeSupervisor(const std::string& robot) : listening_(Socket::listen(socketPath(robot))) {}

  Packet next() {
    if (!client_.isOpen()) client_ = listening_.accept(5s);
    Packet packet;
    EXPECT_EQ(client_.receive(packet, 5s), Received::kPacket);
    return packet;
  }
  void say(std::string_view text, std::span<const int> descriptors = {}) {
    EXPECT_TRUE(client_.send(text, descriptors));
  }

 private:
  Socket listening_;
  Socket client_;
};

struct ClientTest : testing::Test {
  TemporaryFolder folder;
  void SetUp() override { ASSERT_EQ(::setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1), 0); }
};

TEST_F(ClientTest, says_that_a_robot_does_not_run) {
  try {
    Client client("nobody", 1s);
    FAIL();
  } catch (const SocketError& error) {
    EXPECT_NE(std::string(error.what()).find("No robot 'nobody' runs here"), std::string::npos);
  }
}

TEST_F(ClientTest, attaches_to_the_memory_that_it_is_given) {
  FakeSupervisor supervisor("arm");
  const auto state = Segment<StateSegment>::create(1);
  const auto board = Segment<BoardSegment>::create(1);
  const auto host = Segment<HostSegment>::create(1);
  state->newest.store(42);
  std::jthread serving([&] {
    EXPECT_EQ(supervisor.next().text, "attach");
    const Descriptor given[] = {state.shareReadOnly(), board.shareReadOnly(), host.shareReadOnly()};
    const int numbers[] = {given[0].get(), given[1].get(), given[2].get()};
    supervisor.say("attached 1", numbers);
  });
  Client client("arm", 1s);
  const Attachment attachment = client.attach(5s);
  EXPECT_EQ(attachment.state->newest.load(), 42U);
  EXPECT_EQ(attachment.hosts.size(), 1U);
}

TEST_F(ClientTest, asks_and_keeps_a_notice_that_comes_in_front_of_the_reply) {
  FakeSupervisor supervisor("arm");
  std::jthread serving([&] {
    EXPECT_EQ(supervisor.next().text, "switch homing 1");
    supervisor.say("changed");
    supervisor.say("ok");
    EXPECT_EQ(supervisor.next().verb(), "status");
    supervisor.say("error There is no plugin 'x'.");
  });
  Client client("arm", 1s);
  EXPECT_TRUE(client.request("switch homing 1", 5s).ok);
  EXPECT_EQ(client.notice(0ms), Notice::kChanged);
  EXPECT_EQ(client.notice(0ms), Notice::kNone);
  const Reply reply = client.request("status x", 5s);
  EXPECT_FALSE(reply.ok);
  EXPECT_EQ(reply.text, "There is no plugin 'x'.");
}

TEST_F(ClientTest, sends_references_as_they_lie_in_memory) {
  FakeSupervisor supervisor("arm");
  Client client("arm", 1s);
  std::array<JointCommand, 7> joints{};
  joints[6].position = 0.25;
  ASSERT_TRUE(client.reference(joints));
  const Packet packet = supervisor.next();
  EXPECT_EQ(packet.verb(), "reference");
  ASSERT_EQ(packet.rest().size(), sizeof(joints));
  EXPECT_EQ(std::memcmp(packet.rest().data(), joints.data(), sizeof(joints)), 0);
}

TEST_F(ClientTest, a_supervisor_that_is_silent_or_gone_is_an_error_with_a_sentence) {
  auto supervisor = std::make_unique<FakeSupervisor>("arm");
  Client client("arm", 1s);
  std::jthread serving([&] { supervisor->next(); });
  EXPECT_NE(client.request("status x", 50ms).text.find("did not answer"), std::string::npos);
  serving.join();
  supervisor.reset();
  EXPECT_EQ(client.notice(1s), Notice::kGone);
  EXPECT_FALSE(client.request("status x", 1s).ok);
  EXPECT_FALSE(client.reconnect(1s));
}

TEST_F(ClientTest, finds_a_supervisor_that_came_back) {
  auto supervisor = std::make_unique<FakeSupervisor>("arm");
  Client client("arm", 1s);
  std::jthread first([&] {
    supervisor->next();
    supervisor->say("ok");
  });
  ASSERT_TRUE(client.request("status x", 5s).ok);
  first.join();
  supervisor.reset();
  ASSERT_EQ(client.notice(5s), Notice::kGone);
  supervisor = std::make_unique<FakeSupervisor>("arm");
  ASSERT_TRUE(client.reconnect(1s));
  std::jthread second([&] {
    supervisor->next();
    supervisor->say("ok back");
  });
  EXPECT_EQ(client.request("status x", 5s).text, "back");
}

}  // namespace
}  // namespace robotui::rt::link
