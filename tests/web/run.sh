#!/bin/sh
# Runs tests of the page: run.sh unit | page | real FOLDER_OF_PROGRAMS. Exits with 77 when what they
# need is not there.
set -eu
cd "$(dirname "$0")/../../console/web"

skip() {
  echo "skipped: $1"
  exit 77
}

command -v node >/dev/null || skip "node is not installed"
[ -d node_modules/vitest ] || skip "npm ci was not run in console/web; deploy/build.sh does"
case "$1" in
  unit) exec npm run --silent test ;;
  page | real)
    [ -e "${CHROMIUM:-/usr/bin/chromium}" ] || skip "chromium is not installed"
    [ -e dist/index.html ] || skip "the page is not built"
    [ "$1" = real ] || exec npm run --silent e2e
    exec node ../../tests/web/real/run.mjs "$2"
    ;;
  *) echo "run.sh: unknown \"$1\", wanted unit, page or real" >&2; exit 2 ;;
esac
