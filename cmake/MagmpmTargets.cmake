# The targets: magmpm_options (how everything is compiled; of it magmpm_portable_options for every
# processor), magmpm_<room> (each room), magmpm_library (all of them: magmpm::magmpm, the
# library) and magmpm (the program).

# --- How everything is compiled --------------------------------------------------------------

add_library(magmpm_portable_options INTERFACE)
target_compile_features(magmpm_portable_options INTERFACE cxx_std_17)
target_include_directories(magmpm_portable_options INTERFACE
                           $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# -Wno-psabi: GCC's note that passing 64-byte vectors differs from GCC 4, said at every use.
# -ffp-contract=fast: ISO mode would otherwise turn fused multiply-add off.
target_compile_options(magmpm_portable_options INTERFACE $<BUILD_INTERFACE:-Wall> $<BUILD_INTERFACE:-Wextra>
                                                         -Wno-psabi -ffp-contract=fast)
target_link_options(magmpm_portable_options INTERFACE $<BUILD_INTERFACE:-Wl,--as-needed>)
# Some 200 shared libraries come with deal.II: ld reads them in 18 CPU seconds a program, gold in 1.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold MAGMPM_HAS_GOLD)
if(MAGMPM_HAS_GOLD)
  target_link_options(magmpm_portable_options INTERFACE $<BUILD_INTERFACE:-fuse-ld=gold>)
endif()
add_library(magmpm_options INTERFACE)
target_link_libraries(magmpm_options INTERFACE magmpm_portable_options)
if(MAGMPM_NATIVE)
  # The processor becomes part of each command line, so that on another one (a build folder or a
  # ccache shared by machines) everything is compiled anew.
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null
                  OUTPUT_VARIABLE native_macros RESULT_VARIABLE result ERROR_QUIET)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${CMAKE_CXX_COMPILER} does not know -march=native: configure with "
                        "-DMAGMPM_NATIVE=OFF, and the right flag in CMAKE_CXX_FLAGS.")
  endif()
  string(MD5 native_processor "${native_macros}")
  target_compile_options(magmpm_options INTERFACE -march=native
                         $<BUILD_INTERFACE:-DMAGMPM_PROCESSOR=0x${native_processor}>)
endif()
if(MAGMPM_SANITIZE)
  target_compile_options(magmpm_portable_options INTERFACE -fsanitize=${MAGMPM_SANITIZE}
                                                           -fno-omit-frame-pointer -g)
  target_link_options(magmpm_portable_options INTERFACE -fsanitize=${MAGMPM_SANITIZE})
endif()

# deal.II as a target that carries its include folders, definitions and libraries, but not the
# optimization flags of the distribution's build (deal_ii_setup_target would bring these).
if(NOT DEAL_II_TARGET_CONFIG_INCLUDED)
  include(${DEAL_II_TARGET_CONFIG})
endif()
string(TOUPPER ${CMAKE_BUILD_TYPE} build_type)
if(build_type STREQUAL "DEBUG" AND NOT DEAL_II_BUILD_TYPE MATCHES "Debug")
  message(WARNING "deal.II at ${DEAL_II_PATH} has no debug library: its assertions stay off.")
  set(build_type RELEASE)
endif()
add_library(magmpm_deal_ii INTERFACE)
target_include_directories(magmpm_deal_ii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS}
                                                           ${Trilinos_INCLUDE_DIRS})
target_compile_definitions(magmpm_deal_ii INTERFACE ${DEAL_II_USER_DEFINITIONS}
                                                    ${DEAL_II_USER_DEFINITIONS_${build_type}})
target_link_libraries(magmpm_deal_ii INTERFACE ${DEAL_II_TARGET_${build_type}} MPI::MPI_CXX)
# SIMD lanes of the potential solver. All that includes simd_lanes.h has to see the same, so the
# definition goes to all users of deal.II. The templates inside later deal.II are others.
if(MAGMPM_WIDE_SIMD AND MAGMPM_NATIVE)
  if(DEAL_II_VERSION VERSION_LESS 9.5)
    target_compile_definitions(magmpm_deal_ii INTERFACE MAGMPM_WIDE_SIMD)
  else()
    message(STATUS "The potential solver takes the SIMD lanes of deal.II ${DEAL_II_VERSION}")
  endif()
endif()

# --- How some files are compiled otherwise -------------------------------------------------------

# Each path is below source/. A file with options of its own is compiled alone also in a unity build.
function(magmpm_file_options options)
  foreach(file IN LISTS ARGN)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/source/${file}.cc)
      message(FATAL_ERROR "source/${file}.cc, which is to be compiled with ${options}, is not there")
    endif()
    set_source_files_properties(${PROJECT_SOURCE_DIR}/source/${file}.cc PROPERTIES
                                COMPILE_OPTIONS "${options}")
  endforeach()
endfunction()

# Kernels. Neither changes a result: no errno from sqrt, no traps on floating point exceptions.
set(kernel_options -fno-math-errno -fno-trapping-math)
magmpm_file_options("${kernel_options}" lattice/block_quadrature lattice/block_set
                    materials/magnetization_curve particles/magnetic_transfer
                    particles/particle_grid_transfer particles/smoothed_volume
                    particles/surface_content particles/velocity_filter surface/surface_stress)

