# What all targets of rt-native have in common.
set(RT_SANITIZE "" CACHE STRING "sanitizers of a test build, such as address,undefined or thread")
option(RT_WERROR "warnings are errors" ON)

add_library(rt_options INTERFACE)
set_target_properties(rt_options PROPERTIES EXPORT_NAME options)
target_compile_features(rt_options INTERFACE cxx_std_20)
target_compile_options(rt_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast $<$<BOOL:${RT_WERROR}>:-Werror>)
# GCC 12 sees overlapping copies in "text" + std::string where it inlines as much as -O3 does (its bug 105651): there are none.
set(RT_INLINING_GCC12 $<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>)
target_compile_options(rt_options INTERFACE $<${RT_INLINING_GCC12}:-Wno-restrict>)
if(RT_SANITIZE)
  # Of what debuggers are told a report needs the lines alone, which compile sooner.
  target_compile_options(rt_options INTERFACE -fsanitize=${RT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
  target_link_options(rt_options INTERFACE -fsanitize=${RT_SANITIZE})
else()
  target_compile_options(rt_options INTERFACE $<$<CONFIG:RelWithDebInfo>:-D_FORTIFY_SOURCE=2>)
  if(BUILD_TESTING)
    # As above; who builds without tests, as ./robotui does, gets all.
    target_compile_options(rt_options INTERFACE $<$<CONFIG:RelWithDebInfo>:-g1>)
  endif()
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

# Below the prefix of `cmake --install`: programs look for plugins in this folder of libraries, and for theirs, too.
set(RT_INSTALL_LIBRARIES lib/robotui-rt)
set(RT_INSTALL_HEADERS include/robotui-rt)
set(CMAKE_INSTALL_RPATH $ORIGIN $ORIGIN/../${RT_INSTALL_LIBRARIES})

# rt_library(NAME SOURCES ... LINKS ...): rt::NAME, its headers in NAME/include. Without sources it is headers alone.
function(rt_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(headers $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${RT_INSTALL_HEADERS}>)
  if(arg_SOURCES)
    add_library(rt_${name} STATIC ${arg_SOURCES})
    target_include_directories(rt_${name} PUBLIC ${headers} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
    target_link_libraries(rt_${name} PUBLIC ${arg_LINKS} PRIVATE rt_options ${arg_PRIVATE_LINKS})
  else()
    add_library(rt_${name} INTERFACE)
    target_include_directories(rt_${name} INTERFACE ${headers})
    target_link_libraries(rt_${name} INTERFACE ${arg_LINKS})
  endif()
  target_compile_features(rt_${name} INTERFACE cxx_std_20)
  set_target_properties(rt_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(rt::${name} ALIAS rt_${name})
endfunction()

# What nearly every test of ours includes is compiled once for all of them: it takes longer than most tests themselves. Plugins of others have few tests.
function(rt_test_headers)
  if(NOT TARGET rt_test_headers)
    add_executable(rt_test_headers ${PROJECT_SOURCE_DIR}/tests/support/precompiled.cpp)
    target_link_libraries(rt_test_headers PRIVATE rt_options GTest::gtest_main)
    target_precompile_headers(rt_test_headers PRIVATE <gtest/gtest.h> <algorithm> <array> <atomic> <chrono> <cmath> <filesystem> <fstream> <functional>
                              <map> <memory> <mutex> <optional> <set> <sstream> <string> <thread> <variant> <vector>)
  endif()
endfunction()

# rt_test(NAME SOURCES ... LINKS ... [TIMEOUT SECONDS]): one GoogleTest program, known to ctest test by test.
function(rt_test name)
  cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;LINKS" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE rt_options ${arg_LINKS} GTest::gtest_main)
  if(EXISTS ${PROJECT_SOURCE_DIR}/tests/support/precompiled.cpp)
    rt_test_headers()
    # GCC 12 warns of what it inlines of precompiled headers as if it were ours: of copies beyond the ends of texts, as it does elsewhere. There are none.
    target_compile_options(${name} PRIVATE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow>)
    target_precompile_headers(${name} REUSE_FROM rt_test_headers)
  endif()
  include(GoogleTest)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS ${folder})
endfunction()

# rt_plugin(NAME SOURCES ... [TEST ...] [LINKS ...] [ALSO_NAMED ...] [FOR_TESTS]): libNAME.so, which robotui-rt-host loads, and a test of it that is built
# from the same sources. It is installed where hosts look for it, unless it is there for tests alone. Its symbols may not be unique in the
# process: such a library could not be unloaded, and so not reloaded.
function(rt_plugin name)
  cmake_parse_arguments(arg "FOR_TESTS" "" "SOURCES;TEST;LINKS;ALSO_NAMED" ${ARGN})
  add_library(${name} MODULE ${arg_SOURCES})
  target_compile_options(${name} PRIVATE -fno-gnu-unique -fvisibility=hidden)
  target_link_libraries(${name} PRIVATE rt_options rt::plugin ${arg_LINKS})
  if(NOT arg_FOR_TESTS)
    install(TARGETS ${name} LIBRARY DESTINATION ${RT_INSTALL_LIBRARIES})
  endif()
  foreach(other ${arg_ALSO_NAMED})
    file(MAKE_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
    file(CREATE_LINK lib${name}.so ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/lib${other}.so SYMBOLIC)
    install(FILES ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/lib${other}.so DESTINATION ${RT_INSTALL_LIBRARIES})
  endforeach()
  if(BUILD_TESTING AND arg_TEST)
    rt_test(${name}_test SOURCES ${arg_TEST} ${arg_SOURCES} LINKS rt::testing rt::malloc_counter ${arg_LINKS})
  endif()
endfunction()
