#include "message_shape.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::size_t kLongest = 256 * 1024;  // of a definition
constexpr int kDeepest = 32;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view nextLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  return line;
}

// `a/B` is meant by `B`, too.
bool isMeant(std::string_view full, std::string_view wanted) {
  return full == wanted ||
         (full.size() > wanted.size() && full.ends_with(wanted) && full[full.size() - wanted.size() - 1] == '/');
}

}  // namespace

class MessageShape::Cursor {
 public:
  explicit Cursor(std::span<const std::uint8_t> bytes) noexcept : left_(bytes) {}
  bool skip(std::uint64_t bytes) noexcept {
    if (bytes > left_.size()) return false;
    left_ = left_.subspan(static_cast<std::size_t>(bytes));
    return true;
  }
  bool length(std::uint32_t& into) noexcept {
    const auto* at = left_.data();
    if (!skip(sizeof(into))) return false;
    std::memcpy(&into, at, sizeof(into));
    return true;
  }
  const std::uint8_t* at() const noexcept { return left_.data(); }
  bool atEnd() const noexcept { return left_.empty(); }

 private:
  std::span<const std::uint8_t> left_;
};

MessageShape::Field MessageShape::fieldOf(std::string_view type, std::string_view name) {
  Field field;
  field.name = name;
  if (const std::size_t open = type.find('['); open != std::string_view::npos) {
    field.many = true;
    std::from_chars(type.data() + open + 1, type.data() + type.size(), field.count);
    type = type.substr(0, open);
  }
  struct Known {
    std::string_view name;
    Kind kind;
    std::uint32_t size;
  };
  static constexpr Known kKnown[] = {
      {"bool", Kind::kUint, 1},     {"byte", Kind::kInt, 1},    {"char", Kind::kUint, 1},
      {"int8", Kind::kInt, 1},      {"uint8", Kind::kUint, 1},  {"int16", Kind::kInt, 2},
      {"uint16", Kind::kUint, 2},   {"int32", Kind::kInt, 4},   {"uint32", Kind::kUint, 4},
      {"int64", Kind::kInt, 8},     {"uint64", Kind::kUint, 8}, {"float32", Kind::kFloat, 4},
      {"float64", Kind::kFloat, 8}, {"string", Kind::kText, 0}, {"time", Kind::kTime, 8},
      {"duration", Kind::kTime, 8}};
  const auto* known =
      std::find_if(std::begin(kKnown), std::end(kKnown), [&](const Known& each) { return each.name == type; });
  field.kind = known == std::end(kKnown) ? Kind::kNested : known->kind;
  field.size = known == std::end(kKnown) ? 0 : known->size;
  if (field.kind == Kind::kNested) field.nested = type;
  return field;
}

MessageShape MessageShape::parse(std::string_view definition) {
  if (definition.size() > kLongest) throw ShapeError("the definition of the message is longer than 256 KiB");
  MessageShape shape;
  std::vector<std::string> names{""};
  shape.types_.emplace_back();
  while (!definition.empty()) {
    std::string_view line = nextLine(definition);
    line = trimmed(line.substr(0, line.find('#')));
    if (line.starts_with("====")) continue;
    if (line.starts_with("MSG:")) {
      names.emplace_back(trimmed(line.substr(4)));
      shape.types_.emplace_back();
      continue;
    }
    const std::size_t space = line.find_first_of(" \t");
    if (line.empty() || line.find('=') != std::string_view::npos) continue;  // a constant
    if (space == std::string_view::npos)
      throw ShapeError("the definition of the message has a line '" + std::string(line.substr(0, 80)) + "'");
    shape.types_.back().push_back(fieldOf(line.substr(0, space), trimmed(line.substr(space))));
  }
  shape.resolve(names);
  shape.checkDepth(0, 0);
  return shape;
}

