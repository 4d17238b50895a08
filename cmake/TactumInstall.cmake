# Where things go when the program is installed, and where a program looks for them.
include(GNUInstallDirs)

option(TACTUM_IN_TREE "Find samples, guide and import process also where they were built" ON)

# A program that lies in the tree it was built from looks there; one out of a package knows no path of its build.
set(TACTUM_DATA "${PROJECT_SOURCE_DIR}/resources")
set(TACTUM_DOCS "${PROJECT_SOURCE_DIR}/docs")
set(TACTUM_IMPORT_WORKER "${CMAKE_BINARY_DIR}/tactum-import")
if(NOT TACTUM_IN_TREE)
  set(TACTUM_DATA "${CMAKE_INSTALL_FULL_DATADIR}/tactum")
  set(TACTUM_DOCS "${TACTUM_DATA}/docs")
  set(TACTUM_IMPORT_WORKER "${CMAKE_INSTALL_FULL_LIBEXECDIR}/tactum/tactum-import")
endif()

# What is installed: the program, and what another project builds on.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
