#include "library.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "robotui/rt/hal/hal.h"
#include "robotui/rt/hal/kinds.h"

namespace robotui::rt::hal {
namespace {

std::string errorOf(const std::string& file) {
  try {
    loadLibrary(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Library, a_hal_of_the_user_is_loaded) {
  config::HalConfig config;
  config.type = "library";
  config.lib_file = OWN_HAL;
  const auto hal = create(config);
  std::array<link::JointState, 1> joints{};
  Measurements measured{joints, {}, {}};
  EXPECT_EQ(hal->sense(measured), Status::kOk);
  EXPECT_EQ(joints[0].link_position, 0.125);
}

TEST(Library, one_for_another_interface_is_refused_with_both_numbers) {
  const std::string error = errorOf(OTHER_HAL);
  EXPECT_NE(error.find("interface 99, this program has " + std::to_string(kHalAbi)), std::string::npos) << error;
}

TEST(Library, one_that_was_built_another_way_is_refused_with_both_ways) {
  const std::string error = errorOf(STRANGE_HAL);
  EXPECT_NE(error.find("libstrange_hal.so does not fit this program: it was built with _GLIBCXX_USE_CXX11_ABI 0, and "
                       "this program with "
                       "_GLIBCXX_USE_CXX11_ABI 1. Build it again with the same _GLIBCXX_USE_CXX11_ABI."),
            std::string::npos)
      << error;
}

TEST(Library, that_is_not_there_or_no_hal_is_an_error_with_its_name) {
  EXPECT_NE(errorOf("/nowhere/libHal.so").find("/nowhere/libHal.so"), std::string::npos);
  EXPECT_NE(errorOf("libm.so.6").find("ROBOTUI_RT_HAL"), std::string::npos);
}

TEST(Kinds, one_that_is_not_built_in_is_an_error) {
  config::HalConfig config;
  config.type = "ethercat";
  EXPECT_THROW(create(config), config::ConfigError);
}

}  // namespace
}  // namespace robotui::rt::hal
