# FFmpeg's muxers and encoders: FFmpeg::FFmpeg. Debian ships them with pkg-config files only.

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(FFmpeg_pc QUIET IMPORTED_TARGET libavformat libavcodec libavutil)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FFmpeg REQUIRED_VARS FFmpeg_pc_LINK_LIBRARIES VERSION_VAR FFmpeg_pc_libavcodec_VERSION)

if(FFmpeg_FOUND AND NOT TARGET FFmpeg::FFmpeg)
  add_library(FFmpeg::FFmpeg INTERFACE IMPORTED)
  target_link_libraries(FFmpeg::FFmpeg INTERFACE PkgConfig::FFmpeg_pc)
endif()
