#include "robotui/rt/config/reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "robotui/rt/link/words.h"

namespace robotui::rt::config {
namespace {

std::string kindOf(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Map: return "a map";
    case YAML::NodeType::Sequence: return "a list";
    case YAML::NodeType::Scalar: return "'" + node.Scalar().substr(0, 80) + "'";
    default: return "nothing";
  }
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string range(const std::string& least, const std::string& most) { return "from " + least + " to " + most; }

template <typename Number>
std::optional<Number> parse(const YAML::Node& node) {
  if (!node.IsScalar()) return {};
  const std::string& text = node.Scalar();
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  Number value{};
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

std::vector<std::string> strings(std::initializer_list<std::string_view> words) { return {words.begin(), words.end()}; }

}  // namespace

Reader::Reader(const YAML::Node& node, std::filesystem::path file, std::string path, Place above)
    : node_(node), file_(std::move(file)), path_(std::move(path)), above_(std::move(above)) {
  if (!node_.IsMap()) return;
  std::vector<std::string> seen;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) Reader(entry.first, file_, path_, above_).fail("has a key that is not a word");
    const std::string& key = entry.first.Scalar();
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
      Reader(entry.first, file_, path_, above_).fail("has the key '" + key + "' twice; remove one of them");
    }
    seen.push_back(key);
  }
}

Place Reader::place() const {
  const YAML::Mark mark = node_.IsDefined() ? node_.Mark() : YAML::Mark::null_mark();
  if (mark.is_null()) return above_;
  return {file_, mark.line + 1, mark.column + 1};
}

void Reader::fail(const std::string& what) const {
  throw ConfigError(place(), path_.empty() ? what : path_ + " " + what);
}

std::optional<Reader> Reader::find(std::string_view key) const {
  if (node_.IsNull()) return {};
  if (!node_.IsMap()) fail("is " + kindOf(node_) + "; expected a map with keys such as '" + std::string(key) + "'");
  for (const auto& entry : node_) {
    if (entry.first.Scalar() == key) {
      return Reader(entry.second, file_, path_.empty() ? std::string(key) : path_ + "." + std::string(key), place());
    }
  }
  return {};
}

Reader Reader::at(std::string_view key, std::string_view example) const {
  if (auto found = find(key); found && !found->node().IsNull()) return *found;
  fail((path_.empty() ? "the key '" : "has no '") + std::string(key) + (path_.empty() ? "' is missing" : "'") +
       "; write: " + std::string(example));
}

std::vector<std::pair<std::string, Reader>> Reader::entries() const {
  if (node_.IsNull()) return {};
  if (!node_.IsMap()) fail("is " + kindOf(node_) + "; expected a map");
  std::vector<std::pair<std::string, Reader>> result;
  for (const auto& entry : node_) {
    const std::string& key = entry.first.Scalar();
    result.emplace_back(key, Reader(entry.second, file_, path_.empty() ? key : path_ + "." + key, place()));
  }
  return result;
}

void Reader::knows(std::initializer_list<std::string_view> keys, std::vector<std::string>& warnings) const {
  const auto known = strings(keys);
  for (const auto& [key, value] : entries()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string meant = didYouMean(key, known);
    if (!meant.empty()) value.fail("is not a key" + meant);
    const ConfigError line(value.place(),
                           value.path() + " is not known and has no effect; known are " + link::listed(known));
    warnings.emplace_back(line.what());
  }
}

void Reader::knowsOnly(std::initializer_list<std::string_view> keys) const {
  const auto known = strings(keys);
  for (const auto& [key, value] : entries()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string meant = didYouMean(key, known);
    value.fail("is not a key" + (meant.empty() ? "; known are " + link::listed(known) : meant));
  }
}

std::vector<Reader> Reader::items(std::string_view example) const {
  if (node_.IsNull()) return {};
  if (!node_.IsSequence()) fail("is " + kindOf(node_) + "; expected a list, such as " + std::string(example));
  std::vector<Reader> result;
  for (const auto& item : node_) {
    result.emplace_back(item, file_, path_ + "[" + std::to_string(result.size()) + "]", place());
  }
  return result;
}

std::string Reader::text() const {
  if (!node_.IsScalar() || node_.Scalar().empty()) fail("is " + kindOf(node_) + "; expected a word");
  return node_.Scalar();
}

bool Reader::flag() const {
  bool value = false;
  if (!node_.IsScalar() || !YAML::convert<bool>::decode(node_, value))
    fail("is " + kindOf(node_) + "; expected true or false");
  return value;
}

long long Reader::whole(long long least, long long most) const {
  const auto value = parse<long long>(node_);
  if (!value || *value < least || *value > most) {
    fail("is " + kindOf(node_) + "; expected a whole number " + range(std::to_string(least), std::to_string(most)));
  }
  return *value;
}

double Reader::real(double least, double most) const {
  const auto value = parse<double>(node_);
  if (!value || !std::isfinite(*value) || *value < least || *value > most) {
    fail("is " + kindOf(node_) + "; expected a number " + range(number(least), number(most)));
  }
  return *value;
}

std::string Reader::oneOf(std::initializer_list<std::string_view> words) const {
  const auto known = strings(words);
  std::string word = text();
  if (std::find(known.begin(), known.end(), word) == known.end()) {
    fail("is '" + word + "'; expected one of " + link::listed(known) + didYouMean(word, known));
  }
  return word;
}

std::string Reader::textOr(std::string_view key, std::string_view otherwise) const {
  const auto value = find(key);
  return value ? value->text() : std::string(otherwise);
}

bool Reader::flagOr(std::string_view key, bool otherwise) const {
  const auto value = find(key);
  return value ? value->flag() : otherwise;
}

long long Reader::wholeOr(std::string_view key, long long otherwise, long long least, long long most) const {
  const auto value = find(key);
  return value ? value->whole(least, most) : otherwise;
}

double Reader::realOr(std::string_view key, double otherwise, double least, double most) const {
  const auto value = find(key);
  return value ? value->real(least, most) : otherwise;
}

}  // namespace robotui::rt::config
