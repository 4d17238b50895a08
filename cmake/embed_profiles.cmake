# embed_profiles(FILE): writes a source with the text of every resources/devices/*.json into FILE, when they
# change. Text is data here: a program that is run without being installed has its devices too.
function(embed_profiles to)
  file(GLOB profiles CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/resources/devices/*.json")
  list(SORT profiles)
  set(entries "")
  list(LENGTH profiles count)
  foreach(profile IN LISTS profiles)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${profile}")
    get_filename_component(key "${profile}" NAME_WLE)
    file(READ "${profile}" text)
    string(APPEND entries "    {\"${key}\", R\"json(${text})json\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${to}" @ONLY CONTENT [[
#include "device/built_in_profiles.h"

namespace tactum {
namespace {
constexpr std::array<std::pair<std::string_view, std::string_view>, @count@> kProfiles{{
@entries@}};
} // namespace
const std::span<const std::pair<std::string_view, std::string_view>> kBuiltInProfiles = kProfiles;
} // namespace tactum
]])
endfunction()
