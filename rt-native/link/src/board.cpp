#include "robotui/rt/link/board.h"

#include <algorithm>
#include <cstring>

#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::link {

namespace {

static_assert(sizeof(BoardData) % sizeof(Word) == 0);

// Bytes of a character that begins before `end` and does not end there are left out.
std::size_t wholeCharacters(std::string_view text, std::size_t end) noexcept {
  if (end >= text.size()) return text.size();
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return end;
}

template <std::size_t N>
void assignTo(std::array<char, N>& into, std::string_view text) noexcept {
  const std::size_t length = wholeCharacters(text, N - 1);
  into.fill('\0');
  std::copy_n(text.begin(), length, into.begin());
}

template <std::size_t N>
std::string_view viewOf(const std::array<char, N>& text) noexcept {
  return {text.data(), static_cast<std::size_t>(std::find(text.begin(), text.end(), '\0') - text.begin())};
}

void bound(BoardData& data) noexcept {
  data.joints = std::min(data.joints, kMaxJoints);
  data.imus = std::min(data.imus, kMaxImus);
  data.force_torques = std::min(data.force_torques, kMaxForceTorques);
  data.hosts = std::min(data.hosts, kMaxHosts);
  data.plugins = std::min(data.plugins, kMaxPlugins);
}

}  // namespace

void assign(Name& into, std::string_view text) noexcept { assignTo(into, text); }
void assign(Text& into, std::string_view text) noexcept { assignTo(into, text); }
std::string_view view(const Name& name) noexcept { return viewOf(name); }
std::string_view view(const Text& text) noexcept { return viewOf(text); }

BoardWriter::BoardWriter(BoardSegment& segment) noexcept : segment_(&segment) {
  for (auto& owner : segment.owners) owner.store(kNobody, std::memory_order_relaxed);
}

void BoardWriter::publish() noexcept {
  lockedWrite(segment_->sequence, [&]() noexcept { relaxedCopyIn(&segment_->data, &data_, sizeof(data_)); });
}

void BoardWriter::grant(std::uint32_t joint, std::uint16_t plugin) noexcept {
  segment_->owners[joint].store(plugin, std::memory_order_relaxed);
  segment_->grants[joint].fetch_add(1, std::memory_order_release);
}

void BoardWriter::release(std::uint32_t joint) noexcept {
  segment_->owners[joint].store(kNobody, std::memory_order_release);
}

Read BoardReader::read(BoardData& into) noexcept {
  const std::uint64_t first = segment_->sequence.load(std::memory_order_acquire);
  if (first == 0) return Read::kNone;
  if (first == last_) return Read::kSame;
  for (int i = 0; i < kReadTries; ++i) {
    const std::uint64_t read =
        lockedRead(segment_->sequence, [&]() noexcept { relaxedCopyOut(&into, &segment_->data, sizeof(into)); });
    if (read == 0) continue;
    bound(into);
    last_ = read;
    return Read::kNew;
  }
  return Read::kBusy;
}

}  // namespace robotui::rt::link
