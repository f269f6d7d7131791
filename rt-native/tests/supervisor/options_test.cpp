#include "robotui/rt/supervisor/options.h"

#include <gtest/gtest.h>

namespace robotui::rt::supervisor {
namespace {

std::optional<Options> parse(std::vector<std::string> words) {
  words.insert(words.begin(), "robotui-rt");
  std::vector<char*> raw;
  for (std::string& word : words) {
    raw.push_back(word.data());
  }
  raw.push_back(nullptr);
  return parseOptions(static_cast<int>(words.size()), raw.data());
}

std::string refusal(const std::vector<std::string>& words) {
  try {
    parse(words);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "nothing was refused";
}

TEST(Options, AreThoseOfXBot) {
  const auto options = parse({"-C", "robot.yaml", "-D", "--period", "2000", "--ch-period", "10000", "-V", "--nrt"});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->config.filename(), "robot.yaml");
  EXPECT_TRUE(options->config.is_absolute());
  EXPECT_TRUE(options->overrides.dummy);
  EXPECT_EQ(options->overrides.period, std::chrono::microseconds(2000));
  EXPECT_EQ(options->communication.period, std::chrono::microseconds(10000));
  EXPECT_TRUE(options->communication.enabled);
  EXPECT_TRUE(options->verbose);
  EXPECT_TRUE(options->nrt);
  EXPECT_FALSE(options->allow_non_rt);
}

TEST(Options, TellTheProcessesWhatTheyMustKnow) {
  const auto options = parse({"--config", "/a.yaml", "--dummy", "--period", "500"});
  EXPECT_EQ(childArguments(*options),
            (std::vector<std::string>{"--config", "/a.yaml", "--dummy", "--period", "500", "--ch-period", "5000"}));
}

TEST(Options, RefuseWithASentence) {
  EXPECT_EQ(refusal({"-D"}), "A configuration is needed: robotui-rt -C FILE.");
  EXPECT_EQ(refusal({"-C", "a", "--period", "fast"}),
            "--period needs a number of microseconds from 100 to 1000000, not 'fast'.");
  EXPECT_EQ(refusal({"-C", "a", "--period", "1"}),
            "--period needs a number of microseconds from 100 to 1000000, not '1'.");
  EXPECT_EQ(refusal({"-C", "a", "b"}), "'b' is too much.");
  EXPECT_EQ(refusal({"-C", "a", "--what"}), "An option is not known, or lacks its value.");
}

TEST(Options, AskForHelp) { EXPECT_FALSE(parse({"--help"})); }

}  // namespace
}  // namespace robotui::rt::supervisor
