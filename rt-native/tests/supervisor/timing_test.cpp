// What whole processes do over many cycles: ten seconds of them, or as many as ROBOTUI_LONG asks for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/histogram.h"
#include "robotui/rt/link/relaxed.h"
#include "running_robot.h"

namespace robotui::rt::supervisor {
namespace {

bool isLong() { return std::getenv("ROBOTUI_LONG") != nullptr; }

constexpr bool isSanitized() {
#ifdef RT_SANITIZED
  return true;
#else
  return false;
#endif
}

constexpr const char* kAllShipped = R"(
xbotcore_plugins:
  homing: {type: Homing, params: {time: 1}}
  sine: {type: Sine, params: {joints: [shoulder_yaw]}}
  impedance: {type: JointImpedance, params: {joints: [shoulder_pitch], gravity: true}}
  gravity: {type: GravityCompensation, params: {joints: [elbow_pitch]}}
  cartesian: {type: CartesianMotion, params: {chain: arm}}
  communication: {type: XBotCommunicationPlugin}
  log: {type: Logging, params: {file: /dev/null}}
)";

class ZeroTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (isSanitized()) GTEST_SKIP() << "sanitizers allocate and fault themselves";
    robot_.emplace(kAllShipped);
    ask("switch log 1");
    has_rights_ = robot_->board()->real_time != 0;
    attachment_ = robot_->attach();
  }

  void ask(const std::string& words) {
    const link::Reply reply = robot_->ask(words);
    EXPECT_TRUE(reply.ok) << words << ": " << reply.text;
  }

  void switchAll(const std::vector<std::string>& plugins, const std::string& wanted) {
    std::string words = "switch";
    for (const std::string& plugin : plugins) words.append(" ").append(plugin).append(wanted);
    ask(words);
  }

  const link::ThreadStatistics& thread() const { return attachment_.hosts[0]->thread_statistics[0]; }

  // A quarter of all cycles with these plugins, which begin and end together; each is asked something meanwhile.
  // Counted by the processes themselves.
  void cycleWith(
      const std::vector<std::string>& plugins, const std::function<void()>& meanwhile = [] {}) {
    switchAll(plugins, " 1");
    const std::uint64_t wanted = link::relaxedLoad(thread().cycles) + (isLong() ? 60'000 : 10'000) / 4;
    const std::uint64_t faults = link::relaxedLoad(thread().page_faults);
    EXPECT_TRUE(eventually(
        [&] {
          meanwhile();
          return link::relaxedLoad(thread().cycles) > wanted;
        },
        std::chrono::seconds(isLong() ? 60 : 25)));
    EXPECT_TRUE(!has_rights_ || link::relaxedLoad(thread().page_faults) == faults)
        << "memory is locked, and yet pages are missing";
    EXPECT_EQ(link::relaxedLoad(thread().allocations), 0U) << plugins.front();
    EXPECT_EQ(link::relaxedLoad(attachment_.state->loop.allocations), 0U) << plugins.front();
    switchAll(plugins, " 0");
  }

  std::optional<RunningRobot> robot_;
  bool has_rights_ = false;
  link::Attachment attachment_;
};

TEST_F(ZeroTest, CyclesAllocateNothingWithAllShippedPlugins) {
  cycleWith({"homing"});
  cycleWith({"sine", "impedance", "gravity"});
  cycleWith({"cartesian"}, [this] { robot_->ask("command cartesian move 0 0 0.001"); });
  ask("switch communication 1");
  ask("take 5");
  std::vector<link::JointCommand> references(robot_->board()->joints);
  references[0].mode = link::kPosition;
  cycleWith({"communication"}, [&] {
    references[0].position += 0.001;
    robot_->client().reference(references);
  });
}

// ---- a spinning host against the timing of the HAL

struct Window {
  link::LoopStatistics before;
  std::int64_t began = link::now();

  explicit Window(const link::Attachment& attachment) : before(link::relaxedCopy(attachment.state->loop)) {}
};

struct Seen {
  double share;  // of the cycles that the time had room for
  std::int64_t p99_ns;
};

Seen look(const Window& window, const link::Attachment& attachment) {
  const auto after = link::relaxedCopy(attachment.state->loop);
  const auto room = static_cast<double>(link::now() - window.began) / static_cast<double>(after.period_ns);
  return {static_cast<double>(after.cycles - window.before.cycles) / room,
          percentile(difference(after.wake_up, window.before.wake_up), 0.99)};
}

template <typename Value>
double median(std::vector<Seen>& of, Value value) {
  std::sort(of.begin(), of.end(), [&](const Seen& a, const Seen& b) { return value(a) < value(b); });
  return static_cast<double>(value(of[of.size() / 2]));
}

constexpr const char* kSpinner = R"(
xbotcore_threads:
  first: {sched: fifo, prio: 60, period: 0.001, host: a}
xbotcore_plugins:
  bad: {thread: first, type: Naughty, params: {joints: [shoulder_yaw]}}
)";

// Calm and spinning windows in turn, so that what the machine does besides falls on both.
TEST(Spinning, AHostDoesNotDelayTheHal) {
  if (!isLong()) GTEST_SKIP() << "takes half a minute: ./robotui test native --long";
  if (isSanitized()) GTEST_SKIP() << "sanitizers have another timing";
  RunningRobot robot(kSpinner);
  const auto attachment = robot.attach();
  if (robot.board()->real_time == 0) GTEST_SKIP() << "needs real-time rights";
  std::vector<Seen> calm;
  std::vector<Seen> spinning;
  for (std::uint32_t round = 1; round <= 8; ++round) {
    ASSERT_TRUE(eventually([&] { return robot.ask("switch bad 1").ok; })) << robot.output();
    Window quiet(attachment);
    std::this_thread::sleep_for(
        std::chrono::milliseconds(2700));  // five deaths in ten seconds, and the host is given up
    calm.push_back(look(quiet, attachment));
    Window busy(attachment);
    robot.ask("command bad spin");
    ASSERT_TRUE(eventually([&] { return robot.board()->host[0].respawns == round; })) << robot.output();
    spinning.push_back(look(busy, attachment));
  }
  const auto p99 = [](const Seen& seen) { return seen.p99_ns; };
  const auto share = [](const Seen& seen) { return seen.share; };
  const double calm_p99 = median(calm, p99);
  const double spinning_p99 = median(spinning, p99);
  std::printf(
      "wake-up of the HAL, median p99 of 8 windows: calm %.0f ns, while a host spins %.0f ns; cycles done: %.4f and "
      "%.4f\n",
      calm_p99, spinning_p99, median(calm, share), median(spinning, share));
  EXPECT_GT(median(spinning, share), 0.9 * median(calm, share));
  EXPECT_LT(spinning_p99, 3 * calm_p99 + 200'000);
}

}  // namespace
}  // namespace robotui::rt::supervisor
