# The functions that make test programs: one for each room, with all of its tests in it.

find_package(Qt6 6.4 REQUIRED COMPONENTS Test)

# moc for the tests of a program, which reads nothing but the test: AUTOMOC makes it read every include of it, a second and
# a half for each of forty programs.
function(tactum_moc program)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/${program}_autogen/include")
  foreach(name IN LISTS ARGN)
    set(made "${folder}/test_${name}.moc")
    add_custom_command(OUTPUT "${made}" DEPENDS "test_${name}.cpp"
      COMMAND Qt6::moc -o "${made}.new" "${CMAKE_CURRENT_SOURCE_DIR}/test_${name}.cpp"
      COMMAND "${CMAKE_COMMAND}" -E copy_if_different "${made}.new" "${made}"
      COMMENT "moc test_${name}.cpp" VERBATIM)
    target_sources(${program} PRIVATE "${made}")
  endforeach()
  target_include_directories(${program} BEFORE PRIVATE "${folder}")
endfunction()

# Qt Test without the folder of each test in its options (QFINDTESTDATA): all of them can share precompiled headers.
add_library(tactum_qt_test INTERFACE)
target_link_libraries(tactum_qt_test INTERFACE Qt6::Core $<LINK_ONLY:Qt6::Test>)
target_include_directories(tactum_qt_test SYSTEM INTERFACE $<TARGET_PROPERTY:Qt6::Test,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_definitions(tactum_qt_test INTERFACE QT_TESTLIB_LIB)

# Pictures without windows, likewise without what it defines: Qt Test looks different where that is.
find_package(Qt6 6.4 REQUIRED COMPONENTS Gui)
add_library(tactum_qt_gui INTERFACE)
target_link_libraries(tactum_qt_gui INTERFACE $<LINK_ONLY:Qt6::Gui>)
target_include_directories(tactum_qt_gui SYSTEM INTERFACE $<TARGET_PROPERTY:Qt6::Gui,INTERFACE_INCLUDE_DIRECTORIES>)

# What tests read besides: Qt Test looks different where there are windows.
set(headers <Eigen/Core> <Eigen/Geometry> <QTest> <QTemporaryDir> <QFile> <algorithm> <array> <atomic> <chrono> <cmath> <filesystem>
  <fstream> <functional> <map> <memory> <numbers> <optional> <random> <span> <sstream> <string> <thread> <tl/expected.hpp>
  <variant> <vector>)
find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets)
tactum_headers(tactum_test_headers LINKS tactum_base tactum_qt_test HEADERS ${headers})
tactum_headers(tactum_window_test_headers LINKS tactum_base tactum_qt_test Qt6::Widgets HEADERS ${headers} <QtWidgets>)

# What tests do themselves takes little of their time: optimising it less saves a fifth of the compiler's.
foreach(target tactum_test_headers tactum_window_test_headers)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Check>:-O1>)
endforeach()

