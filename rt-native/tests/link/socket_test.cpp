#include "robotui/rt/link/socket.h"

#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace robotui::rt::link {
namespace {

using namespace std::chrono_literals;

TEST(Socket, one_send_is_one_packet) {
  auto [a, b] = Socket::pair();
  ASSERT_TRUE(a.send("switch homing 1"));
  ASSERT_TRUE(a.send("end"));
  Packet packet;
  ASSERT_EQ(b.receive(packet, 1s), Received::kPacket);
  EXPECT_EQ(packet.verb(), "switch");
  EXPECT_EQ(packet.rest(), "homing 1");
  ASSERT_EQ(b.receive(packet, 1s), Received::kPacket);
  EXPECT_EQ(packet.verb(), "end");
  EXPECT_EQ(packet.rest(), "");
}

TEST(Socket, numbers_stand_behind_a_zero_byte) {
  const Packet packet{std::string("reference\0 \1\2", 13), {}};
  EXPECT_EQ(packet.verb(), "reference");
  EXPECT_EQ(packet.rest(), std::string_view(" \1\2", 3));
}

TEST(Socket, descriptors_come_with_their_packet) {
  auto [a, b] = Socket::pair();
  int pipe[2];
  ASSERT_EQ(::pipe2(pipe, O_CLOEXEC), 0);
  const Descriptor reading(pipe[0]);
  Descriptor writing(pipe[1]);
  const int given[] = {writing.get()};
  ASSERT_TRUE(a.send("begin", given));
  writing.reset();
  Packet packet;
  ASSERT_EQ(b.receive(packet, 1s), Received::kPacket);
  ASSERT_EQ(packet.descriptors.size(), 1U);
  EXPECT_EQ(::write(packet.descriptors[0].get(), "x", 1), 1);
  EXPECT_NE(::fcntl(packet.descriptors[0].get(), F_GETFD) & FD_CLOEXEC, 0);
  char byte;
  EXPECT_EQ(::read(reading.get(), &byte, 1), 1);
}

TEST(Socket, a_peer_that_is_gone_is_told_and_no_signal) {
  auto [a, b] = Socket::pair();
  b.close();
  EXPECT_FALSE(a.send("hello"));
  Packet packet;
  EXPECT_EQ(a.receive(packet, 1s), Received::kClosed);
}

TEST(Socket, silence_is_a_time_out) {
  auto [a, b] = Socket::pair();
  Packet packet;
  EXPECT_EQ(a.receive(packet, 10ms), Received::kTimeout);
}

TEST(Socket, a_peer_that_does_not_read_costs_a_second_at_most) {
  auto [a, b] = Socket::pair();
  const std::string large(kMaxPacket, 'x');
  const auto begin = std::chrono::steady_clock::now();
  while (a.send(large)) {
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

TEST(Socket, more_than_a_packet_may_have_is_not_sent) {
  auto [a, b] = Socket::pair();
  EXPECT_FALSE(a.send(std::string(kMaxPacket + 1, 'x')));
}

TEST(Socket, tells_who_is_at_the_other_end) {
  auto [a, b] = Socket::pair();
  EXPECT_EQ(a.peer().pid, ::getpid());
  EXPECT_EQ(a.peer().uid, ::getuid());
}

TEST(Socket, listens_accepts_and_takes_over_from_who_died) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "robot.sock";
  { const Socket dead = Socket::listen(path); }
  const Socket server = Socket::listen(path);
  EXPECT_THROW(Socket::listen(path), SocketError);
  EXPECT_TRUE(server.accept(100ms).isOpen());  // the probe of the second listen()
  const Socket client = Socket::connect(path, 1s);
  const Socket accepted = server.accept(1s);
  ASSERT_TRUE(accepted.isOpen());
  ASSERT_TRUE(client.send("attach"));
  Packet packet;
  EXPECT_EQ(accepted.receive(packet, 1s), Received::kPacket);
}

TEST(SocketPlace, is_a_folder_for_its_user_alone) {
  const TemporaryFolder folder;
  ASSERT_EQ(::setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1), 0);
  const auto path = socketPath("arm");
  EXPECT_EQ(path, folder.path() / "robotui-rt" / "arm.sock");
  struct stat status {};
  ASSERT_EQ(::stat(path.parent_path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700U);
  ASSERT_EQ(::chmod(path.parent_path().c_str(), 0777), 0);
  EXPECT_THROW(socketPath("arm"), SocketError);
}

TEST(SocketPlace, refuses_names_that_lead_elsewhere) {
  for (const char* name : {"", ".", "..", "a/b", "../arm"}) EXPECT_THROW(socketPath(name), SocketError) << name;
}

}  // namespace
}  // namespace robotui::rt::link
