# One place for compiler settings; every target of the project links tacit_flags.
option(TACIT_WERROR "Treat warnings as errors" OFF)
set(TACIT_SANITIZE "" CACHE STRING "address, thread or empty")
option(TACIT_COVERAGE "Instrument for coverage" OFF)

add_library(tacit_flags INTERFACE)
target_compile_features(tacit_flags INTERFACE cxx_std_20)
# Contraction would let the compiler round differently from one build to the next.
target_compile_options(tacit_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -ffp-contract=off)
# GCC 12 warns of overlapping copies inside std::string where there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(tacit_flags INTERFACE -Wno-restrict)
endif()
# Assertions guard against our own bugs and stay on in every build.
target_compile_options(tacit_flags INTERFACE -UNDEBUG)
if(TACIT_WERROR)
  target_compile_options(tacit_flags INTERFACE -Werror)
endif()
if(TACIT_SANITIZE STREQUAL "address")
  # Memory that Fast DDS lends begins four bytes behind a multiple of eight.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=alignment
                      -fno-sanitize-recover=undefined
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
elseif(TACIT_SANITIZE STREQUAL "thread")
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
  # ThreadSanitizer knows no fences; Asio's are beside mutexes that it knows.
  add_compile_definitions(BOOST_ASIO_DISABLE_FENCED_BLOCK)
endif()
if(TACIT_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()
