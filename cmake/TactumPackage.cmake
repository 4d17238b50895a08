# The Debian packages, made by ./package: tactum (the program), libtactum0.1 and libtactum-dev (the library and HL for other
# programs) and python3-tactum (the core and the server's client for Python).

set(desktop "${PROJECT_SOURCE_DIR}/resources/desktop")
set(made "${CMAKE_CURRENT_BINARY_DIR}/package")
file(MAKE_DIRECTORY "${made}")
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
find_program(GZIP gzip REQUIRED)

# What a desktop wants to know.
install(FILES "${desktop}/tactum.desktop" DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES "${desktop}/tactum-mime.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" RENAME tactum.xml)
install(FILES "${desktop}/tactum.thumbnailer" DESTINATION "${CMAKE_INSTALL_DATADIR}/thumbnailers")

# App stores show a program's pictures from an address.
set(TACTUM_HOME "" CACHE STRING "An https address below which docs/pictures are found; without one the metainfo names no pictures")
set(metainfo org.tactum.Tactum.metainfo.xml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${desktop}/${metainfo}")
file(READ "${desktop}/${metainfo}" text)
if(NOT TACTUM_HOME)
  string(REGEX REPLACE "  <url type=\"homepage\">.*</screenshots>\n" "" text "${text}")
endif()
file(CONFIGURE OUTPUT "${made}/${metainfo}" CONTENT "${text}" @ONLY)
install(FILES "${made}/${metainfo}" DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo")

# Icons from one picture.
set(icon "${PROJECT_SOURCE_DIR}/resources/icons/tactum.svg")
set(files "")
foreach(size 16 22 24 32 48 64 128 256 512)
  set(png "${made}/tactum-${size}.png")
  add_custom_command(OUTPUT "${png}" DEPENDS "${icon}" VERBATIM
    COMMAND "${RSVG_CONVERT}" -w ${size} -h ${size} -o "${png}" "${icon}")
  list(APPEND files "${png}")
  install(FILES "${png}" DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps" RENAME tactum.png)
endforeach()
install(FILES "${icon}" DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")

# tactum_made(FILE COMMAND): the command's output, compressed where the name says so.
function(tactum_made file)
  set(output "${made}/${file}")
  set(text "$<TARGET_FILE:tactum> manual ${ARGN}")
  if(file MATCHES "\\.gz$")
    string(APPEND text " | ${GZIP} -9n")
  endif()
  add_custom_command(OUTPUT "${output}" DEPENDS tactum VERBATIM COMMAND sh -c "${text} >${output}")
  set(files ${files} "${output}" PARENT_SCOPE)
endfunction()
tactum_made(tactum.1.gz man)
tactum_made(tactum.bash bash)
tactum_made(_tactum zsh)
tactum_made(tactum.fish fish)
install(FILES "${made}/tactum.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${made}/tactum.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME tactum)
install(FILES "${made}/_tactum" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions")
install(FILES "${made}/tactum.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")

# The add-on for Blender.
install(FILES "${PROJECT_SOURCE_DIR}/resources/blender/tactum_haptics.py" DESTINATION "${CMAKE_INSTALL_DATADIR}/tactum/blender")

# Devices for whoever sits at the machine. Priority for their loops an account gets by its person's consent, in the program.
install(FILES "${PROJECT_SOURCE_DIR}/resources/udev/70-tactum.rules" DESTINATION lib/udev/rules.d)

# What Debian asks of every package: who may do what with it, and what changed.
set(debian "${PROJECT_SOURCE_DIR}/resources/debian")
add_custom_command(OUTPUT "${made}/changelog.gz" DEPENDS "${debian}/changelog" VERBATIM
  COMMAND sh -c "${GZIP} -9nc '${debian}/changelog' >'${made}/changelog.gz'")
list(APPEND files "${made}/changelog.gz")
set(library "libtactum${TACTUM_LIBRARY_ABI}") # as its soname says
foreach(pair program:tactum lib:${library} dev:libtactum-dev python:python3-tactum)
  string(REPLACE ":" ";" pair "${pair}")
  list(GET pair 0 component)
  list(GET pair 1 package)
  set(overrides "${package}")
  if(component STREQUAL "lib")
    set(overrides libtactum)
  endif()
  install(FILES "${debian}/copyright" "${made}/changelog.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT ${component})
  install(FILES "${debian}/${overrides}.lintian-overrides" DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides"
    RENAME "${package}" COMPONENT ${component})
endforeach()
add_custom_target(package-files ALL DEPENDS ${files})

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program lib dev python)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_NAME tactum)
set(CPACK_PACKAGE_VENDOR Tactum)
set(CPACK_PACKAGE_CONTACT "Tactum maintainers <maintainers@tactum.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tactum)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-open-sans, libgl1-mesa-dri, qt6-translations-l10n")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "author haptic scenes, and touch them
Open a 3-D model, give each surface a feel (stiffness, friction, texture,
moving parts) and touch it with a force-feedback device, or with the mouse
and a simulated hand. Scenes are saved as glTF and exported as bundles that
other programs open. Verbs without a window replay, convert and check.")

file(CONFIGURE OUTPUT "${made}/triggers" CONTENT "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_LIB_PACKAGE_NAME ${library})
set(CPACK_DEBIAN_LIB_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIB_PACKAGE_CONTROL_EXTRA "${made}/triggers")
set(CPACK_COMPONENT_LIB_DESCRIPTION "haptics of Tactum for other programs, the library
Scenes, bundles, the haptic step of Ruspini and Khatib (2001) and the engine
with its real-time loops and devices. Files are read by a process of its own.")

# HL is static: who links it links what it stands on, and nobody else needs that.
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libtactum-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${library} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "libgrpc++-dev, libprotobuf-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "haptics of Tactum for other programs, to build with
The headers of the library and a CMake package; the header of device drivers;
and HL, the client of a tactum serve, as a static library.")
# Its module is for one Python, as Debian's packages of modules are. What the server's client needs is only recommended:
# scenes are touched without it.
math(EXPR next "${TACTUM_PYTHON_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tactum)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= 3.${TACTUM_PYTHON_MINOR}), python3 (<< 3.${next}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-grpcio, python3-protobuf")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "tactum")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "haptic scenes in Python, and Tactum's haptic server
Opens scenes, changes how their surfaces feel, replays finger paths and steps
them one by one, with numpy arrays in and out. Its other half is the client of
a tactum serve: states, forces and contacts of a device.")
include(CPack)