void MessageShape::resolve(const std::vector<std::string>& names) {
  for (Type& type : types_) {
    for (Field& field : type) {
      if (field.kind != Kind::kNested) continue;
      const auto found = std::find_if(names.begin() + 1, names.end(),
                                      [&](const std::string& name) { return isMeant(name, field.nested); });
      if (found == names.end()) throw ShapeError("the definition of the message lacks that of " + field.nested);
      field.size = static_cast<std::uint32_t>(found - names.begin());
    }
  }
}

void MessageShape::checkDepth(std::size_t type, int depth) const {
  if (depth > kDeepest) throw ShapeError("the definition of the message contains itself");
  for (const Field& field : types_[type]) {
    if (field.kind == Kind::kNested) checkDepth(field.size, depth + 1);
  }
}

bool MessageShape::skipOne(Cursor& cursor, const Field& field) noexcept {
  std::uint32_t length = field.size;
  return (field.kind != Kind::kText || cursor.length(length)) && cursor.skip(length);
}

bool MessageShape::skip(Cursor& cursor, const Field& field) const noexcept {
  std::uint32_t count = field.many ? field.count : 1;
  if (field.many && field.count == 0 && !cursor.length(count)) return false;
  if (field.kind != Kind::kText && field.kind != Kind::kNested) return cursor.skip(std::uint64_t{count} * field.size);
  const bool empty = field.kind == Kind::kNested && types_[field.size].empty();
  for (std::uint32_t i = 0; i < count && !empty; ++i) {
    if (!(field.kind == Kind::kText ? skipOne(cursor, field) : skip(cursor, types_[field.size]))) return false;
  }
  return !empty || count <= kLongest;
}

bool MessageShape::skip(Cursor& cursor, const Type& type) const noexcept {
  return std::all_of(type.begin(), type.end(), [&](const Field& field) { return skip(cursor, field); });
}

bool MessageShape::fits(std::span<const std::uint8_t> bytes) const noexcept {
  Cursor cursor(bytes);
  return skip(cursor, types_[0]) && cursor.atEnd();
}

namespace {

template <typename T>
double numberAt(const std::uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof(value));
  return static_cast<double>(value);
}

}  // namespace

Columns MessageShape::read(std::span<const std::uint8_t> bytes) const {
  if (!fits(bytes)) throw ShapeError("its bytes are no message of its type");
  Columns columns;
  Cursor cursor(bytes);
  for (const Field& field : types_[0]) {
    const bool plain = field.many && field.kind != Kind::kNested && field.kind != Kind::kTime;
    if (!plain) {
      skip(cursor, field);
      continue;
    }
    std::uint32_t count = field.count;
    if (count == 0) cursor.length(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint8_t* at = cursor.at();
      skipOne(cursor, field);
      if (field.kind == Kind::kText) {
        columns.texts[field.name].emplace_back(reinterpret_cast<const char*>(at) + 4,
                                               static_cast<std::size_t>(cursor.at() - at) - 4);
        continue;
      }
      auto& numbers = columns.numbers[field.name];
      const bool is_signed = field.kind == Kind::kInt;
      switch (field.size) {
        case 1: numbers.push_back(is_signed ? numberAt<std::int8_t>(at) : numberAt<std::uint8_t>(at)); break;
        case 2: numbers.push_back(is_signed ? numberAt<std::int16_t>(at) : numberAt<std::uint16_t>(at)); break;
        case 4:
          numbers.push_back(field.kind == Kind::kFloat ? numberAt<float>(at)
                            : is_signed                ? numberAt<std::int32_t>(at)
                                                       : numberAt<std::uint32_t>(at));
          break;
        default:
          numbers.push_back(field.kind == Kind::kFloat ? numberAt<double>(at)
                            : is_signed                ? numberAt<std::int64_t>(at)
                                                       : numberAt<std::uint64_t>(at));
      }
    }
  }
  return columns;
}

}  // namespace robotui::rt::ros_bridge
