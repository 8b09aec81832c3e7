# Embeds every file of shaders/ in the library, so that an installed program needs no data folder.

function(hachure_embed_shaders out)
  file(GLOB_RECURSE shaders CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/shaders ${PROJECT_SOURCE_DIR}/shaders/*.glsl
    ${PROJECT_SOURCE_DIR}/shaders/*.vert ${PROJECT_SOURCE_DIR}/shaders/*.frag ${PROJECT_SOURCE_DIR}/shaders/*.comp)
  list(SORT shaders)
  set(generated ${PROJECT_BINARY_DIR}/generated/embedded_shaders.cpp)
  set(depends ${shaders})
  list(TRANSFORM depends PREPEND ${PROJECT_SOURCE_DIR}/shaders/)
  list(JOIN shaders "|" shader_names)
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DSHADER_DIR=${PROJECT_SOURCE_DIR}/shaders "-DSHADERS=${shader_names}" -DOUTPUT=${generated}
      -P ${PROJECT_SOURCE_DIR}/cmake/EmbedShaders.cmake
    DEPENDS ${depends} ${PROJECT_SOURCE_DIR}/cmake/EmbedShaders.cmake
    COMMENT "Embedding shaders" VERBATIM)
  set(${out} ${generated} PARENT_SCOPE)
endfunction()