# tactum_as_tests(TARGET HEADERS): compiled as tests are, with the headers of tactum_headers(HEADERS ...).
function(tactum_as_tests target headers)
  target_link_libraries(${target} PRIVATE tactum_qt_test) # what its headers were compiled with
  tactum_precompiled(${target} ${headers})
  # g++ 12 forgets that a precompiled header is the system's, and sees copies beyond a short std::string in it.
  target_compile_options(${target} PRIVATE -fPIC $<$<CONFIG:Check>:-O1>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
endfunction()

# What a test program has besides its tests: main(), which runs the one that it is asked for, and comparisons.
add_library(tactum_test_program OBJECT
  "${PROJECT_SOURCE_DIR}/tests/support/test_program.cpp" "${PROJECT_SOURCE_DIR}/tests/support/compare.cpp"
  "${PROJECT_SOURCE_DIR}/tests/support/as_shown.cpp")
target_include_directories(tactum_test_program PUBLIC "${PROJECT_SOURCE_DIR}")
target_link_libraries(tactum_test_program PRIVATE tactum_options PUBLIC tactum_base tactum_qt_test)
tactum_as_tests(tactum_test_program tactum_test_headers)

# tactum_tests(ROOM TESTS name... [SOURCES file...] [BARE file...] [USES room...] [LINKS target...] [DEFINES macro=value...]
#              [GUI name...] [COARSE name...] [LONG name...] [LOOPS name...] [ALONE name...] [LABELS label...] [PROGRAM name] [UNDER program] [SUFFIX text])
# One program with tests/ROOM/test_name.cpp for each name, and a CTest test `test_name` for each, which runs alone in a
# process of its own. Labels: the room, for ./check ROOM; `gui` has a screen of its own; `long` is for ./check --all.
# SOURCES: what its tests share; BARE: what defines malloc() or open() for the whole program, and is compiled by itself.
# COARSE: half the device pixels each way, where nobody looks at them: a quarter of what the processor draws.
# LOOPS: see tactum_loops(). ALONE: nothing else runs beside it.
# PROGRAM: the room's second program, where one has to be linked differently. UNDER: what starts it. SUFFIX: goes on the
# names of tests that run a second time.
function(tactum_tests room)
  cmake_parse_arguments(T "" "PROGRAM;UNDER;SUFFIX" "TESTS;SOURCES;BARE;USES;LINKS;DEFINES;GUI;COARSE;LONG;LOOPS;ALONE;LABELS" ${ARGN})
  string(REPLACE "/" "-" folder "${room}")
  if(T_PROGRAM)
    set(program "${T_PROGRAM}-tests")
  else()
    set(program "${folder}-tests")
  endif()
  set(sources ${T_SOURCES} ${T_BARE})
  foreach(name IN LISTS T_TESTS)
    list(APPEND sources "test_${name}.cpp")
  endforeach()

  set_source_files_properties(${T_BARE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
  add_executable(${program} ${sources})
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  tactum_moc(${program} ${T_TESTS})
  tactum_unity(${program})
  if(room MATCHES "^ui" OR T_USES MATCHES "(^|;)ui_")
    tactum_as_tests(${program} tactum_window_test_headers)
  else()
    tactum_as_tests(${program} tactum_test_headers)
  endif()
  target_compile_definitions(${program} PRIVATE ${T_DEFINES})
  target_link_libraries(${program} PRIVATE tactum_options tactum_test_program ${T_LINKS})
  foreach(other IN LISTS T_USES)
    target_link_libraries(${program} PRIVATE tactum_${other})
  endforeach()
  if(NOT TARGET tests-${folder})
    add_custom_target(tests-${folder}) # what ./check ROOM builds
  endif()
  add_dependencies(tests-${folder} ${program})

  foreach(name IN LISTS T_TESTS)
    set(test test_${name}${T_SUFFIX})
    set(command COMMAND ${T_UNDER} $<TARGET_FILE:${program}> test_${name})
    if(name IN_LIST T_GUI)
      tactum_gui_ctest(${test} ROOM ${room} LABELS ${T_LABELS} ${command})
    else()
      tactum_ctest(${test} ROOM ${room} LABELS ${T_LABELS} ${command})
    endif()
    if(name IN_LIST T_COARSE)
      set_property(TEST ${test} APPEND PROPERTY ENVIRONMENT QT_SCALE_FACTOR=0.5)
    endif()
    if(name IN_LIST T_LONG)
      set_property(TEST ${test} APPEND PROPERTY LABELS long)
      if(NOT name IN_LIST T_GUI)
        set_property(TEST ${test} PROPERTY COST 100)
      endif()
    endif()
    if(name IN_LIST T_LOOPS)
      tactum_loops(${test})
    endif()
    if(name IN_LIST T_ALONE)
      set_property(TEST ${test} PROPERTY RUN_SERIAL ON)
    endif()
  endforeach()
endfunction()

# tactum_ctest(NAME ROOM room COMMAND words... [LABELS label...]): a test of a room that is no class of Qt Test.
# TACTUM_BUSY: other tests run beside it, so that it judges no time (tests/support/quiet.h).
function(tactum_ctest name)
  cmake_parse_arguments(T "" "ROOM" "COMMAND;LABELS" ${ARGN})
  add_test(NAME ${name} COMMAND ${T_COMMAND})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600 LABELS "${T_ROOM};${T_LABELS}" ENVIRONMENT "TACTUM_BUSY=1")
endfunction()

# tactum_loops(NAME): runs in real time and mostly waits, so that ./check runs it after all others, twice as many at a time.
function(tactum_loops test)
  set_property(TEST ${test} APPEND PROPERTY LABELS loops)
  set_property(TEST ${test} PROPERTY COST -1)
endfunction()

# tactum_gui_ctest(NAME ROOM room COMMAND words... [LABELS label...] [ENVIRONMENT variable=value...]): as tactum_ctest, of a
# test that shows windows: on a screen of its own.
function(tactum_gui_ctest test)
  cmake_parse_arguments(T "" "ROOM" "COMMAND;LABELS;ENVIRONMENT" ${ARGN})
  tactum_ctest(${test} ROOM ${T_ROOM} LABELS ${T_LABELS} gui
    COMMAND "${PROJECT_SOURCE_DIR}/tests/support/on_a_screen" ${T_COMMAND})
  set_property(TEST ${test} PROPERTY COST 200) # first, for the last of them ends the run
  # Settings of its own: a test neither reads nor changes the person's, or those of another one beside it.
  set_property(TEST ${test} APPEND PROPERTY
    ENVIRONMENT "QT_QPA_PLATFORM=xcb" "XDG_CONFIG_HOME=${CMAKE_BINARY_DIR}/settings/${test}"
    "MESA_SHADER_CACHE_DIR=${CMAKE_BINARY_DIR}/shaders" # one for all, wherever a test puts its folders
    # Drawing without a graphics card in the thread that asks for it, as fast as with one of its own: docs/testing.md
    "LP_NUM_THREADS=0"
    ${T_ENVIRONMENT})
endfunction()

# tactum_quiet_test(ROOM NAME [PROGRAM name] FUNCTIONS function...): functions of a test of the room that judge the
# processor, run once more by ./check --all where nothing else runs. PROGRAM: as in tactum_tests.
function(tactum_quiet_test room name)
  cmake_parse_arguments(T "" "PROGRAM" "FUNCTIONS" ${ARGN})
  if(NOT T_PROGRAM)
    string(REPLACE "/" "-" T_PROGRAM "${room}")
  endif()
  add_test(NAME test_${name}_quiet COMMAND ${T_PROGRAM}-tests test_${name} ${T_FUNCTIONS})
  set_tests_properties(test_${name}_quiet PROPERTIES TIMEOUT 600 RUN_SERIAL ON LABELS "${room};quiet")
endfunction()

# tactum_tool(NAME SOURCES file... [USES room...] [LINKS target...]): a program for people, see tactum-tools. It may use
# what tests do.
function(tactum_tool name)
  cmake_parse_arguments(T "" "" "SOURCES;USES;LINKS" ${ARGN})
  add_executable(${name} EXCLUDE_FROM_ALL ${T_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE tactum_options ${T_LINKS})
  if("window_fixture" IN_LIST T_LINKS)
    tactum_as_tests(${name} tactum_window_test_headers)
  else()
    tactum_as_tests(${name} tactum_test_headers)
  endif()
  foreach(room IN LISTS T_USES)
    target_link_libraries(${name} PRIVATE tactum_${room})
  endforeach()
  add_dependencies(tactum-tools ${name})
endfunction()
