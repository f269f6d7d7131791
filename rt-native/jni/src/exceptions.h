// C++ exceptions must not leave native methods: Java gets an IOException with the same sentence.
#pragma once

#include <exception>
#include <type_traits>

#include <jni.h>

namespace robotui::rt::jni {

void throwIoException(JNIEnv* env, const char* sentence);

// Runs it; where it throws, Java's exception is pending and the result is zero.
template <class F>
auto guarded(JNIEnv* env, F&& run) -> std::invoke_result_t<F> {
  using Result = std::invoke_result_t<F>;
  try {
    return run();
  } catch (const std::exception& e) {
    throwIoException(env, e.what());
  } catch (...) {
    throwIoException(env, "the native link failed");
  }
  if constexpr (!std::is_void_v<Result>) {
    return Result{};
  }
}

}  // namespace robotui::rt::jni
