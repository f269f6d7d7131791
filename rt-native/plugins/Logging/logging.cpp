#include "logging.h"

#include <charconv>
#include <chrono>
#include <cstring>
#include <ctime>

namespace robotui::rt::plugins {
namespace {

constexpr std::chrono::milliseconds kWritePeriod{20};
constexpr std::array<const char*, 5> kTitles{"position", "velocity", "effort", "position_reference",
                                             "effort_reference"};

std::string dateNow() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &local)};
}

char* append(char* at, char* end, std::string_view text) noexcept {
  const auto length = std::min<std::size_t>(text.size(), static_cast<std::size_t>(end - at));
  std::memcpy(at, text.data(), length);
  return at + length;
}

}  // namespace

bool Logging::init_control_plugin(Setup& setup) {
  const YAML::Node& params = setup.params();
  name_ = setup.name();
  fixed_file_ = params["file"].as<std::string>("");
  folder_ = params["folder"].as<std::string>("/tmp");
  const int every = params["every"].as<int>(1);
  if (every < 1) {
    setup.fail("`every` must be a number of cycles from 1.");
    return false;
  }
  if (!std::filesystem::is_directory(fixed_file_.empty() ? folder_
                                                         : std::filesystem::absolute(fixed_file_).parent_path())) {
    setup.fail("The folder of the log does not exist: " + (fixed_file_.empty() ? folder_.string() : fixed_file_) + ".");
    return false;
  }
  every_ = static_cast<std::uint64_t>(every);
  log_ = &setup.log();
  for (int i = 0; i < setup.robot().getJointNum(); ++i) {
    joints_.push_back(&setup.robot().joint(i));
  }
  width_ = 1 + kColumns * joints_.size();
  ring_.resize(kSamples * width_);
  writer_ = std::thread([this] { write(); });
  return true;
}

RtStatus Logging::on_start(double /*time*/) noexcept {
  cycles_ = 0;
  session_.fetch_add(1, std::memory_order_release);
  say(true);
  return RtStatus::ok();
}

RtStatus Logging::control_loop(double time, double /*period*/) noexcept {
  if (cycles_++ % every_ != 0) {
    return RtStatus::ok();
  }
  const std::uint64_t in = in_.load(std::memory_order_relaxed);
  if (in - out_.load(std::memory_order_acquire) >= kSamples) {
    lost_.fetch_add(1, std::memory_order_relaxed);
  } else {
    double* row = &ring_[(in % kSamples) * width_];
    *row++ = time;
    for (const Joint* joint : joints_) {
      *row++ = joint->getJointPosition();
      *row++ = joint->getJointVelocity();
      *row++ = joint->getJointEffort();
      *row++ = joint->getPositionReference();
      *row++ = joint->getEffortReference();
    }
    in_.store(in + 1, std::memory_order_release);
  }
  if (cycles_ % 512 == 1) {
    say(true);
  }
  return RtStatus::ok();
}

void Logging::on_stop(double /*time*/) noexcept {
  session_.fetch_add(1, std::memory_order_release);
  say(false);
}

void Logging::close() {
  ending_.store(true);
  if (writer_.joinable()) {
    writer_.join();
  }
}

void Logging::say(bool running) noexcept {
  char* const end = status_.data() + status_.size();
  char* at = append(status_.data(), end, running ? "writing: " : "stopped: ");
  at = std::to_chars(at, end, in_.load(std::memory_order_relaxed)).ptr;
  at = append(at, end, " samples, ");
  at = std::to_chars(at, end, lost_.load(std::memory_order_relaxed)).ptr;
  at = append(at, end, " lost");
  status_length_ = static_cast<std::size_t>(at - status_.data());
}

// The ordinary thread: a file for each start, closed when what came before the stop is in it.
void Logging::write() {
  File file;
  std::uint32_t known = 0;
  for (bool going = true; going;) {
    going = !ending_.load();
    const std::uint32_t session = session_.load(std::memory_order_acquire);
    const bool has_started = session != known && (session % 2 == 1 || session - known > 1);
    if (has_started) {
      file = openFile();
    }
    // Samples of a session that has begun only now wait until its file is open.
    if (session % 2 == 1 || known % 2 == 1 || has_started) {
      writeSamples(file.get());
    }
    if (session % 2 == 0) {
      file.reset();
    }
    known = session;
    if (going) {
      std::this_thread::sleep_for(kWritePeriod);
    }
  }
}

Logging::File Logging::openFile() {
  const std::string path =
      fixed_file_.empty() ? (folder_ / ("robotui-log-" + name_ + "-" + dateNow() + ".csv")).string() : fixed_file_;
  File file(std::fopen(path.c_str(), "we"));
  if (file == nullptr) {
    log_->error("The log " + path + " cannot be written: " + std::strerror(errno));
    return file;
  }
  log_->info("writing to " + path);
  std::fputs("time", file.get());
  for (const Joint* joint : joints_) {
    for (const char* title : kTitles) {
      std::fprintf(file.get(), ",%s.%s", joint->name().c_str(), title);
    }
  }
  std::fputc('\n', file.get());
  return file;
}

void Logging::writeSamples(std::FILE* file) {
  const std::uint64_t in = in_.load(std::memory_order_acquire);
  for (std::uint64_t out = out_.load(std::memory_order_relaxed); out < in; ++out) {
    const double* row = &ring_[(out % kSamples) * width_];
    for (std::size_t i = 0; file != nullptr && i < width_; ++i) {
      std::fprintf(file, i == 0 ? "%.6f" : ",%.9g", row[i]);
    }
    if (file != nullptr) {
      std::fputc('\n', file);
    }
    out_.store(out + 1, std::memory_order_release);
  }
  if (file != nullptr) {
    std::fflush(file);
  }
}

}  // namespace robotui::rt::plugins

using robotui::rt::plugins::Logging;
ROBOTUI_RT_PLUGIN(Logging)
