// A HAL of a user, built as a library.
#include <algorithm>
#include <utility>

#include "robotui/rt/hal/hal.h"

namespace {

class OwnHal : public robotui::rt::hal::Hal {
 public:
  void open(const robotui::rt::config::RobotDescription&, const robotui::rt::config::HalConfig&,
            std::int64_t) override {}
  robotui::rt::hal::Status sense(robotui::rt::hal::Measurements& into) noexcept override {
    std::for_each(into.joints.begin(), into.joints.end(), [](auto& joint) { joint.link_position = 0.125; });
    return robotui::rt::hal::Status::kOk;
  }
  robotui::rt::hal::Status move(std::span<const robotui::rt::hal::Reference>) noexcept override {
    return robotui::rt::hal::Status::kOk;
  }
  void close() noexcept override {}
  std::vector<std::string> news() override { return std::exchange(news_, {}); }

 private:
  std::vector<std::string> news_{"The joints have been oiled."};
};

}  // namespace

#ifdef OTHER_ABI
extern "C" __attribute__((visibility("default"))) std::uint32_t robotui_rt_hal_abi() { return 99; }
extern "C" __attribute__((visibility("default"))) robotui::rt::hal::Hal* robotui_rt_hal_create() {
  return new OwnHal();
}
#else
ROBOTUI_RT_HAL(OwnHal)
#endif
