# Embeds every file of shaders/ and every built-in style in the library, and what reports are made of in the program, so
# that an installed program needs no data folder.

# hachure_embed(OUT FOLDER HEADER FUNCTION TYPE [STEM] GLOB...): OUT is a generated .cpp that defines FUNCTION, declared
# in HEADER: the table of the files of FOLDER that match, as {name, text}. STEM: names without folder and extension.
function(hachure_embed out folder header function type)
  cmake_parse_arguments(PARSE_ARGV 5 arg "STEM" "" "")
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND ${PROJECT_SOURCE_DIR}/${folder}/)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/${folder} ${arg_UNPARSED_ARGUMENTS})
  list(SORT files)
  string(REPLACE "::" "_" file_name ${function})
  set(generated ${PROJECT_BINARY_DIR}/generated/${file_name}.cpp)
  set(depends ${files})
  list(TRANSFORM depends PREPEND ${PROJECT_SOURCE_DIR}/${folder}/)
  list(JOIN files "|" names)
  add_custom_command(OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${PROJECT_SOURCE_DIR}/${folder} "-DFILES=${names}" -DHEADER=${header}
      -DFUNCTION=${function} -DTYPE=${type} -DSTEM=${arg_STEM} -DOUTPUT=${generated}
      -P ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    DEPENDS ${depends} ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    COMMENT "Embedding ${folder}" VERBATIM)
  set(${out} ${generated} PARENT_SCOPE)
endfunction()
