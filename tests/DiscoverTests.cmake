# What ctest runs of a GoogleTest program. A process of its own for every test costs more than the test: half a second to
# load the 260 libraries that OpenImageIO brings, then contexts and shaders. So the tests of a folder share a process, but
# for those on GL back ends, and for those of programs with `apart` set, which take long: there, a suite does. With
# HACHURE_EACH_TEST in the environment every test is one of ctest's, so that `-R` can name it; `./dev test -R` sets it.
#
# ctest includes this with `program`, `labels` and `apart` set, after the build. Names are the folder of the test's source
# below tests/, the suite, and the test: systems.gooch, systems.gooch.Gl/GoochTest, systems.gooch.Gl/GoochTest.Name/egl.

# Writes to `file` what there is: a line `add(KIND NAME FILTER)` for every process and every test.
function(list_tests file)
  execute_process(COMMAND ${program} --gtest_list_tests --gtest_output=json:${file}.json OUTPUT_QUIET
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${program} does not list its tests: ${failed}")
  endif()
  file(READ ${file}.json json)
  file(REMOVE ${file}.json)
  set(lines "")
  set(folders "")
  string(JSON suites LENGTH "${json}" testsuites)
  math(EXPR last_suite "${suites} - 1")
  foreach(i RANGE ${last_suite})
    string(JSON suite GET "${json}" testsuites ${i})
    string(JSON name GET "${suite}" name)
    string(JSON source GET "${suite}" testsuite 0 file)
    string(REGEX REPLACE ".*/tests/" "" folder "${source}")
    get_filename_component(folder "${folder}" DIRECTORY)
    string(REPLACE "/" "." folder "${folder}")
    if(apart OR name MATCHES "^Gl/")
      string(APPEND lines "add(process [==[${folder}.${name}]==] [==[${name}.*]==])\n")
    else()
      list(APPEND folders ${folder})
      list(APPEND suites_of_${folder} "${name}.*")
    endif()
    string(JSON tests LENGTH "${suite}" testsuite)
    math(EXPR last_test "${tests} - 1")
    foreach(k RANGE ${last_test})
      string(JSON test GET "${suite}" testsuite ${k} name)
      string(APPEND lines "add(test [==[${folder}.${name}.${test}]==] [==[${name}.${test}]==])\n")
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    list(JOIN suites_of_${folder} ":" filter)
    string(APPEND lines "add(process [==[${folder}]==] [==[${filter}]==])\n")
  endforeach()
  file(WRITE ${file} "${lines}")
endfunction()

if(DEFINED ENV{HACHURE_EACH_TEST})
  set(wanted test)
  set(timeout 120)
  set(skipped "\\[  SKIPPED \\]")
else()
  set(wanted process)
  set(timeout 1200)
  set(skipped "\\[  PASSED  \\] 0 tests") # what is skipped in part has passed
endif()

macro(add kind name filter)
  if(${kind} STREQUAL wanted)
    add_test("${name}" ${program} "--gtest_filter=${filter}")
    set_tests_properties("${name}" PROPERTIES TIMEOUT ${timeout} LABELS "${labels}" SKIP_REGULAR_EXPRESSION "${skipped}")
  endif()
endmacro()

if(EXISTS ${program})
  set(list ${program}.tests.cmake)
  if(NOT EXISTS ${list} OR NOT ${list} IS_NEWER_THAN ${program} OR NOT ${list} IS_NEWER_THAN ${CMAKE_CURRENT_LIST_FILE})
    list_tests(${list})
  endif()
  include(${list})
else()
  add_test(${program} ${program}) # fails: it was not built
endif()
