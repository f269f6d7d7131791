// The objects of a simulated drive, and what SDO asks of them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "../frame.h"
#include "../objects.h"

namespace robotui::rt::hal::canopen::simulated {

// Objects of at most four bytes, as most drives have them: PDOs are changed only while they are switched off.
class Dictionary {
 public:
  explicit Dictionary(std::uint8_t node);

  std::uint32_t get(Object object) const noexcept;  // 0 where there is none
  void set(Object object, std::uint32_t value) noexcept;
  std::size_t sizeOf(Object object) const noexcept;  // bytes; 0 where there is none
  void remove(Object object) { entries_.erase(keyOf(object)); }

  // The answer to a request of SDO, of this node.
  Frame answer(const Frame& request);

 private:
  enum class Access : std::uint8_t { kRead, kWrite };
  struct Entry {
    std::uint8_t size;
    Access access;
    std::uint32_t value;
  };
  static std::uint32_t keyOf(Object object) noexcept { return std::uint32_t{object.index} << 8U | object.sub; }
  void add(Object object, std::size_t size, Access access, std::uint32_t value = 0);
  void addPdos();
  void addDrive();
  std::uint32_t write(Object object, std::size_t size, std::uint32_t value);
  std::uint32_t objection(Object object, std::uint32_t value) const;
  std::uint32_t objectionToMapping(Object object, std::uint32_t value) const;

  std::uint8_t node_;
  std::map<std::uint32_t, Entry> entries_;
};

}  // namespace robotui::rt::hal::canopen::simulated
