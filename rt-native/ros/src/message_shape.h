// The form of a message, from the definition that ROS gives with it: what bytes of another process are checked and read
// by.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace robotui::rt::ros_bridge {

class ShapeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The fields of the message itself that are arrays of numbers or of texts, by name; others are passed over.
struct Columns {
  std::map<std::string, std::vector<double>, std::less<>> numbers;
  std::map<std::string, std::vector<std::string>, std::less<>> texts;
};

class MessageShape {
 public:
  // `definition` is the whole text, with those of nested messages. Throws ShapeError where it is none.
  static MessageShape parse(std::string_view definition);

  // True where the bytes are one whole message: then no length in it is beyond them.
  bool fits(std::span<const std::uint8_t> bytes) const noexcept;

  // Throws ShapeError where they are not.
  Columns read(std::span<const std::uint8_t> bytes) const;

 private:
  enum class Kind : std::uint8_t { kInt, kUint, kFloat, kText, kTime, kNested };
  struct Field {
    std::string name;
    Kind kind = Kind::kInt;
    std::uint32_t size = 0;  // bytes of a number; of kNested the index in types_
    bool many = false;
    std::uint32_t count = 0;  // of an array of fixed size; else 0
    std::string nested;
  };
  using Type = std::vector<Field>;
  class Cursor;

  static Field fieldOf(std::string_view type, std::string_view name);
  void resolve(const std::vector<std::string>& names);
  void checkDepth(std::size_t type, int depth) const;
  bool skip(Cursor& cursor, const Type& type) const noexcept;
  bool skip(Cursor& cursor, const Field& field) const noexcept;
  static bool skipOne(Cursor& cursor, const Field& field) noexcept;

  std::vector<Type> types_;  // 0 is the message
};

}  // namespace robotui::rt::ros_bridge
