# Script mode: writes version.cc from its template, with the commit checked out in SOURCE_DIR.
#   cmake -DSOURCE_DIR=... -DTEMPLATE=... -DOUTPUT=... -DMAGMPM_VERSION=... -P WriteVersion.cmake

execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --short=7 HEAD
                OUTPUT_VARIABLE MAGMPM_REVISION RESULT_VARIABLE result
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT result EQUAL 0)
  set(MAGMPM_REVISION unknown)
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
file(TOUCH ${OUTPUT})
