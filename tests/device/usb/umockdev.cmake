# The cross-check: the same bus shown to libusb by umockdev, which emulates sysfs, udev and the device node
# independently of us. It goes without: where umockdev is missing, nothing but the second look is.
pkg_check_modules(UMOCKDEV QUIET IMPORTED_TARGET umockdev-1.0)
find_program(UMOCKDEV_WRAPPER umockdev-wrapper)
set(umockdev_missing "")
if(NOT UMOCKDEV_FOUND OR NOT UMOCKDEV_WRAPPER)
  set(umockdev_missing "libumockdev-dev and umockdev are not installed")
elseif(TACTUM_SANITIZE MATCHES "address|thread")
  set(umockdev_missing "this sanitizer has to be loaded before anything else, and so has umockdev")
endif()
if(umockdev_missing)
  message(STATUS "The USB cross-check by umockdev is left out: ${umockdev_missing}")
else()
  add_library(umockdev_usb OBJECT pty_node.cpp umockdev_bus.cpp umockdev_file.cpp)
  target_include_directories(umockdev_usb PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(umockdev_usb PRIVATE tactum_options PUBLIC PkgConfig::UMOCKDEV)
endif()

# usb_tests_under_umockdev(ROOM TESTS name... USES room... LINKS target...): tests of the room once more, over umockdev,
# as test_name_umockdev. A socket's path has room for some hundred letters: the short TMPDIR.
function(usb_tests_under_umockdev room)
  if(NOT TARGET umockdev_usb)
    return()
  endif()
  cmake_parse_arguments(T "" "" "TESTS;USES;LINKS" ${ARGN})
  string(REPLACE "/" "-" folder "${room}")
  tactum_tests(${room} PROGRAM ${folder}-umockdev
    TESTS ${T_TESTS} USES ${T_USES} LINKS ${T_LINKS} umockdev_usb UNDER "${UMOCKDEV_WRAPPER}" SUFFIX _umockdev LONG ${T_TESTS})
  foreach(name IN LISTS T_TESTS)
    set_tests_properties(test_${name}_umockdev PROPERTIES ENVIRONMENT "TMPDIR=/tmp")
  endforeach()
endfunction()
