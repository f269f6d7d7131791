// Reads a tree of YAML so that each mistake names its place, what was expected there, and what was meant.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "robotui/rt/config/config.h"

namespace robotui::rt::config {

// One value of a YAML file with the way to it, such as "HALInterface.deadline". All functions throw ConfigError.
class Reader {
 public:
  // The file may be empty where it is not known (parameters of a plugin): places are then lines alone.
  Reader(const YAML::Node& node, std::filesystem::path file, std::string path = {}, Place above = {});

  const YAML::Node& node() const noexcept { return node_; }
  const std::string& path() const noexcept { return path_; }
  Place place() const;
  [[noreturn]] void fail(const std::string& what) const;

  // Maps. An empty value (`key:` alone) counts as a map without entries.
  std::optional<Reader> find(std::string_view key) const;
  Reader at(std::string_view key, std::string_view example) const;
  std::vector<std::pair<std::string, Reader>> entries() const;
  // Keys that nobody knows: an error where one is a likely slip of the pen, else a line for `warnings`.
  void knows(std::initializer_list<std::string_view> keys, std::vector<std::string>& warnings) const;
  // The same for maps that are wholly ours: every other key is an error.
  void knowsOnly(std::initializer_list<std::string_view> keys) const;

  // Lists.
  std::vector<Reader> items(std::string_view example) const;

  // Single values.
  std::string text() const;
  bool flag() const;
  long long whole(long long least, long long most) const;
  double real(double least, double most) const;
  std::string oneOf(std::initializer_list<std::string_view> words) const;

  // The value of a key, or what it is without one.
  std::string textOr(std::string_view key, std::string_view otherwise) const;
  bool flagOr(std::string_view key, bool otherwise) const;
  long long wholeOr(std::string_view key, long long otherwise, long long least, long long most) const;
  double realOr(std::string_view key, double otherwise, double least, double most) const;

 private:
  YAML::Node node_;
  std::filesystem::path file_;
  std::string path_;
  Place above_;
};

// The map at the top of a YAML file. `wanted` is where the file was asked for, `what` it is for the user ("the joint
// map"). Throws ConfigError.
Reader readYamlFile(const std::filesystem::path& file, const Place& wanted, const std::string& what);

// The likely one of the words that was meant: ", did you mean 'x'?", or nothing.
std::string didYouMean(std::string_view word, const std::vector<std::string>& known);

}  // namespace robotui::rt::config
