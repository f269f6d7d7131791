// Messages on their way to the control loop: decoded by an ordinary thread into messages that were made before, handed
// over without a lock.
#pragma once

#include <atomic>
#include <functional>
#include <utility>

#include <ros/serialization.h>
#include <ros/service_traits.h>

#include "robotui/rt/ros/announcement.h"

namespace robotui::rt::ros {

// A queue of objects that live as long as it does: one thread fills, one empties.
template <typename T>
class SlotQueue {
 public:
  SlotQueue(std::size_t slots, const T& prototype) : slots_(slots, prototype) {}

  // Where the next one is written, then push(); nullptr where the reader is behind.
  T* back() noexcept {
    return head_.load(std::memory_order_relaxed) - tail_.load(std::memory_order_acquire) == slots_.size() ? nullptr
                                                                                                          : &at(head_);
  }
  void push() noexcept { head_.store(head_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  // The next one to read, then pop(); nullptr where there is none.
  T* front() noexcept {
    return tail_.load(std::memory_order_relaxed) == head_.load(std::memory_order_acquire) ? nullptr : &at(tail_);
  }
  void pop() noexcept { tail_.store(tail_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

 private:
  T& at(const std::atomic<std::size_t>& place) noexcept {
    return slots_[place.load(std::memory_order_relaxed) % slots_.size()];
  }

  std::vector<T> slots_;
  std::atomic<std::size_t> head_{0};
  std::atomic<std::size_t> tail_{0};
};

class Inbox {
 public:
  virtual ~Inbox() = default;
  virtual void receive() = 0;  // in the ordinary thread
  virtual void execute() = 0;  // in the control loop
};

namespace detail {

// False where the bytes are no such message.
template <typename Message>
bool decode(std::span<const std::uint8_t> bytes, Message& into) {
  try {
    ::ros::serialization::IStream stream(const_cast<std::uint8_t*>(bytes.data()),
                                         static_cast<std::uint32_t>(bytes.size()));
    ::ros::serialization::deserialize(stream, into);
    return stream.getLength() == 0;
  } catch (const std::exception&) {
    return false;
  }
}

// Zero where it does not fit.
template <typename Message>
bool encode(const Message& message, PacketWriter& to, std::uint32_t number, std::uint64_t flags) noexcept {
  const std::uint32_t size = ::ros::serialization::serializationLength(message);
  if (size > to.room()) return false;
  to.write(size, number, flags, [&](std::uint8_t* into) {
    ::ros::serialization::OStream stream(into, size);
    ::ros::serialization::serialize(stream, message);
  });
  return true;
}

}  // namespace detail

template <typename Message>
class Subscription final : public Inbox {
 public:
  using Callback = std::function<void(const Message&)>;
  Subscription(PacketReader reader, std::uint64_t generation, std::size_t queue, const Message& prototype,
               Callback callback)
      : reader_(std::move(reader)), generation_(generation), messages_(queue, prototype),
        callback_(std::move(callback)) {}

  void receive() override {
    for (Message* message = messages_.back(); message != nullptr && reader_.next();) {
      if (reader_.flags() != generation_ || !detail::decode(reader_.bytes(), *message)) continue;
      messages_.push();
      message = messages_.back();
    }
  }
  void execute() override {
    for (Message* message = messages_.front(); message != nullptr; message = messages_.front()) {
      callback_(*message);
      messages_.pop();
    }
  }

 private:
  PacketReader reader_;
  std::uint64_t generation_;
  SlotQueue<Message> messages_;
  Callback callback_;
};

template <typename Service>
class Server final : public Inbox {
 public:
  using Callback = std::function<bool(const typename Service::Request&, typename Service::Response&)>;
  Server(PacketReader reader, PacketWriter writer, std::uint64_t generation, const Service& prototype,
         Callback callback)
      : reader_(std::move(reader)), writer_(std::move(writer)), generation_(generation),
        calls_(kCalls, Call{prototype, 0}), callback_(std::move(callback)) {}

  void receive() override {
    for (Call* call = calls_.back(); call != nullptr && reader_.next();) {
      if (reader_.flags() != generation_ || !detail::decode(reader_.bytes(), call->service.request)) continue;
      call->number = reader_.number();
      calls_.push();
      call = calls_.back();
    }
  }
  void execute() override {
    for (Call* call = calls_.front(); call != nullptr; call = calls_.front()) {
      const bool good = callback_(call->service.request, call->service.response);
      if (!good || !detail::encode(call->service.response, writer_, call->number, kSucceeded))
        writer_.write({}, call->number, 0);
      calls_.pop();
    }
  }

 private:
  static constexpr std::size_t kCalls = 8;
  struct Call {
    Service service;
    std::uint32_t number;
  };
  PacketReader reader_;
  PacketWriter writer_;
  std::uint64_t generation_;
  SlotQueue<Call> calls_;
  Callback callback_;
};

}  // namespace robotui::rt::ros
