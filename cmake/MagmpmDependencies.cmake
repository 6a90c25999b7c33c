# Finds the libraries magmpm stands on. Whatever is missing, down to a feature of a library that was
# found, is named in one message, so that nobody builds deal.II twice.

set(missing_features "")

find_package(MPI QUIET COMPONENTS CXX)
if(NOT MPI_CXX_FOUND)
  string(APPEND missing_features "\n  MPI for C++ was not found (set MPI_HOME)")
endif()

find_package(deal.II 9.4 QUIET HINTS ${DEAL_II_DIR} $ENV{DEAL_II_DIR})
if(NOT deal.II_FOUND)
  string(APPEND missing_features "\n  deal.II 9.4 or newer was not found (set DEAL_II_DIR)")
else()
  foreach(feature MPI P4EST TRILINOS METIS)
    if(NOT DEAL_II_WITH_${feature})
      string(APPEND missing_features
             "\n  deal.II ${DEAL_II_VERSION} in ${DEAL_II_PATH} was built without ${feature} "
             "(DEAL_II_WITH_${feature}=ON)")
    endif()
  endforeach()
endif()

find_package(Trilinos QUIET HINTS ${TRILINOS_DIR} $ENV{TRILINOS_DIR})
if(NOT Trilinos_FOUND)
  string(APPEND missing_features "\n  Trilinos was not found (set TRILINOS_DIR)")
else()
  foreach(package ML MueLu Tpetra Belos Kokkos)
    if(NOT package IN_LIST Trilinos_PACKAGE_LIST)
      string(APPEND missing_features
             "\n  Trilinos ${Trilinos_VERSION} in ${Trilinos_DIR} was built without ${package} "
             "(Trilinos_ENABLE_${package}=ON)")
    endif()
  endforeach()
endif()

set(vtk_components CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersGeneral
                   FiltersModeling FiltersSources IOGeometry IOPLY IOXML)
find_package(VTK QUIET COMPONENTS ${vtk_components})
if(NOT VTK_FOUND)
  list(JOIN vtk_components ", " vtk_component_list)
  string(APPEND missing_features
         "\n  VTK with ${vtk_component_list} was not found (set VTK_DIR)")
endif()

find_package(Catch2 QUIET)
if(NOT Catch2_FOUND)
  string(APPEND missing_features "\n  Catch2, version 2 or 3, was not found (set Catch2_DIR)")
endif()

if(missing_features)
  message(FATAL_ERROR "magmpm cannot be built here:${missing_features}\n"
                      "On Debian 12, scripts/setup installs all of this.")
endif()
message(STATUS "deal.II ${DEAL_II_VERSION}, Trilinos ${Trilinos_VERSION}, "
               "p4est ${DEAL_II_P4EST_VERSION}, VTK ${VTK_VERSION}, Catch2 ${Catch2_VERSION}, "
               "MPI ${MPI_CXX_VERSION}")
