# Finds the libraries magmpm stands on. Everything a found library lacks is named in one message,
# so that nobody rebuilds deal.II twice.

set(missing_features "")

find_package(MPI REQUIRED COMPONENTS CXX)
find_package(deal.II 9.4 REQUIRED)
foreach(feature MPI P4EST TRILINOS METIS)
  if(NOT DEAL_II_WITH_${feature})
    string(APPEND missing_features "\n  deal.II ${DEAL_II_VERSION} at ${DEAL_II_PATH} was built "
                                   "without ${feature} (-DDEAL_II_WITH_${feature}=ON)")
  endif()
endforeach()

find_package(Trilinos QUIET HINTS ${TRILINOS_DIR} $ENV{TRILINOS_DIR})
if(NOT Trilinos_FOUND)
  string(APPEND missing_features "\n  Trilinos was not found (set TRILINOS_DIR)")
else()
  foreach(package ML MueLu Tpetra Belos Kokkos)
    if(NOT package IN_LIST Trilinos_PACKAGE_LIST)
      string(APPEND missing_features "\n  Trilinos ${Trilinos_VERSION} at ${Trilinos_DIR} was built "
                                     "without ${package} (-DTrilinos_ENABLE_${package}=ON)")
    endif()
  endforeach()
endif()

find_package(VTK QUIET COMPONENTS CommonCore CommonDataModel IOXML)
if(NOT VTK_FOUND)
  string(APPEND missing_features "\n  VTK with its modules CommonCore, CommonDataModel and IOXML "
                                 "was not found (set VTK_DIR)")
endif()

find_package(Catch2 QUIET)
if(NOT Catch2_FOUND)
  string(APPEND missing_features "\n  Catch2 (2 or 3) was not found (set Catch2_DIR)")
endif()

if(missing_features)
  message(FATAL_ERROR "magmpm cannot be built here:${missing_features}\n"
                      "On Debian 12, scripts/setup installs all of this.")
endif()
