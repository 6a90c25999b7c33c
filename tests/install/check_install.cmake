# Script mode: installs magmpm below FOLDER, then builds and runs the project beside this file with what
# was installed alone. Packages that magmpm stands on and that are missing are named.
#   cmake -DBUILD=... -DFOLDER=... -DGENERATOR=... -DBUILD_TYPE=... -DCOMPILER=... -DLAUNCHER=... -P ...

# Of an earlier run nothing may serve.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/empty)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

set(configure ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
              -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
              -DCMAKE_PREFIX_PATH=${FOLDER}/prefix)
execute_process(COMMAND ${configure} -B ${FOLDER}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${FOLDER}/build/pull_on_magnet
                        ${FOLDER}/prefix/share/magmpm/parameter_files/cube_nonlinear.prm
                WORKING_DIRECTORY ${FOLDER}/empty COMMAND_ERROR_IS_FATAL ANY)
file(GLOB written ${FOLDER}/empty/*)
if(written)
  message(FATAL_ERROR "The library wrote ${written}")
endif()

# In the build folder that is configured already, where it costs least.
execute_process(COMMAND ${configure} -B ${FOLDER}/build -DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON
                        -DCMAKE_DISABLE_FIND_PACKAGE_deal.II=ON -DCMAKE_DISABLE_FIND_PACKAGE_Trilinos=ON
                        -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
foreach(package "MPI for C\\+\\+" "deal.II 9" Trilinos VTK)
  if(result EQUAL 0 OR NOT error MATCHES "not found:.* ${package}[^\n]*\\(set ")
    message(FATAL_ERROR "Without ${package} the package says: ${error}")
  endif()
endforeach()
