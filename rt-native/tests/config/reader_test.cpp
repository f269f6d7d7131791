#include <gtest/gtest.h>

#include "robotui/rt/config/reader.h"

namespace robotui::rt::config {
namespace {

Reader read(const std::string& text) { return Reader(YAML::Load(text), "a.yaml"); }

TEST(Reader, ReadsWhatIsThereAndElseTheDefault) {
  const Reader top = read("n: 3\nx: 1e-3\nf: true\nt: word\n");
  EXPECT_EQ(top.wholeOr("n", 0, 0, 9), 3);
  EXPECT_EQ(top.wholeOr("m", 7, 0, 9), 7);
  EXPECT_EQ(top.realOr("x", 0, 0, 1), 1e-3);
  EXPECT_TRUE(top.flagOr("f", false));
  EXPECT_EQ(top.textOr("t", ""), "word");
}

TEST(Reader, NumbersAreWhollyNumbers) {
  EXPECT_THROW(read("n: 3x").wholeOr("n", 0, 0, 9), ConfigError);
  EXPECT_THROW(read("n: 3.5").wholeOr("n", 0, 0, 9), ConfigError);
  EXPECT_THROW(read("n: 99999999999999999999").wholeOr("n", 0, 0, 9), ConfigError);
  EXPECT_THROW(read("x: .inf").realOr("x", 0, 0, 1e300), ConfigError);
  EXPECT_THROW(read("x: [1]").realOr("x", 0, 0, 1), ConfigError);
  EXPECT_THROW(read("x:").realOr("x", 0, 0, 1), ConfigError);
}

TEST(Reader, PlacesAreThoseOfTheFile) {
  const Reader x = *read("a:\n  b: {c: 1}\n").find("a")->find("b")->find("c");
  EXPECT_EQ(x.path(), "a.b.c");
  EXPECT_EQ(x.place().line, 2);
  EXPECT_EQ(x.place().column, 10);
}

TEST(Reader, MapsThatAreOursRefuseAllOtherKeys) {
  EXPECT_NO_THROW(read("a: 1").knowsOnly({"a", "b"}));
  EXPECT_THROW(read("zzzz: 1").knowsOnly({"a", "b"}), ConfigError);
}

TEST(Reader, AnEmptyValueIsAnEmptyMapAndList) {
  const Reader nothing = *read("a:").find("a");
  EXPECT_TRUE(nothing.entries().empty());
  EXPECT_TRUE(nothing.items("[1]").empty());
  EXPECT_FALSE(nothing.find("b"));
}

TEST(DidYouMean, FindsTheNearestWordAndNothingFarAway) {
  EXPECT_EQ(didYouMean("perod", {"prio", "period"}), ", did you mean 'period'?");
  EXPECT_EQ(didYouMean("PERIOD", {"period"}), ", did you mean 'period'?");
  EXPECT_EQ(didYouMean("xyz", {"period"}), "");
  EXPECT_EQ(didYouMean(std::string(100000, 'a'), {"period"}), "");
}

}  // namespace
}  // namespace robotui::rt::config
