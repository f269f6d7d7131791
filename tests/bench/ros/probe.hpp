// What publisher and subscriber share: the clock, the tag in each message, and how the subscriber paces the publisher.
#pragma once
#include <fcntl.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace probe {

enum Phase : char { WARM = 'w', MEASURED = 'm', END = 'e' };

// A tag is the phase, then the number and the time of the message as 16 hexadecimal digits each.
constexpr size_t TAG = 33;

inline int64_t now() {
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * 1000000000LL + time.tv_nsec;
}

inline void write_hex(uint64_t value, char* out) {
  for (int i = 15; i >= 0; i--, value >>= 4) out[i] = "0123456789abcdef"[value & 15];
}

inline uint64_t read_hex(const char* in) {
  uint64_t value = 0;
  for (int i = 0; i < 16; i++) value = value << 4 | (in[i] <= '9' ? in[i] - '0' : in[i] - 'a' + 10);
  return value;
}

inline void tag(std::string& text, Phase phase, uint64_t number, int64_t time) {
  text[0] = phase;
  write_hex(number, &text[1]);
  write_hex(time, &text[17]);
}

// A counter in a file that both map: how many messages reached the subscriber's callback.
class Credit {
 public:
  explicit Credit(const char* path) {
    int file = open(path, O_RDWR);
    void* memory = file < 0 ? MAP_FAILED : mmap(nullptr, 8, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED) throw std::runtime_error(std::string("cannot map ") + path);
    close(file);
    count_ = static_cast<std::atomic<uint64_t>*>(memory);
  }

  void set(uint64_t count) { count_->store(count, std::memory_order_release); }
  uint64_t get() const { return count_->load(std::memory_order_acquire); }

 private:
  std::atomic<uint64_t>* count_;
};

}  // namespace probe
