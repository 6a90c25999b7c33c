# The targets: magmpm_options (how everything is compiled; of it magmpm_portable_options for every
# processor), magmpm_kernels (files that know nothing
# of deal.II), magmpm_core (everything else but main), magmpm (the program).

# --- How everything is compiled --------------------------------------------------------------

add_library(magmpm_portable_options INTERFACE)
target_include_directories(magmpm_portable_options INTERFACE ${PROJECT_SOURCE_DIR}/include)
# -Wno-psabi: GCC's note that passing 64-byte vectors differs from GCC 4, said at every use.
# -ffp-contract=fast: ISO mode would otherwise turn fused multiply-add off.
target_compile_options(magmpm_portable_options INTERFACE -Wall -Wextra -Wno-psabi
                                                         -ffp-contract=fast)
target_link_options(magmpm_portable_options INTERFACE -Wl,--as-needed)
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
                                                  -DMAGMPM_PROCESSOR=0x${native_processor})
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
target_link_libraries(magmpm_deal_ii INTERFACE ${DEAL_II_TARGET_${build_type}})

# --- Sources ---------------------------------------------------------------------------------

file(GLOB core_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/source/*.cc
                                         ${PROJECT_SOURCE_DIR}/source/*/*.cc)
# Kernel files: scripts/check_includes proves that these include no deal.II header.
set(kernel_sources ${core_sources})
list(FILTER kernel_sources INCLUDE REGEX
     "/source/((base|lattice|materials)/[^/]*|particles/[^/]*transfer[^/]*)[.]cc$")
list(REMOVE_ITEM core_sources ${kernel_sources} ${PROJECT_SOURCE_DIR}/source/main.cc)

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

# --- Libraries and the program ---------------------------------------------------------------

# Runs before everything else, so it is compiled for the oldest processor; and an object library,
# since no file refers to it and an archive would leave it out.
set(processor_check_source ${PROJECT_SOURCE_DIR}/source/base/processor_check.cc)
list(REMOVE_ITEM kernel_sources ${processor_check_source})
add_library(magmpm_processor_check OBJECT ${processor_check_source})
target_link_libraries(magmpm_processor_check PRIVATE magmpm_options)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set_source_files_properties(${processor_check_source} PROPERTIES
                              COMPILE_OPTIONS "-march=x86-64;-fno-sanitize=all")
endif()

add_library(magmpm_kernels STATIC ${kernel_sources} ${version_source})
target_link_libraries(magmpm_kernels PUBLIC magmpm_options)
# Neither changes a result: no errno from sqrt, no traps on floating point exceptions.
target_compile_options(magmpm_kernels PRIVATE -fno-math-errno -fno-trapping-math)

if(core_sources)
  add_library(magmpm_core STATIC ${core_sources})
  set(core_scope PUBLIC)
else()
  add_library(magmpm_core INTERFACE)
  set(core_scope INTERFACE)
endif()
target_link_libraries(magmpm_core ${core_scope} magmpm_options magmpm_kernels magmpm_deal_ii
                                                ${MueLu_LIBRARIES} ${Belos_LIBRARIES}
                                                MPI::MPI_CXX ${VTK_LIBRARIES})

# These evaluate the laws of the medium, or integrals round rings, in SIMD lanes, which sqrt leaves
# where it may set errno.
foreach(file magnetics/magnetic_force magnetics/material_points magnetics/potential_residual
             magnets/ring_integrals particles/particle_sums)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/source/${file}.cc PROPERTIES
                              COMPILE_OPTIONS -fno-math-errno)
endforeach()

# What decides whether a point is inside of a mesh must not depend on the order of two factors.
set_source_files_properties(${PROJECT_SOURCE_DIR}/source/geometry/mesh_interior.cc PROPERTIES
                            COMPILE_OPTIONS -ffp-contract=off)

if(EXISTS ${PROJECT_SOURCE_DIR}/source/main.cc)
  add_executable(magmpm source/main.cc)
  target_link_libraries(magmpm PRIVATE magmpm_core magmpm_processor_check)
endif()

# SIMD lanes of the potential solver. All that includes simd_lanes.h has to see the same, so the
# definition goes to all users of the library. The templates inside later deal.II are others.
if(MAGMPM_WIDE_SIMD AND MAGMPM_NATIVE AND core_sources)
  if(DEAL_II_VERSION VERSION_LESS 9.5)
    target_compile_definitions(magmpm_core PUBLIC MAGMPM_WIDE_SIMD)
  else()
    message(STATUS "The potential solver takes the SIMD lanes of deal.II ${DEAL_II_VERSION}")
  endif()
endif()
