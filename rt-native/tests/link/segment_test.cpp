#include "robotui/rt/link/segment.h"

#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/futex.h"

namespace robotui::rt::link {
namespace {

std::string errorOf(Descriptor file) {
  try {
    Segment<const StateSegment>::open(std::move(file));
  } catch (const SegmentError& error) {
    return error.what();
  }
  return {};
}

void expectRefused(Descriptor file, const std::string& words) {
  const std::string error = errorOf(std::move(file));
  EXPECT_NE(error.find(words), std::string::npos) << error;
}

TEST(Segment, what_the_writer_writes_is_what_a_reader_reads) {
  const auto state = Segment<StateSegment>::create(3);
  const auto reader = Segment<const StateSegment>::open(state.shareReadOnly());
  EXPECT_EQ(reader->header.generation, 3U);
  EXPECT_EQ(reader->header.pid, ::getpid());
  state->newest.store(7);
  EXPECT_EQ(reader->newest.load(), 7U);
}

TEST(Segment, a_host_gets_one_that_it_can_write) {
  const auto host = Segment<HostSegment>::create(1);
  const auto given = Segment<HostSegment>::open(host.shareWritable());
  given->threads = 5;
  EXPECT_EQ(host->threads, 5U);
}

TEST(SegmentDeathTest, writing_what_is_mapped_read_only_ends_the_process) {
  const auto state = Segment<StateSegment>::create(1);
  const auto reader = Segment<const StateSegment>::open(state.shareReadOnly());
  auto* const target = const_cast<StateSegment*>(reader.get());
  const auto write = [&] {
    std::signal(SIGSEGV, SIG_DFL);  // sanitizers make a report and an exit of it
    *reinterpret_cast<volatile std::uint32_t*>(&target->joints) = 1;
  };
  EXPECT_EXIT(write(), testing::KilledBySignal(SIGSEGV), "");
}

TEST(Segment, sealed_against_writers_it_cannot_be_mapped_writable_by_anybody) {
  const auto state = Segment<StateSegment>::create(1);
  state.sealAgainstWriters();
  state->joints = 4;  // the writer's own map stays
  const Descriptor given = state.shareReadOnly();
  EXPECT_EQ(::mmap(nullptr, sizeof(StateSegment), PROT_READ | PROT_WRITE, MAP_SHARED, given.get(), 0), MAP_FAILED);
  const std::string path = "/proc/self/fd/" + std::to_string(given.get());
  const Descriptor opened(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  ASSERT_TRUE(opened.isOpen());
  EXPECT_EQ(::mmap(nullptr, sizeof(StateSegment), PROT_READ | PROT_WRITE, MAP_SHARED, opened.get(), 0), MAP_FAILED);
  EXPECT_EQ(errno, EPERM);
  void* const readable = ::mmap(nullptr, sizeof(StateSegment), PROT_READ, MAP_SHARED, opened.get(), 0);
  ASSERT_NE(readable, MAP_FAILED);
  EXPECT_NE(::mprotect(readable, sizeof(StateSegment), PROT_READ | PROT_WRITE), 0);
  ::munmap(readable, sizeof(StateSegment));
  const char byte = 1;
  EXPECT_LT(::pwrite(opened.get(), &byte, 1, 0), 0);
  EXPECT_NE(::ftruncate(opened.get(), 0), 0);
}

TEST(Segment, refuses_another_kind_version_mark_and_size) {
  const auto board = Segment<BoardSegment>::create(1);
  expectRefused(board.shareReadOnly(), "were expected");  // the size tells first
  const auto wrong = [](auto change) {
    const auto state = Segment<StateSegment>::create(1);
    change(state->header);
    return state.shareReadOnly();
  };
  expectRefused(wrong([](Header& header) { header.magic = 1; }), "mark of the link");
  expectRefused(wrong([](Header& header) { header.version = 99; }), "layout version 99");
  expectRefused(wrong([](Header& header) { header.segment = 2; }), "a segment of kind 2 came");
  expectRefused(wrong([](Header& header) { header.size = 12; }), "says that it has 12 bytes");
}

TEST(Segment, refuses_a_file_whose_size_may_change) {
  Descriptor file(::memfd_create("loose", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ASSERT_EQ(::ftruncate(file.get(), sizeof(StateSegment)), 0);
  expectRefused(std::move(file), "not sealed");
  expectRefused(Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC)), "not sealed");
  expectRefused(Descriptor(), "is no file");
}

TEST(Segment, a_bell_wakes_who_has_mapped_it_read_only_in_another_process) {
  const auto state = Segment<StateSegment>::create(1);
  const auto reader = Segment<const StateSegment>::open(state.shareReadOnly());
  const pid_t child = ::fork();
  if (child == 0) {
    const timespec pause{0, 30'000'000};
    ::nanosleep(&pause, nullptr);
    ringBell(state->bell);
    ::_exit(0);
  }
  const std::int64_t begin = now();
  bool woken = true;
  while (reader->bell.load() == 0 && woken) woken = waitForBell(reader->bell, 0, begin + 5 * kSecond);
  EXPECT_TRUE(woken);
  EXPECT_LT(now() - begin, 4 * kSecond);
  ::waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace robotui::rt::link
