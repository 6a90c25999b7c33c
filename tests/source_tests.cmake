# Tests of the source as text: its includes and its layout, what clang-tidy finds and what Doxygen reads.

magmpm_add_test(check_includes 60 ${PROJECT_SOURCE_DIR}/scripts/check_includes)

execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_format --program
                RESULT_VARIABLE no_clang_format OUTPUT_QUIET ERROR_QUIET)
if(no_clang_format EQUAL 0)
  magmpm_add_test(format 60 ${PROJECT_SOURCE_DIR}/scripts/check_format)
else()
  message(STATUS "The format of the source is not tested: that needs clang-format-14")
endif()

# --- clang-tidy ------------------------------------------------------------------------------

# The sources that reach no header of deal.II, which costs more than they do; a room as one file, since the
# headers that its sources share cost more than the sources, too: names local to a source must differ within
# a room. Rooms of which a source reaches Trilinos are left out for the same reason.
set(clang_tidy_folder ${CMAKE_CURRENT_BINARY_DIR}/clang_tidy)

# Writes the one file of each room; all of them into RESULT.
function(magmpm_write_room_files result)
  execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_includes --plain
                  OUTPUT_VARIABLE sources COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "source/[^\n]+" sources "${sources}")
  list(REMOVE_ITEM sources source/base/processor_check.cc) # compiled otherwise
  set(files "")
  foreach(room IN LISTS ARGN)
    set(sources_of_room ${sources})
    list(FILTER sources_of_room INCLUDE REGEX "^source/${room}/")
    list(TRANSFORM sources_of_room REPLACE "(.+)" "#include <${PROJECT_SOURCE_DIR}/\\1>\n")
    list(JOIN sources_of_room "" text)
    file(CONFIGURE OUTPUT ${clang_tidy_folder}/${room}.cc CONTENT "${text}")
    list(APPEND files ${clang_tidy_folder}/${room}.cc)
  endforeach()
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# The test NAME: clang-tidy finds nothing in the rooms that follow.
function(magmpm_add_clang_tidy name)
  magmpm_write_room_files(files ${ARGN})
  # Never built: it is there for its command lines.
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${files})
  target_link_libraries(${name} PRIVATE magmpm_library)
  magmpm_add_test(${name} 900 ${MAGMPM_CLANG_TIDY} --quiet -p ${PROJECT_BINARY_DIR}
                  --config-file=${PROJECT_SOURCE_DIR}/.clang-tidy ${files})
endfunction()

# Whether CANDIDATE is of the version that .clang-tidy is written for: others find other things.
function(magmpm_is_clang_tidy_14 result candidate)
  execute_process(COMMAND ${candidate} --version OUTPUT_VARIABLE version ERROR_QUIET)
  if(NOT version MATCHES "version 14\\.")
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
find_program(MAGMPM_CLANG_TIDY NAMES clang-tidy-14 clang-tidy VALIDATOR magmpm_is_clang_tidy_14)
mark_as_advanced(MAGMPM_CLANG_TIDY)

if(MAGMPM_CLANG_TIDY)
  # As many rooms as a minute allows; the others take another one.
  magmpm_add_clang_tidy(clang_tidy base lattice materials motion parallel boundary mesh particles magnetics
                        surface)
  magmpm_add_clang_tidy(clang_tidy.long geometry magnets coupling parameters results simulation)
  set_tests_properties(clang_tidy.long PROPERTIES LABELS long)
else()
  message(STATUS "What clang-tidy finds in the source is not tested: that needs clang-tidy-14")
endif()

# --- Doxygen ---------------------------------------------------------------------------------

find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  set(doxyfile ${PROJECT_BINARY_DIR}/Doxyfile)
  configure_file(${PROJECT_SOURCE_DIR}/doc/Doxyfile.in ${doxyfile} @ONLY)
  add_custom_target(doxygen COMMAND Doxygen::doxygen ${doxyfile} VERBATIM
                    COMMENT "Writing the reference of the headers: doxygen/html/index.html")
  magmpm_add_test(doxygen 300 ${DOXYGEN_EXECUTABLE} ${doxyfile})
else()
  message(STATUS "The docstrings of the headers are not tested: that needs doxygen")
endif()
