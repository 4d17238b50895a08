# find_package(Tactum) gives Tactum::bundle, Tactum::runtime, Tactum::scene and the rooms below them.
# What core was built on is found again, because its libraries are static.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(Eigen3 3.4)
find_dependency(TinyGLTF)
find_dependency(nlohmann_json)
find_dependency(PNG)
find_dependency(JPEG)
find_dependency(TIFF)
find_dependency(assimp)
find_dependency(pugixml)
include("${CMAKE_CURRENT_LIST_DIR}/TactumTargets.cmake")
