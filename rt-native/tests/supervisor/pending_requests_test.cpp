#include "robotui/rt/supervisor/pending_requests.h"

#include <gtest/gtest.h>

#include <map>

namespace robotui::rt::supervisor {
namespace {

class PendingRequestsTest : public ::testing::Test {
 protected:
  std::map<std::uint64_t, std::string> replies_;
  PendingRequests pending_{[this](std::uint64_t client, const std::string& text) { replies_[client] += text; }};
};

TEST_F(PendingRequestsTest, AnswersAllWhoWaitForTheSame) {
  pending_.add(Awaited::kStart, 1, 10, 100);
  pending_.add(Awaited::kStart, 1, 11, 100);
  pending_.add(Awaited::kStop, 1, 12, 100);
  pending_.settle(Awaited::kStart, 1, "ok");
  pending_.settle(Awaited::kStart, 1, "twice");
  EXPECT_EQ(replies_, (std::map<std::uint64_t, std::string>{{10, "ok"}, {11, "ok"}}));
}

TEST_F(PendingRequestsTest, KnowsCommandsByTheirNumber) {
  pending_.add(Awaited::kCommand, 1, 10, 100, 5);
  pending_.add(Awaited::kCommand, 1, 11, 100, 6);
  pending_.settle(Awaited::kCommand, 1, "ok", 6);
  EXPECT_EQ(replies_, (std::map<std::uint64_t, std::string>{{11, "ok"}}));
}

TEST_F(PendingRequestsTest, AnswersWithASentenceWhenItTakesTooLong) {
  pending_.add(Awaited::kStart, 1, 10, 100);
  pending_.expire(99);
  EXPECT_TRUE(replies_.empty());
  pending_.expire(100);
  EXPECT_EQ(replies_[10], "error The host of the plugin did not answer in time.");
}

TEST_F(PendingRequestsTest, KeepsABoundedNumber) {
  for (std::size_t i = 0; i < PendingRequests::kMost; ++i) pending_.add(Awaited::kReload, 1, 10, 100);
  EXPECT_TRUE(replies_.empty());
  pending_.add(Awaited::kReload, 1, 11, 100);
  EXPECT_EQ(replies_[11], "error Too many requests wait for an answer.");
}

TEST_F(PendingRequestsTest, ForgetsAClientThatIsGone) {
  pending_.add(Awaited::kStart, 1, 10, 100);
  pending_.forget(10);
  pending_.settleAll(1, "error");
  EXPECT_TRUE(replies_.empty());
}

}  // namespace
}  // namespace robotui::rt::supervisor
