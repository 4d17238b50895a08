# find_package(Tactum) gives Tactum::tactum, the shared library with the headers in tactum/, and wants nothing else;
# find_package(Tactum COMPONENTS hl) gives Tactum::hl, the client of the haptic server, and nothing else. It is static: what
# it was built on is found again.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
if("hl" IN_LIST Tactum_FIND_COMPONENTS)
  find_dependency(Protobuf)
  find_dependency(gRPC CONFIG)
  include("${CMAKE_CURRENT_LIST_DIR}/TactumHlTargets.cmake")
  set(Tactum_hl_FOUND TRUE)
endif()
if(NOT Tactum_FIND_COMPONENTS STREQUAL "hl")
  include("${CMAKE_CURRENT_LIST_DIR}/TactumTargets.cmake")
endif()
