# The packages of docs/architecture.md, found once. Everything comes from Debian 12.

find_package(Threads REQUIRED)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(glm REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS EGL)
find_package(OpenImageIO REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(OSMesa REQUIRED)
find_package(FFmpeg REQUIRED)
find_package(Lua54 REQUIRED)
find_package(TBB REQUIRED)
find_package(ZLIB REQUIRED)
include(HachurePackageFixes)

function(hachure_link_dependencies target)
  # Headers of the house name GLM, fmt and JSON types; the rest stays behind the .cpp files.
  target_link_libraries(${target}
    PUBLIC glm::glm fmt::fmt nlohmann_json::nlohmann_json Threads::Threads
    PRIVATE glfw OpenGL::EGL OSMesa::OSMesa OpenImageIO::OpenImageIO FFmpeg::FFmpeg $<LINK_ONLY:Lua54::Lua54> TinyGLTF::TinyGLTF
      meshoptimizer::meshoptimizer TBB::tbb ZLIB::ZLIB ${CMAKE_DL_LIBS})
  # Templates that only .cpp files name: not even a private link, which the installed package would ask for.
  target_include_directories(${target} SYSTEM PRIVATE
    $<BUILD_INTERFACE:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>>)
endfunction()