# These evaluate the laws of the medium, or integrals round rings, in SIMD lanes, which sqrt leaves
# where it may set errno.
magmpm_file_options(-fno-math-errno magnetics/magnetic_force magnetics/material_points
                    magnets/ring_integrals particles/particle_sums)

# What decides whether a point is inside of a mesh must not depend on the order of two factors.
magmpm_file_options(-ffp-contract=off geometry/mesh_interior)

# --- The processor check -------------------------------------------------------------------

# Runs before everything else, so it is compiled for the oldest processor; and apart, since no file
# refers to it and an archive would leave it out.
set(processor_check_source ${PROJECT_SOURCE_DIR}/source/base/processor_check.cc)
add_library(magmpm_processor_check OBJECT ${processor_check_source})
target_link_libraries(magmpm_processor_check PRIVATE magmpm_options)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set_source_files_properties(${processor_check_source} PROPERTIES
                              COMPILE_OPTIONS "-march=x86-64;-fno-sanitize=all")
endif()

# --- The rooms -------------------------------------------------------------------------------

# What a room needs besides the rooms below it, and what its headers need.
set(libraries_of_parallel magmpm_deal_ii)
set(public_libraries_of_parallel MPI::MPI_CXX)
set(libraries_of_motion magmpm_deal_ii)
set(libraries_of_geometry ${VTK_LIBRARIES})
set(public_libraries_of_mesh magmpm_deal_ii)
set(libraries_of_elliptic ${MueLu_LIBRARIES} ${Belos_LIBRARIES})
set(libraries_of_boundary magmpm_deal_ii)
set(libraries_of_results ${VTK_LIBRARIES})

# magmpm_<room>: source/<room>/*.cc, one library for each room, so that the test of a room waits for no
# other than it may include.
set(room_table ${PROJECT_SOURCE_DIR}/source/rooms.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${room_table})
file(STRINGS ${room_table} room_lines REGEX "^[^#]")
set(rooms "")
foreach(line IN LISTS room_lines)
  string(REGEX MATCHALL "[a-z]+" rooms_below ${line})
  list(POP_FRONT rooms_below room)
  list(TRANSFORM rooms_below PREPEND magmpm_)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/source/${room}/*.cc)
  list(REMOVE_ITEM sources ${processor_check_source})
  add_library(magmpm_${room} STATIC ${sources})
  target_link_libraries(magmpm_${room} PUBLIC magmpm_options ${rooms_below}
                                              ${public_libraries_of_${room}}
                                       PRIVATE ${libraries_of_${room}})
  list(APPEND rooms ${room})
endforeach()

# Where headers cost more than what is in the files.
foreach(room geometry magnets results elliptic simulation)
  magmpm_compile_together(magmpm_${room} ${PROJECT_SOURCE_DIR}/source/elliptic/simd_matrix_free.cc)
endforeach()

# The version's commit: written again after a commit or checkout, which append to git's log of HEAD.
set(version_source ${PROJECT_BINARY_DIR}/version.cc)
set(version_dependencies source/base/version.cc.in cmake/WriteVersion.cmake)
execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} rev-parse --git-path logs/HEAD
                OUTPUT_VARIABLE git_log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
cmake_path(ABSOLUTE_PATH git_log BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
if(EXISTS ${git_log} AND NOT IS_DIRECTORY ${git_log})
  list(APPEND version_dependencies ${git_log})
endif()
add_custom_command(
  OUTPUT ${version_source}
  DEPENDS ${version_dependencies}
  COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DOUTPUT=${version_source}
          -DTEMPLATE=${PROJECT_SOURCE_DIR}/source/base/version.cc.in
          -DMAGMPM_VERSION=${PROJECT_VERSION} -DDEAL_II_VERSION=${DEAL_II_VERSION}
          -DTRILINOS_VERSION=${Trilinos_VERSION} -DP4EST_VERSION=${DEAL_II_P4EST_VERSION}
          -DBUILD_TYPE=${build_type}
          -P ${PROJECT_SOURCE_DIR}/cmake/WriteVersion.cmake
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMENT "Writing the version"
  VERBATIM)

target_sources(magmpm_base PRIVATE ${version_source})

# --- The library and the program -------------------------------------------------------------------

add_library(magmpm_library STATIC)
foreach(room IN LISTS rooms)
  target_sources(magmpm_library PRIVATE $<TARGET_OBJECTS:magmpm_${room}>)
endforeach()
target_link_libraries(magmpm_library PUBLIC magmpm_options magmpm_deal_ii ${MueLu_LIBRARIES}
                                            ${Belos_LIBRARIES} ${VTK_LIBRARIES})
set_target_properties(magmpm_library PROPERTIES OUTPUT_NAME magmpm EXPORT_NAME magmpm
                                                LINKER_LANGUAGE CXX)
add_library(magmpm::magmpm ALIAS magmpm_library)

add_executable(magmpm source/main.cc)
target_link_libraries(magmpm PRIVATE magmpm::magmpm magmpm_processor_check)
