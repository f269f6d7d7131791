#include "ctl_push.h"

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/state.h"

namespace robotui::rt::supervisor {
namespace {

constexpr link::Client::Milliseconds kReply{5000};
constexpr double kMoved = 1e-3;  // rad or m: less is not told

std::unique_ptr<link::FrameData> frameOf(const link::Attachment& attachment) {
  auto frame = std::make_unique<link::FrameData>();
  link::StateReader reader(*attachment.state);
  for (int i = 0; i < 100; ++i) {
    if (reader.newest(*frame) == link::Read::kNew) return frame;
    reader.wait(link::now() + link::kSecond);
  }
  throw std::runtime_error("The HAL does not cycle.");
}

}  // namespace

int pushRobot(link::Client& client, const std::vector<std::string>& words, double seconds) {
  const link::Attachment attachment = client.attach(kReply);
  auto board = std::make_unique<link::BoardData>();
  link::BoardReader(*attachment.board).read(*board);
  const auto before = frameOf(attachment);
  std::ostringstream request;
  request << "push ";
  for (const std::string& word : words) request << word << ' ';
  request << seconds;
  const link::Reply reply = client.request(request.str(), kReply);
  if (!reply.ok) {
    std::cerr << reply.text << '\n';
    return 1;
  }
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    if (client.notice(std::chrono::milliseconds(50)) != link::Notice::kGone) continue;
    std::cerr << "The robot is gone.\n";
    return 1;
  }
  const auto after = frameOf(attachment);
  std::cout << std::fixed << std::setprecision(4);
  bool any = false;
  for (std::uint32_t i = 0; i < board->joints; ++i) {
    const double from = before->joints[i].link_position;
    const double to = after->joints[i].link_position;
    if (std::abs(to - from) < kMoved) continue;
    any = true;
    std::cout << std::left << std::setw(26) << link::view(board->joint[i].name) << from << " -> " << to << '\n';
  }
  if (!any) std::cout << "No joint gave way.\n";
  return 0;
}

}  // namespace robotui::rt::supervisor
