// Writes what the joints do to a file, without making the cycle wait.
#pragma once

#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

// Parameters: `file` (default: robotui-log-NAME-DATE.csv in the folder of `folder`, default /tmp), `every` (cycles
// between samples, default 1), `joints` or `chains` are not claimed: it commands nothing. One line a sample: time, then
// for each joint position, velocity, effort, and the references of position and effort. A file for each start; its
// status counts samples and those that were lost since the disk was slow.
class Logging final : public ControlPlugin {
 public:
  static constexpr std::size_t kSamples = 4096;  // four seconds of a 1 kHz loop

  ~Logging() override { close(); }
  PluginRole role() const noexcept override { return PluginRole::kObserver; }
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  void on_stop(double time) noexcept override;
  std::string_view status() const noexcept override { return {status_.data(), status_length_}; }
  void close() override;

 private:
  static constexpr std::size_t kColumns = 5;  // of one joint
  struct CloseFile {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, CloseFile>;

  void write();
  void writeSamples(std::FILE* file);
  File openFile();
  void say(bool running) noexcept;

  std::vector<const Joint*> joints_;
  std::string name_;
  std::filesystem::path folder_;
  std::string fixed_file_;
  std::uint64_t every_ = 1;
  RtLog* log_ = nullptr;

  std::vector<double> ring_;  // kSamples rows
  std::size_t width_ = 0;
  std::atomic<std::uint64_t> in_{0};   // rows written by the loop
  std::atomic<std::uint64_t> out_{0};  // rows on their way to the file
  std::atomic<std::uint64_t> lost_{0};
  std::atomic<std::uint32_t> session_{0};  // odd while it runs: a start begins a file
  std::uint64_t cycles_ = 0;
  std::array<char, 96> status_{};
  std::size_t status_length_ = 0;
  std::atomic<bool> ending_{false};
  std::thread writer_;
};

}  // namespace robotui::rt::plugins
