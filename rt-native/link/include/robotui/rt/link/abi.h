// What a library and the program that loads it must have in common, before one may hand objects of C++ to the other.
// Both state it in plain data of C, which can be read whatever the other one was built with.
#pragma once

#include <cstdint>
#include <string>

namespace robotui::rt::link {

// One thing that both sides must agree on: its value is `before`, the number, `behind`.
struct AbiFact {
  const char* name;  // "compiler"; nullptr ends a list
  const char* before;
  std::uint64_t number;
  const char* behind;
  const char* remedy;  // words behind "Build it again "
};

// Empty, or a sentence that names both sides of the first difference and the remedy. `library` is what is said of whom;
// both lists end with a fact without a name.
std::string abiDifference(const std::string& library, const AbiFact* has, const AbiFact* wants);

}  // namespace robotui::rt::link

#if defined(__clang__)
#define ROBOTUI_RT_COMPILER "Clang ", __clang_major__
#elif defined(__GNUC__)
#define ROBOTUI_RT_COMPILER "GCC ", __GNUC__
#else
#error "robotui-rt is built with GCC or Clang."
#endif

#if defined(_LIBCPP_VERSION)
#define ROBOTUI_RT_STANDARD_LIBRARY "libc++ ", _LIBCPP_VERSION / (_LIBCPP_VERSION < 100000 ? 1000 : 10000)
#else
#define ROBOTUI_RT_STANDARD_LIBRARY "libstdc++ ", _GLIBCXX_RELEASE
#endif

#if defined(_GLIBCXX_USE_CXX11_ABI)
#define ROBOTUI_RT_STRING_ABI _GLIBCXX_USE_CXX11_ABI
#else
#define ROBOTUI_RT_STRING_ABI 1
#endif

#if defined(_GLIBCXX_DEBUG)
#define ROBOTUI_RT_DEBUG_CONTAINERS 1
#else
#define ROBOTUI_RT_DEBUG_CONTAINERS 0
#endif

// The size of a type that both sides know.
#define ROBOTUI_RT_SIZE_OF(Type) \
  robotui::rt::link::AbiFact { "sizeof(" #Type ")", "", sizeof(Type), " bytes", "with the headers of this program." }

// clang-format off
// What the compiler was told in the source file that these words stand in: a list that must not be shared between source files.
#define ROBOTUI_RT_TOOLCHAIN_FACTS                                                                                        \
  robotui::rt::link::AbiFact{"compiler", ROBOTUI_RT_COMPILER, "", "with the compiler of this program."},                  \
      robotui::rt::link::AbiFact{"C++ standard", "", __cplusplus, "", "with the same option -std."},                      \
      robotui::rt::link::AbiFact{"standard library", ROBOTUI_RT_STANDARD_LIBRARY, "",                                     \
                                 "with the standard library of this program."},                                           \
      robotui::rt::link::AbiFact{"_GLIBCXX_USE_CXX11_ABI", "", ROBOTUI_RT_STRING_ABI, "",                                 \
                                 "with the same _GLIBCXX_USE_CXX11_ABI."},                                                \
      robotui::rt::link::AbiFact{"_GLIBCXX_DEBUG", "", ROBOTUI_RT_DEBUG_CONTAINERS, "", "with the same _GLIBCXX_DEBUG."}
// clang-format on
