#include "robotui/rt/plugin/channel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "robotui/rt/link/allocations.h"

namespace robotui::rt {
namespace {

struct Sample {
  static constexpr Schema kSchema{"test/sample", 1};
  std::uint64_t number;
  std::uint64_t twice;
  std::uint32_t odd_size;
};

// Two processes, each with its own segment.
class ChannelTest : public ::testing::Test {
 protected:
  std::unique_ptr<ChannelSegment> a_ = std::make_unique<ChannelSegment>();
  std::unique_ptr<ChannelSegment> b_ = std::make_unique<ChannelSegment>();
  ChannelDirectory in_a_{*a_, {a_.get(), b_.get()}};
  ChannelDirectory in_b_{*b_, {a_.get(), b_.get()}};
};

std::string refusal(const std::function<void()>& step) {
  try {
    step();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return {};
}

TEST_F(ChannelTest, CarriesTheNewestValueToAnotherProcess) {
  ChannelReader<Sample> reader(in_b_, "samples");
  Sample got{};
  EXPECT_FALSE(reader.latest(got));
  ChannelWriter<Sample> writer(in_a_, "samples");
  EXPECT_FALSE(reader.latest(got));
  writer.write({1, 2, 3});
  writer.write({4, 8, 5});
  ASSERT_TRUE(reader.latest(got));
  EXPECT_EQ(got.number, 4u);
  EXPECT_EQ(got.odd_size, 5u);
}

TEST_F(ChannelTest, GivesAllValuesInOrderAndCountsWhatWasOverwritten) {
  ChannelWriter<Sample> writer(in_a_, "samples", 4);
  ChannelReader<Sample> reader(in_b_, "samples");
  for (std::uint64_t i = 0; i < 6; ++i) {
    writer.write({i, 2 * i, 0});
  }
  Sample got{};
  for (std::uint64_t i = 2; i < 6; ++i) {
    ASSERT_TRUE(reader.next(got));
    EXPECT_EQ(got.number, i);
  }
  EXPECT_FALSE(reader.next(got));
  EXPECT_EQ(reader.lost(), 2u);
}

TEST_F(ChannelTest, HasOneWriter) {
  const ChannelWriter<Sample> writer(in_a_, "samples");
  EXPECT_NE(refusal([&] { ChannelWriter<Sample>(in_b_, "samples"); }).find("'samples' has a writer already"),
            std::string::npos);
}

TEST_F(ChannelTest, IsFreeAgainWhenItsWriterIsGoneAndFindsTheNextOne) {
  ChannelReader<Sample> reader(in_b_, "samples");
  Sample got{};
  {
    ChannelWriter<Sample> writer(in_a_, "samples");
    writer.write({1, 2, 3});
    ASSERT_TRUE(reader.next(got));
  }
  EXPECT_FALSE(reader.isConnected());
  ChannelWriter<Sample> writer(in_b_, "samples");
  writer.write({9, 18, 3});
  ASSERT_TRUE(reader.next(got));
  EXPECT_EQ(got.number, 9u);
}

// The same bytes, said to mean something else.
struct NewSample : Sample {
  static constexpr Schema kSchema{"test/sample", 2};
};

TEST_F(ChannelTest, RefusesAReaderOfAnotherSchemaAndNamesBoth) {
  ChannelWriter<Sample> writer(in_a_, "samples");
  EXPECT_EQ(refusal([&] { ChannelReader<NewSample>(in_b_, "samples"); }),
            "The channel 'samples' carries test/sample version 1 (24 bytes), and is read here as test/sample version 2 "
            "(24 bytes): build its writer "
            "and its readers from the same definition.");
  EXPECT_NE(refusal([&] { ChannelReader<double>(in_b_, "samples"); }).find("read here as float64 version 1 (8 bytes)"),
            std::string::npos);
}

TEST_F(ChannelTest, ReadsNothingOfAWriterOfAnotherSchemaThatComesLaterAndSaysSo) {
  ChannelReader<double> reader(in_b_, "samples");
  EXPECT_EQ(reader.state(), ChannelState::kNoWriter);
  double got = 0;
  {
    ChannelWriter<Sample> writer(in_a_, "samples");
    writer.write({1, 2, 3});
    EXPECT_FALSE(reader.latest(got));
    EXPECT_EQ(reader.state(), ChannelState::kOtherSchema);
    EXPECT_NE(reader.objection().find("carries test/sample version 1"), std::string::npos);
    ChannelReader<double> patient(in_b_, "samples", OtherSchema::kAwait);
    EXPECT_EQ(patient.state(), ChannelState::kOtherSchema);
  }
  ChannelWriter<double> writer(in_a_, "samples");
  writer.write(1.5);
  EXPECT_EQ(reader.state(), ChannelState::kConnected);
  EXPECT_EQ(reader.objection(), "");
  ASSERT_TRUE(reader.latest(got));
  EXPECT_DOUBLE_EQ(got, 1.5);
}

// Whatever its name in C++ and whoever compiled it.
struct SameBytes {
  static constexpr Schema kSchema{"test/sample", 1};
  std::uint64_t a;
  std::uint64_t b;
  std::uint32_t c;
};

TEST_F(ChannelTest, KnowsATypeByItsSchemaAlone) {
  ChannelWriter<Sample> writer(in_a_, "samples");
  writer.write({4, 8, 5});
  ChannelReader<SameBytes> reader(in_b_, "samples");
  SameBytes got{};
  ASSERT_TRUE(reader.latest(got));
  EXPECT_EQ(got.b, 8u);
}

TEST_F(ChannelTest, AsksNothingOfTheHeapInACycle) {
  ChannelWriter<Sample> writer(in_a_, "samples");
  ChannelReader<Sample> reader(in_b_, "samples");
  ChannelReader<double> nobody(in_b_, "nobody");
  Sample got{};
  double none = 0;
  const std::uint64_t before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    for (std::uint64_t i = 0; i < 20; ++i) {
      writer.write({i, 2 * i, 0});
      reader.next(got);
      reader.latest(got);
      nobody.latest(none);
      nobody.state();
    }
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

struct Large {
  static constexpr Schema kSchema{"test/large", 1};
  std::array<char, 9000> bytes;
};

TEST_F(ChannelTest, RefusesWhatDoesNotFitWithASentence) {
  EXPECT_NE(refusal([&] { ChannelWriter<Large>(in_a_, "large", 1); }).find("there is room for 0"), std::string::npos);
  EXPECT_NE(refusal([&] { ChannelWriter<int>(in_a_, std::string(80, 'x')); }).find("1 to 63 bytes"), std::string::npos);
  std::vector<ChannelWriter<int>> all;
  for (std::uint32_t i = 0; i < kMaxChannels; ++i) {
    all.emplace_back(in_a_, "c" + std::to_string(i));
  }
  EXPECT_NE(refusal([&] { ChannelWriter<int>(in_a_, "one more"); }).find("can have 32"), std::string::npos);
}

TEST_F(ChannelTest, SurvivesAWriterThatScribbles) {
  ChannelWriter<Sample> writer(in_a_, "samples");
  writer.write({1, 2, 3});
  ChannelReader<Sample> reader(in_b_, "samples");
  Sample got{};
  ASSERT_TRUE(reader.latest(got));
  a_->slots[0].depth.store(0xffffffff);
  a_->slots[0].words.store(0xfffffff0);
  a_->slots[0].written.store(~std::uint64_t{0});
  EXPECT_FALSE(reader.latest(got));
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_FALSE(reader.next(got));
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::milliseconds(100));
}

TEST_F(ChannelTest, IsNeverTorn) {
  ChannelWriter<Sample> writer(in_a_, "samples", 2);
  std::atomic<bool> done{false};
  std::thread writing([&] {
    for (std::uint64_t i = 1; i <= 100000; ++i) {
      writer.write({i, 2 * i, static_cast<std::uint32_t>(i)});
    }
    done = true;
  });
  ChannelReader<Sample> reader(in_b_, "samples");
  std::uint64_t last = 0;
  while (!done) {
    Sample got{};
    if (reader.latest(got)) {
      ASSERT_EQ(got.twice, 2 * got.number);
      ASSERT_EQ(got.odd_size, static_cast<std::uint32_t>(got.number));
      ASSERT_GE(got.number, last);
      last = got.number;
    }
  }
  writing.join();
}

}  // namespace
}  // namespace robotui::rt
