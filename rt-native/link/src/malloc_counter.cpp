// Stands before the heap of the C library and counts, for the whole process.
#include <cerrno>
#include <cstddef>

#include "robotui/rt/link/allocations.h"

namespace {

void note() noexcept {
  auto& count = robotui::rt::link::allocationCount();
  count.calls += count.counting ? 1 : 0;
}

}  // namespace

#ifdef RT_SANITIZED  // a sanitizer has its own heap, which tells on demand

extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {

[[maybe_unused]] const int installed =
    __sanitizer_install_malloc_and_free_hooks([](const volatile void*, std::size_t) { note(); },
                                              [](const volatile void* old) {
                                                if (old != nullptr) note();
                                              });

}  // namespace

#else

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier): the names of the GNU C library
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* old);
// NOLINTEND(bugprone-reserved-identifier)

void* malloc(std::size_t size) {
  note();
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  note();
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
  note();
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  note();
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note();
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** into, std::size_t alignment, std::size_t size) {
  note();
  void* const made = __libc_memalign(alignment, size);
  if (made == nullptr) return ENOMEM;
  *into = made;
  return 0;
}

void free(void* old) {
  if (old != nullptr) note();
  __libc_free(old);
}

}  // extern "C"

#endif
