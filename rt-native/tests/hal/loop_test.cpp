#include "loop.h"

#include <cstdio>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

#include "dummy/dummy.h"
#include "grid.h"
#include "real_time.h"
#include "rig.h"
#include "robotui/rt/link/histogram.h"

namespace robotui::rt::hal {
namespace {

TEST(GridTest, a_late_cycle_shifts_no_point_and_skipped_ones_are_counted) {
  constexpr std::int64_t kPeriod = 5 * link::kMillisecond;
  Grid grid(kPeriod);
  const std::int64_t first = grid.next();
  const std::int64_t second = grid.next();
  EXPECT_EQ((second - first) % kPeriod, 0);
  const std::uint64_t before = grid.skipped();
  const std::int64_t end = second + 12 * link::kMillisecond;
  while (link::now() < end) {
  }
  const std::int64_t third = grid.next();
  EXPECT_EQ((third - first) % kPeriod, 0);
  EXPECT_GE(third - second, 3 * kPeriod);
  EXPECT_EQ(static_cast<std::int64_t>(grid.skipped() - before), (third - second) / kPeriod - 1);
}

TEST(RealTime, a_core_that_is_not_there_is_refused_with_a_sentence) {
  const Refusal refusal = pinTo(5000);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->find("core_id"), std::string::npos);
}

// Where that is allowed; else it says what lacks, and goes on without where that is.
TEST(RealTime, a_deadline_is_had_or_refused_with_a_sentence) {
  Waiting waiting;
  Rig rig(&waiting);
  const LoopSettings settings{.period_ns = 4 * link::kMillisecond,
                              .priority = link::kByDeadline,
                              .runtime = 0.1,
                              .core = std::nullopt,
                              .allow_non_rt = true};
  Loop loop(*rig.cycle, settings);
  std::vector<std::string> refusals = loop.start();
  link::StateReader reader(*rig.state);
  ASSERT_TRUE(reader.wait(link::now() + 20 * link::kSecond));
  const std::string refused = "The loop cannot keep its time: SCHED_DEADLINE with 400 us in each 4000 us is refused: ";
  const bool had = std::none_of(refusals.begin(), refusals.end(),
                                [&](const std::string& sentence) { return sentence.find(refused) == 0; });
  EXPECT_EQ(link::relaxedLoad(rig.state->loop.priority), had ? link::kByDeadline : 0);
}

TEST(RealTime, what_helps_against_a_refused_deadline_is_said) {
  const link::Reservation reservation{link::kMillisecond, 0.3};
  EXPECT_EQ(link::deadlineRefusal(reservation, EBUSY),
            "SCHED_DEADLINE with 300 us in each 1000 us is refused: Device or resource busy. So much time is not left "
            "for it beside other such threads: write smaller runtimes or longer periods. Or write sched: fifo.");
  EXPECT_NE(link::deadlineRefusal(reservation, EPERM).find("CAP_SYS_NICE"), std::string::npos);
  EXPECT_NE(link::scheduleByDeadline({link::kMillisecond, 1.5}), 0);  // more than there is
}

// A plugin host of one thread that answers every cycle.
class Answering {
 public:
  Answering(link::Segment<const link::StateSegment> state, link::HostSegment& host, std::uint32_t joints)
      : thread_([this, state = std::move(state), &host, joints](const std::stop_token& stop) {
          link::StateReader reader(*state);
          link::SlotWriter writer(host, 0, joints);
          auto frame = std::make_unique<link::FrameData>();
          link::CommandData data{};
          data.joints.fill(position(0.3));
          while (!stop.stop_requested()) {
            if (!reader.wait(link::now() + 10 * link::kMillisecond) || reader.newest(*frame) != link::Read::kNew)
              continue;
            data.cycle = frame->cycle;
            writer.write(data);
            ++answers_;
          }
        }) {}
  int answers() const noexcept { return answers_; }

