#include "robotui/rt/supervisor/control_server.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace robotui::rt::supervisor {
namespace {

constexpr std::chrono::milliseconds kSoon{1000};

class ControlServerTest : public ::testing::Test {
 protected:
  static std::filesystem::path place() {
    const auto folder = std::filesystem::temp_directory_path() / ("robotui-server-test-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    return folder / "robot.sock";
  }
  ~ControlServerTest() override { std::filesystem::remove_all(place().parent_path()); }

  void serve() {
    server.serve(
        [this](std::uint64_t client, const link::Packet& packet) { server.reply(client, "ok " + packet.text); },
        [this](std::uint64_t) { ++gone_; });
  }

  ControlServer server{place()};
  int gone_ = 0;
};

TEST_F(ControlServerTest, AnswersEachOfManyClients) {
  auto a = link::Socket::connect(place(), kSoon);
  auto b = link::Socket::connect(place(), kSoon);
  a.send("one");
  b.send("two");
  serve();
  link::Packet packet;
  ASSERT_EQ(a.receive(packet, kSoon), link::Received::kPacket);
  EXPECT_EQ(packet.text, "ok one");
  ASSERT_EQ(b.receive(packet, kSoon), link::Received::kPacket);
  EXPECT_EQ(packet.text, "ok two");
}

TEST_F(ControlServerTest, TellsWhenAClientIsGone) {
  link::Socket::connect(place(), kSoon).close();
  serve();
  serve();
  EXPECT_EQ(gone_, 1);
}

TEST_F(ControlServerTest, DropsAClientThatAsksAndNeverReads) {
  auto greedy = link::Socket::connect(place(), kSoon);
  auto other = link::Socket::connect(place(), kSoon);
  const std::string large(30000, 'x');
  const auto begun = std::chrono::steady_clock::now();
  for (int i = 0; i < 200 && gone_ == 0; ++i) {
    if (!greedy.send(large)) {
      break;
    }
    serve();
  }
  EXPECT_EQ(gone_, 1);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
  other.send("still there?");
  serve();
  link::Packet packet;
  EXPECT_EQ(other.receive(packet, kSoon), link::Received::kPacket);
}

TEST_F(ControlServerTest, HasRoomForSoManyAndSaysSo) {
  std::vector<link::Socket> all;
  for (std::size_t i = 0; i <= ControlServer::kMostClients; ++i) {
    all.push_back(link::Socket::connect(place(), kSoon));
    serve();
  }
  link::Packet packet;
  ASSERT_EQ(all.back().receive(packet, kSoon), link::Received::kPacket);
  EXPECT_EQ(packet.text, "error 32 clients are connected: there is no room for another one.");
}

TEST_F(ControlServerTest, IsRefusedWhereAnotherOneListens) { EXPECT_THROW(ControlServer{place()}, link::SocketError); }

TEST_F(ControlServerTest, ReplacesTheSocketOfOneThatDied) {
  const auto stale = place().parent_path() / "stale.sock";
  { auto dead = link::Socket::listen(stale); }
  ASSERT_TRUE(std::filesystem::exists(stale));
  { const ControlServer before(stale); }
  EXPECT_FALSE(std::filesystem::exists(stale));
}

}  // namespace
}  // namespace robotui::rt::supervisor
