// How a step of a plugin in its real-time thread went: well, or failed with a text of bounded length. Nothing is
// thrown, nothing allocated.
#pragma once

#include <string_view>

#include "robotui/rt/link/fixed_text.h"

namespace robotui::rt {

class [[nodiscard]] RtStatus {
 public:
  static constexpr std::size_t kTextLength = 240;  // a longer text is cut

  static RtStatus ok() noexcept { return {}; }

  // Why, for the user: the parts one behind the other, as in failed("The joint ", joint.name(), " is too hot.").
  template <typename... Parts>
  static RtStatus failed(const Parts&... parts) noexcept {
    RtStatus status;
    status.ok_ = false;
    (status.text_.append(std::string_view(parts)), ...);
    return status;
  }

  bool isOk() const noexcept { return ok_; }
  std::string_view text() const noexcept { return text_.view(); }  // empty where it is well

 private:
  RtStatus() noexcept = default;

  bool ok_ = true;
  link::FixedText<kTextLength> text_;
};

}  // namespace robotui::rt
