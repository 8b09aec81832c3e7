# Lua 5.4: Lua54::Lua54. Debian ships it with a pkg-config file only; CMake's own FindLua takes any version.

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(Lua54_pc QUIET IMPORTED_TARGET lua5.4)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Lua54 REQUIRED_VARS Lua54_pc_LINK_LIBRARIES VERSION_VAR Lua54_pc_VERSION)

if(Lua54_FOUND AND NOT TARGET Lua54::Lua54)
  add_library(Lua54::Lua54 INTERFACE IMPORTED)
  target_link_libraries(Lua54::Lua54 INTERFACE PkgConfig::Lua54_pc)
endif()
