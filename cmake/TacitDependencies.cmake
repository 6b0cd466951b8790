# All third-party libraries, from the distribution's packages.
set(TACIT_APT_HINT "On Debian 12 `deploy/install.sh` installs everything that is needed.")
macro(tacit_require package)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "${package} was not found. ${TACIT_APT_HINT}")
  endif()
endmacro()

tacit_require(Threads)
tacit_require(Eigen3 CONFIG)
tacit_require(fastcdr CONFIG)
tacit_require(fastrtps CONFIG)
tacit_require(spdlog CONFIG)
tacit_require(nlohmann_json CONFIG)
tacit_require(tomlplusplus CONFIG)
tacit_require(pegtl CONFIG)
tacit_require(SQLiteCpp CONFIG)
tacit_require(CLI11 CONFIG)
tacit_require(OpenSSL)
tacit_require(Boost 1.81)

# Bullet's own CMake file holds relative include paths, so pkg-config it is. Double precision: the
# state of a run is made of doubles, and no number is rounded on its way into or out of the solver.
find_package(PkgConfig REQUIRED)
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet-float64)

find_program(FASTDDSGEN fastddsgen)
if(NOT FASTDDSGEN)
  message(FATAL_ERROR "fastddsgen was not found. ${TACIT_APT_HINT}")
endif()

if(TACIT_BUILD_TESTS)
  tacit_require(GTest CONFIG)
  include(GoogleTest)
endif()
if(TACIT_BUILD_BENCHMARKS)
  tacit_require(benchmark CONFIG)
endif()
