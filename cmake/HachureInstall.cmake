# Installation and the package that `find_package(Hachure)` finds.

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Hachure)
install(TARGETS hachure EXPORT HachureTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET hachure_program)
  install(TARGETS hachure_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(layer runtime components systems)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${layer} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hachure
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(EXPORT HachureTargets NAMESPACE Hachure:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/HachureConfig.cmake.in
  ${PROJECT_BINARY_DIR}/HachureConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/HachureConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/HachureConfig.cmake ${PROJECT_BINARY_DIR}/HachureConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/FindOSMesa.cmake ${PROJECT_SOURCE_DIR}/cmake/FindFFmpeg.cmake ${PROJECT_SOURCE_DIR}/cmake/FindLua54.cmake
  ${PROJECT_SOURCE_DIR}/cmake/HachurePackageFixes.cmake DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
