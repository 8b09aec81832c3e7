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

# With HACHURE_UNITY, the files of a folder are compiled together, a dozen at a time: most of what a file costs is reading
# the same headers and instantiating the same templates again. A unit never crosses folders, so that what an anonymous
# namespace holds needs a name that is unique in its folder only. Sources with SKIP_UNITY_BUILD_INCLUSION stay alone. Call
# it once the target has all its sources.
function(hachure_unity target)
  if(NOT HACHURE_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  set(folders "")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} NORMALIZE generated)
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    if(NOT generated AND NOT alone)
      cmake_path(GET source PARENT_PATH folder)
      list(APPEND folders ${folder})
      list(APPEND sources_${folder} ${source})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    list(LENGTH sources_${folder} count)
    math(EXPR units "(${count} + ${HACHURE_UNITY_BATCH} - 1) / ${HACHURE_UNITY_BATCH}")
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    string(MAKE_C_IDENTIFIER ${name} name)
    set(index 0)
    foreach(source IN LISTS sources_${folder})
      math(EXPR unit "${index} * ${units} / ${count}")
      math(EXPR index "${index} + 1")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name}_${unit})
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # g++ warns of a class with members of an anonymous namespace's types in any file that is included, as these are now. In
  # tests a local may have the name of another file's constant; builds of single files warn of their own.
  target_compile_options(${target} PRIVATE -Wno-subobject-linkage
    $<$<NOT:$<STREQUAL:${target},hachure>>:-Wno-shadow>)
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
  # Each with instructions of its own: a pragma for the rest of the unit.
  set_source_files_properties(${PROJECT_SOURCE_DIR}/runtime/geometry/skin_portable.cpp
    ${PROJECT_SOURCE_DIR}/runtime/geometry/skin_avx2.cpp ${PROJECT_SOURCE_DIR}/runtime/geometry/skin_avx512.cpp
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  hachure_unity(hachure)
endfunction()