 private:
  std::atomic<int> answers_{0};
  std::jthread thread_;
};

int seconds() { return std::getenv("ROBOTUI_LONG") != nullptr ? 10 : 3; }

// Page faults can be avoided only where memory could be locked; a sanitizer makes its own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

TEST(LoopTest, cycles_without_allocations_page_faults_or_lost_frames) {
  Waiting waiting;
  Rig rig(&waiting);
  Dummy dummy;
  config::HalConfig config;
  config.params = YAML::Node(YAML::NodeType::Map);
  dummy.open(rig.robot, config, link::kMillisecond);
  rig.settings.deadline = 0.8;
  Cycle cycle(rig.robot, rig.settings, dummy, *rig.board, rig.inbox, rig.torque, *rig.state);
  rig.state.sealAgainstWriters();
  auto readable = link::Segment<const link::StateSegment>::open(rig.state.shareReadOnly());
  link::StateReader reader(*readable);
  const Answering answering(link::Segment<const link::StateSegment>::open(rig.state.shareReadOnly()), *rig.host,
                            Rig::kJoints);
  Loop loop(cycle, {.period_ns = link::kMillisecond, .priority = 20, .core = std::nullopt, .allow_non_rt = true});
  const std::vector<std::string> refusals = loop.start();
  auto frame = std::make_unique<link::FrameData>();
  std::uint64_t frames = 0;
  std::uint64_t first = 0;  // where the reader came in
  for (const std::int64_t end = link::now() + seconds() * link::kSecond; link::now() < end;) {
    reader.wait(link::now() + 10 * link::kMillisecond);
    while (reader.next(*frame) == link::Read::kNew) {
      if (++frames == 1) first = frame->cycle;
      if (frames == 100) rig.grantAll();
    }
  }
  loop.stop();
  while (reader.next(*frame) == link::Read::kNew) ++frames;
  const auto statistics = link::relaxedCopy(readable->loop);
  EXPECT_EQ(statistics.allocations, 0U);
  EXPECT_TRUE(kSanitized || !refusals.empty() || statistics.page_faults == 0) << statistics.page_faults;
  EXPECT_EQ(first + frames - 1 + reader.lost(), statistics.cycles);
  EXPECT_GT(answering.answers(), 100);
  std::printf(
      "cycles %lu overruns %lu missed %lu lost %lu; wake-up p50 %ld p99 %ld max %ld ns; busy p50 %ld p99 %ld max %ld "
      "ns\n",
      statistics.cycles, statistics.overruns, statistics.missed_commands, reader.lost(),
      percentile(statistics.wake_up, 0.5), percentile(statistics.wake_up, 0.99), statistics.wake_up.max_ns,
      percentile(statistics.busy, 0.5), percentile(statistics.busy, 0.99), statistics.busy.max_ns);
}

TEST(LoopTest, an_ordinary_thread_needs_no_rights) {
  Rig rig;
  Loop loop(*rig.cycle, {.period_ns = link::kMillisecond, .priority = 0, .core = std::nullopt, .allow_non_rt = false});
  EXPECT_TRUE(loop.start().empty());
  link::StateReader reader(*rig.state);
  ASSERT_TRUE(reader.wait(link::now() + 5 * link::kSecond));
  EXPECT_EQ(link::relaxedLoad(rig.state->loop.priority), 0);
}

TEST(LoopTest, stopping_brings_all_joints_into_safe_state_first) {
  Waiting waiting;
  Rig rig(&waiting);
  Loop loop(*rig.cycle, {.period_ns = link::kMillisecond, .priority = 20, .core = std::nullopt, .allow_non_rt = true});
  loop.start();
  link::StateReader reader(*rig.state);
  ASSERT_TRUE(reader.wait(link::now() + 5 * link::kSecond));
  loop.stop();
  EXPECT_TRUE(rig.cycle->isAtRest());
  EXPECT_EQ(rig.frame().joints[0].control, static_cast<std::uint8_t>(link::Control::kSafe));
}

}  // namespace
}  // namespace robotui::rt::hal
