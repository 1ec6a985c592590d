# Writes the header that says which commit the sources are of, only when it says something else than before.
#   cmake -D SOURCE=FOLDER -D HEADER=FILE [-D COMMIT=TEXT] [-D GIT=PROGRAM] -P commit.cmake
if(NOT COMMIT AND GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${SOURCE}" source)
  # A copy of the sources below another repository is not of its commit.
  if(top STREQUAL source)
    execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
      OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${GIT} -C ${SOURCE} --no-optional-locks status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(COMMIT AND changes)
      string(APPEND COMMIT "-modified")
    endif()
  endif()
endif()
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
set(text "#pragma once\n\nnamespace vantage {\n\ninline constexpr char kCommit[] = \"${COMMIT}\";\n\n}  // namespace vantage\n")
if(EXISTS ${HEADER})
  file(READ ${HEADER} before)
endif()
if(NOT "${before}" STREQUAL "${text}")
  file(WRITE ${HEADER} "${text}")
endif()
