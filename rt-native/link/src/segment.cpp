#include "robotui/rt/link/segment.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::link {

namespace {

constexpr int kSizeSeals = F_SEAL_SHRINK | F_SEAL_GROW;

#ifndef F_SEAL_FUTURE_WRITE
constexpr int F_SEAL_FUTURE_WRITE = 0x0010;
#endif

const char* nameOf(SegmentKind kind) noexcept {
  switch (kind) {
    case SegmentKind::kState: return "state";
    case SegmentKind::kBoard: return "board";
    case SegmentKind::kHost: return "host";
    case SegmentKind::kMaster: return "master";
    case SegmentKind::kChannels: return "channels";
  }
  return "unknown";
}

[[noreturn]] void fail(SegmentKind kind, const std::string& what) {
  throw SegmentError(std::string("The ") + nameOf(kind) + " segment " + what);
}

[[noreturn]] void failWithErrno(SegmentKind kind, const std::string& what) {
  fail(kind, what + ": " + std::strerror(errno) + ".");
}

// Populated at once, so that no cycle pays for the first touch of a page.
void* map(const Descriptor& file, std::size_t size, bool writable, SegmentKind kind) {
  const int protection = writable ? PROT_READ | PROT_WRITE : PROT_READ;
  void* const data = ::mmap(nullptr, size, protection, MAP_SHARED | MAP_POPULATE, file.get(), 0);
  if (data == MAP_FAILED) failWithErrno(kind, "cannot be mapped");
  return data;
}

void checkFile(const Descriptor& file, SegmentKind kind, std::size_t size) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) failWithErrno(kind, "is no file");
  const int seals = ::fcntl(file.get(), F_GET_SEALS);
  if (seals < 0 || (seals & kSizeSeals) != kSizeSeals) fail(kind, "is not sealed against a change of its size.");
  if (static_cast<std::size_t>(status.st_size) != size) {
    fail(kind, "has " + std::to_string(status.st_size) + " bytes, but " + std::to_string(size) +
                   " were expected: it was written by another version, update both sides.");
  }
}

// A copy: the other process may change the header while it is looked at.
void checkHeader(const void* data, SegmentKind kind, std::size_t size) {
  Header header;
  std::memcpy(&header, data, sizeof(header));
  if (const std::string fault = faultOf(header, kind, size); !fault.empty()) fail(kind, fault);
}

}  // namespace

std::string faultOf(const Header& header, SegmentKind kind, std::size_t size) {
  if (header.magic != kMagic) return "does not begin with the mark of the link: it is something else.";
  if (header.version != kLayoutVersion) {
    return "has layout version " + std::to_string(header.version) + ", this program knows " +
           std::to_string(kLayoutVersion) + ": update the older of both.";
  }
  if (header.segment != static_cast<std::uint32_t>(kind))
    return "was expected, but a segment of kind " + std::to_string(header.segment) + " came.";
  if (header.size != size)
    return "says that it has " + std::to_string(header.size) + " bytes, not " + std::to_string(size) + ".";
  return {};
}

Mapping::Mapping(Mapping&& other) noexcept
    : file_(std::move(other.file_)), data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

Mapping& Mapping::operator=(Mapping&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

Mapping::~Mapping() {
  if (data_ != nullptr) ::munmap(data_, size_);
}

Mapping Mapping::create(SegmentKind kind, std::size_t size, std::uint32_t generation) {
  Descriptor file(::memfd_create(nameOf(kind), MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!file.isOpen()) failWithErrno(kind, "cannot be made");
  if (::ftruncate(file.get(), static_cast<off_t>(size)) != 0) failWithErrno(kind, "cannot be made that large");
  if (::fcntl(file.get(), F_ADD_SEALS, kSizeSeals) != 0) failWithErrno(kind, "cannot be sealed");
  void* const data = map(file, size, true, kind);
  const Header header{.magic = kMagic,
                      .version = kLayoutVersion,
                      .segment = static_cast<std::uint32_t>(kind),
                      .generation = generation,
                      .created_ns = now(),
                      .pid = ::getpid(),
                      .size = static_cast<std::uint32_t>(size)};
  std::memcpy(data, &header, sizeof(header));
  return Mapping(std::move(file), data, size);
}

Mapping Mapping::open(Descriptor file, SegmentKind kind, std::size_t size, bool writable) {
  checkFile(file, kind, size);
  void* const data = map(file, size, writable, kind);
  Mapping mapping(std::move(file), data, size);
  checkHeader(data, kind, size);
  return mapping;
}

Mapping Mapping::openAsItIs(Descriptor file, SegmentKind kind, std::size_t size) {
  checkFile(file, kind, size);
  void* const data = map(file, size, false, kind);
  return Mapping(std::move(file), data, size);
}

void Mapping::sealAgainstWriters() const {
  if (::fcntl(file_.get(), F_ADD_SEALS, F_SEAL_FUTURE_WRITE | F_SEAL_SEAL) != 0) {
    throw SegmentError(std::string("A segment cannot be sealed against writers: ") + std::strerror(errno) +
                       ". Linux 5.1 is needed.");
  }
}

// A duplicate would share the access mode; opening it anew does not.
Descriptor Mapping::share(bool writable) const {
  const std::string path = "/proc/self/fd/" + std::to_string(file_.get());
  Descriptor descriptor(::open(path.c_str(), (writable ? O_RDWR : O_RDONLY) | O_CLOEXEC));
  if (!descriptor.isOpen())
    throw SegmentError(std::string("A segment cannot be given away: ") + std::strerror(errno) + ".");
  return descriptor;
}

}  // namespace robotui::rt::link
