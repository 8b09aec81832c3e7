# Debian's OpenImageIO names OpenCV's include folder, which its own headers do not need and which is often absent.
# CMake refuses a target with a missing include folder, so such folders are dropped here.

function(hachure_drop_missing_includes target)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  if(NOT folders)
    return()
  endif()
  set(present "")
  foreach(folder IN LISTS folders)
    if(folder MATCHES "^\\$<" OR EXISTS ${folder})
      list(APPEND present ${folder})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${present}")
endfunction()

hachure_drop_missing_includes(OpenImageIO::OpenImageIO)
