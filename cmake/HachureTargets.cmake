# How every target of the house is compiled, and the library itself.

# `<hachure/runtime/...>` reads the same in the tree and after installation: the build holds one link to the source root.
function(hachure_link_include_root)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/include)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/include/hachure SYMBOLIC)
endfunction()

function(hachure_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # -Wrestrict is off: g++ 12 finds it in std::string's own operator+ (GCC bug 105329); designated initialisers leave members to their defaults.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-restrict
    -Wno-missing-field-initializers
    $<$<BOOL:${HACHURE_WERROR}>:-Werror>)
  if(HACHURE_SANITIZE)
    list(JOIN HACHURE_SANITIZE "," sanitizers)
    target_compile_options(${target} PUBLIC -fsanitize=${sanitizers} -fno-omit-frame-pointer
      -fno-sanitize-recover=undefined)
    target_link_options(${target} PUBLIC -fsanitize=${sanitizers})
  endif()
endfunction()

function(hachure_add_library)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/runtime/*.cpp ${PROJECT_SOURCE_DIR}/components/*.cpp
    ${PROJECT_SOURCE_DIR}/systems/*.cpp)
  hachure_embed(shaders shaders hachure/runtime/gpu/embedded_shaders.h hachure::gpu::embedded_shaders
    hachure::gpu::EmbeddedShader *.glsl *.vert *.frag *.comp)
  hachure_embed(styles systems/styles hachure/systems/styles/style.h hachure::built_in_styles hachure::BuiltInStyle
    STEM *.json)
  add_library(hachure STATIC ${sources} ${shaders} ${styles})
  add_library(Hachure::hachure ALIAS hachure)
  hachure_compile_options(hachure)
  set_target_properties(hachure PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(hachure PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  hachure_link_dependencies(hachure)
endfunction()
