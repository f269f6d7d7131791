// What a channel carries, in words that both ends state: a name and a version, whatever compiler made them.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace robotui::rt {

// Say it in the type that passes through the channel, and give another version to every change of what its bytes mean:
//   struct Contact {
//     static constexpr Schema kSchema{"mylab/contact", 1};
//     double force;  // N
//   };
struct Schema {
  std::string_view name;  // 1 to 63 bytes
  std::uint32_t version;
};

// Numbers have a schema of their own; for a type of another library specialise this.
template <typename T>
struct SchemaOf;
template <typename T>
requires requires { T::kSchema.version; }
struct SchemaOf<T> {
  static constexpr Schema value = T::kSchema;
};
template <>
struct SchemaOf<bool> {
  static constexpr Schema value{"bool", 1};
};
template <>
struct SchemaOf<std::int32_t> {
  static constexpr Schema value{"int32", 1};
};
template <>
struct SchemaOf<std::uint32_t> {
  static constexpr Schema value{"uint32", 1};
};
template <>
struct SchemaOf<std::int64_t> {
  static constexpr Schema value{"int64", 1};
};
template <>
struct SchemaOf<std::uint64_t> {
  static constexpr Schema value{"uint64", 1};
};
template <>
struct SchemaOf<float> {
  static constexpr Schema value{"float32", 1};
};
template <>
struct SchemaOf<double> {
  static constexpr Schema value{"float64", 1};
};

// Bytes that may pass between processes, and a schema that says what they are.
template <typename T>
concept ChannelValue = std::is_trivially_copyable_v<T> && requires {
  SchemaOf<T>::value.version;
};

}  // namespace robotui::rt
