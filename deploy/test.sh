#!/bin/sh
# Builds everything and runs all tests.
set -eu
cd "$(dirname "$0")/.."

usage() {
  cat <<END
usage: deploy/test.sh [--no-install] [--preset NAME] [-- OPTION...]

Checks the sources' format when clang-format-14 is there, installs what is missing, builds,
and runs all tests.

  --no-install    do not call apt-get
  --preset NAME   dev, release (default), asan, tsan or coverage
  -- OPTION...    more options for ctest, as in: deploy/test.sh -- --label-regex unit
END
}

install=
preset=release
while [ $# -gt 0 ]; do
  case "$1" in
    --help | -h) usage; exit 0 ;;
    --no-install) install=--no-install ;;
    --preset)
      preset="${2:?wanted a name after --preset}"
      shift
      ;;
    --) shift; break ;;
    *) echo "test: unknown option \"$1\", see --help" >&2; exit 2 ;;
  esac
  shift
done

if command -v clang-format-14 >/dev/null; then
  echo "== format" >&2
  find idl robot_agent world_server console wizard_service deploy tests \( -name '*.h' -o -name '*.cpp' \) \
    -exec clang-format-14 --dry-run --Werror {} +
else
  echo "== format: not checked, clang-format-14 is not installed" >&2
fi
deploy/build.sh $install --preset "$preset"
echo "== tests of build/$preset" >&2
exec ctest --preset "$preset" --parallel 2 --output-on-failure "$@"
