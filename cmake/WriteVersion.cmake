# Writes OUTPUT, which defines tacit::version(); leaves it alone when nothing has changed.
find_program(GIT git)
set(text ${VERSION})
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0 ${GIT} -C ${SOURCE_DIR} describe --always --exclude=* --abbrev=7 --dirty=.dirty
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    string(APPEND text "+g${commit}")
  endif()
endif()
set(source "#include \"idl/version/version.h\"

std::string_view tacit::version() { return \"${text}\"; }
")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} present)
endif()
if(NOT source STREQUAL "${present}")
  file(WRITE ${OUTPUT} "${source}")
endif()
