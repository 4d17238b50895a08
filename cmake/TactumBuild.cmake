# How everything is compiled, and the two functions that make the rooms of the house.

option(TACTUM_TESTS "Build the tests" ON)
option(TACTUM_NATIVE "Compile for the processor of this machine" OFF)
set(TACTUM_UNITY_BATCH 8 CACHE STRING "How many sources of a target are compiled as one: three times as fast; 0: each alone")
option(TACTUM_FUZZ "Build the core and tests/fuzz alone, by clang" OFF)
set(TACTUM_SANITIZE "" CACHE STRING "A sanitizer: address, undefined or thread")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# "Check" is what the tests run: optimised, so that 10^6 haptic steps take seconds, but with assertions, also of what is looked up
# beyond the end of an array or in an optional that is empty.
set(CMAKE_CXX_FLAGS_CHECK "-O2 -g1 -D_GLIBCXX_ASSERTIONS" CACHE STRING "" FORCE)
set(CMAKE_C_FLAGS_CHECK "-O2 -g1" CACHE STRING "" FORCE)
# The rooms of a haptic step ask for more (TACTUM_STEP_ROOMS): the others gain nothing and build a sixth longer.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "" FORCE)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Check CACHE STRING "" FORCE)
endif()

# With it or without it the compiler is told the same: what builds here builds elsewhere. It looks into precompiled headers when
# it is told that they say all, and when g++ shows them in what it preprocesses.
find_program(CCACHE ccache)
if(CCACHE)
  set(launcher "${CMAKE_COMMAND}" -E env "CCACHE_SLOPPINESS=pch_defines,time_macros" "${CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>)
endif()

# It links in a fifth of the time.
find_program(LLD ld.lld)
if(LLD AND NOT TACTUM_SANITIZE)
  add_link_options(-fuse-ld=lld)
endif()

# Everywhere, as gRPC has it: what is precompiled is so for one set of options.
add_compile_options(-pthread)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
# tl::expected: the Result type. A header; Debian ships no CMake package that all versions agree on.
find_path(TL_EXPECTED_INCLUDE tl/expected.hpp REQUIRED)

add_library(tactum_options INTERFACE)
target_compile_options(tactum_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor $<$<CXX_COMPILER_ID:GNU>:-Werror>
  # g++ 12 sees overlapping copies in its own std::string when it inlines them at -O3.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # At -O3 it also misses that an std::optional's value is not read while there is none. "Check" still warns.
  $<$<CONFIG:Release>:-Wno-maybe-uninitialized>
  # One multiplication and one addition are two roundings: the compiler fuses none. Eigen does where the processor is known
  # to, in the products of its matrices, so that a native build differs from a portable one in the last place of some forces.
  # Recordings and expected forces are those of portable builds.
  -ffp-contract=off)
if(TACTUM_NATIVE)
  # g++ 12 takes the undefined lanes in its own AVX-512 headers for a mistake of ours.
  target_compile_options(tactum_options INTERFACE -march=native -Wno-maybe-uninitialized -Wno-uninitialized)
endif()
if(TACTUM_SANITIZE)
  # In instrumented code gcc sees uninitialised values where there are none, in the standard library too.
  target_compile_options(tactum_options INTERFACE -Wno-maybe-uninitialized)
  add_compile_options(-fsanitize=${TACTUM_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TACTUM_SANITIZE})
  if(TACTUM_SANITIZE STREQUAL "thread")
    add_compile_options(-Wno-tsan) # of fences in Boost, which are not ours
  endif()
  if(TACTUM_SANITIZE STREQUAL "undefined")
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
endif()

if(TACTUM_FUZZ)
  # Every branch reports where it went, and every fault ends the program. Warnings are g++'s business. Four kinds of
  # undefined behaviour are left to the address sanitizer and the preset ubsan: they are a quarter of the compiler's time.
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize=null,object-size,vptr,alignment -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# tactum_headers(NAME LINKS library... HEADERS <header>... [OPTIONS option...])
# Headers that most sources want, compiled once for all targets that tactum_unity() gives them to: targets with these OPTIONS.
function(tactum_headers name)
  cmake_parse_arguments(H "" "" "LINKS;HEADERS;OPTIONS" ${ARGN})
  set(nothing "${CMAKE_BINARY_DIR}/nothing.cpp")
  file(CONFIGURE OUTPUT "${nothing}" CONTENT "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL "${nothing}")
  target_link_libraries(${name} PRIVATE tactum_options ${H_LINKS})
  target_compile_options(${name} PRIVATE ${H_OPTIONS})
  if(TACTUM_UNITY_BATCH)
    target_precompile_headers(${name} PRIVATE ${H_HEADERS})
  endif()
endfunction()

# tactum_precompiled(TARGET HEADERS): a target reads those of tactum_headers(HEADERS ...).
function(tactum_precompiled target headers)
  if(TACTUM_UNITY_BATCH)
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
endfunction()

# tactum_unity(TARGET [HEADERS]): compiles the sources of a target TACTUM_UNITY_BATCH at a time, with the headers of
# tactum_headers(HEADERS ...): most of the time of a source goes into the headers and templates that its neighbours want
# too (docs/decisions/build.md has the figures). With each alone an include that is missing is seen.
function(tactum_unity target)
  if(TACTUM_UNITY_BATCH)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${TACTUM_UNITY_BATCH})
    # a type of a source may have members of types that only this source knows
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
  if(ARGN)
    tactum_precompiled(${target} ${ARGN})
  endif()
endfunction()

set(core_headers LINKS Eigen3::Eigen Threads::Threads
  HEADERS <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <atomic> <charconv> <chrono> <cmath> <filesystem> <functional> <limits>
    <map> <memory> <numeric> <optional> <span> <string> <string_view> <tl/expected.hpp> <tuple> <utility> <variant> <vector>)
# The rooms of a haptic step, where every microsecond counts, are compiled by -O3 in the release build, and headers for them, too:
# g++ keeps for a function the options that it was precompiled by, and of -O2 in -O3 nearly all of Eigen stays calls.
set(TACTUM_STEP_ROOMS geometry collision surface paint dynamics proxy haptics safety runtime)
tactum_headers(tactum_core_headers ${core_headers})
tactum_headers(tactum_step_headers ${core_headers} OPTIONS -O3)
foreach(headers tactum_core_headers tactum_step_headers)
  target_include_directories(${headers} SYSTEM PRIVATE "${TL_EXPECTED_INCLUDE}")
endforeach()

# tactum_room(NAME SOURCES ... USES room ... PRIVATE library ... [HEADERS <header>... | READS headers])
# One folder, one target. USES are other rooms, seen by whoever uses this one; PRIVATE are outside
# libraries, which nobody else sees. HEADERS are precompiled for this room instead of those of the core; READS names those
# of tactum_headers() that it shares with other rooms.
function(tactum_room name)
  cmake_parse_arguments(ROOM "" "READS" "SOURCES;USES;PRIVATE;HEADERS" ${ARGN})
  set(target tactum_${name})
  if(ROOM_SOURCES)
    add_library(${target} STATIC ${ROOM_SOURCES})
    if(ROOM_HEADERS)
      tactum_unity(${target})
      target_precompile_headers(${target} PRIVATE ${ROOM_HEADERS})
    elseif(ROOM_READS)
      tactum_unity(${target} ${ROOM_READS})
    elseif(name IN_LIST TACTUM_STEP_ROOMS AND CMAKE_BUILD_TYPE STREQUAL "Release")
      target_compile_options(${target} PRIVATE -O3)
      tactum_unity(${target} tactum_step_headers)
    else()
      tactum_unity(${target} tactum_core_headers)
    endif()
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:tactum_options>)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>")
  foreach(other IN LISTS ROOM_USES)
    target_link_libraries(${target} ${scope} tactum_${other})
  endforeach()
  if(ROOM_PRIVATE)
    target_link_libraries(${target} PRIVATE ${ROOM_PRIVATE})
  endif()
endfunction()
