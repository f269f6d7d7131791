// A piece of shared memory: a sealed memory file, mapped by its writer, and read-only by all others.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "robotui/rt/link/descriptor.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt::link {

// A segment cannot be made or is not what it should be; a sentence for the user.
class SegmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class T>
struct SegmentTraits;
template <>
struct SegmentTraits<StateSegment> {
  static constexpr SegmentKind kind = SegmentKind::kState;
};
template <>
struct SegmentTraits<BoardSegment> {
  static constexpr SegmentKind kind = SegmentKind::kBoard;
};
template <>
struct SegmentTraits<HostSegment> {
  static constexpr SegmentKind kind = SegmentKind::kHost;
};
template <>
struct SegmentTraits<MasterSegment> {
  static constexpr SegmentKind kind = SegmentKind::kMaster;
};

// Empty, or what is wrong with a head, as words behind "The host segment".
std::string faultOf(const Header& header, SegmentKind kind, std::size_t size);

// Mapped memory of a file whose size is sealed: it can neither grow nor shrink under its readers.
class Mapping {
 public:
  Mapping() = default;
  Mapping(Mapping&& other) noexcept;
  Mapping& operator=(Mapping&& other) noexcept;
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  ~Mapping();

  static Mapping create(SegmentKind kind, std::size_t size, std::uint32_t generation);
  static Mapping open(Descriptor file, SegmentKind kind, std::size_t size, bool writable);
  static Mapping openAsItIs(Descriptor file, SegmentKind kind, std::size_t size);

  void* data() const noexcept { return data_; }
  void sealAgainstWriters() const;
  Descriptor share(bool writable) const;

 private:
  Mapping(Descriptor file, void* data, std::size_t size) noexcept : file_(std::move(file)), data_(data), size_(size) {}

  Descriptor file_;
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

// A segment of type T (StateSegment, ...): Segment<const T> is mapped read-only, a write through it is a SIGSEGV.
template <class T>
class Segment {
  using Plain = std::remove_const_t<T>;
  static constexpr bool kWritable = !std::is_const_v<T>;

 public:
  Segment() = default;  // no memory: only to be assigned

  // All zero behind the header. `generation` counts the processes that wrote this kind of segment.
  static Segment create(std::uint32_t generation) requires kWritable {
    return Segment(Mapping::create(SegmentTraits<Plain>::kind, sizeof(Plain), generation));
  }

  // Maps what another process gave away, after its seals, size and header were checked; throws SegmentError.
  static Segment open(Descriptor file) {
    return Segment(Mapping::open(std::move(file), SegmentTraits<Plain>::kind, sizeof(Plain), kWritable));
  }

  // The same of what a broken plugin may have overwritten: its head is not looked at. Who reads it checks what it reads
  // (host_damage.h), so that nobody is kept out by what stands there.
  static Segment openAsItIs(Descriptor file) requires(!kWritable) {
    return Segment(Mapping::openAsItIs(std::move(file), SegmentTraits<Plain>::kind, sizeof(Plain)));
  }

  T& operator*() const noexcept { return *get(); }
  T* operator->() const noexcept { return get(); }
  T* get() const noexcept { return static_cast<T*>(mapping_.data()); }
  explicit operator bool() const noexcept { return mapping_.data() != nullptr; }

  // From now on nobody can map it writable; maps that are writable now stay so. Called by the one writer once it has
  // mapped it.
  void sealAgainstWriters() const requires kWritable { mapping_.sealAgainstWriters(); }

  // A descriptor of its own to give away.
  Descriptor shareReadOnly() const { return mapping_.share(false); }
  Descriptor shareWritable() const requires kWritable { return mapping_.share(true); }

 private:
  explicit Segment(Mapping mapping) noexcept : mapping_(std::move(mapping)) {}

  Mapping mapping_;
};

}  // namespace robotui::rt::link
