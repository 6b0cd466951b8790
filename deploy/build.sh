#!/bin/sh
# Configures and builds; installs what is missing first.
set -eu
cd "$(dirname "$0")/.."

usage() {
  cat <<END
usage: deploy/build.sh [--no-install] [--preset NAME] [TARGET...]

Builds TARGETs, or everything, in build/NAME. The programs lie in build/NAME/bin.

  --no-install    do not call apt-get
  --preset NAME   dev, release (default), asan, tsan or coverage
END
}

install=yes
preset=release
while [ $# -gt 0 ]; do
  case "$1" in
    --help | -h) usage; exit 0 ;;
    --no-install) install=no ;;
    --preset)
      preset="${2:?wanted a name after --preset}"
      shift
      ;;
    -*) echo "build: unknown option \"$1\", see --help" >&2; exit 2 ;;
    *) break ;;
  esac
  shift
done
case "$preset" in
  dev | release | asan | tsan | coverage) ;;
  *) echo "build: unknown preset \"$preset\", wanted dev, release, asan, tsan or coverage" >&2; exit 2 ;;
esac

# One compiler can need 1.5 GB.
jobs() {
  by_memory=$(awk '/^MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo 2>/dev/null || echo 1)
  by_processors=$(nproc)
  [ "$by_memory" -ge 1 ] || by_memory=1
  [ "$by_memory" -lt "$by_processors" ] && echo "$by_memory" || echo "$by_processors"
}

# The page is built when what it is made from has changed. Without it everything else works.
build_page() {
  if ! command -v npm >/dev/null; then
    echo "== page: left out, there is no npm" >&2
    return
  fi
  made=console/web/dist/index.html
  if [ -e "$made" ] && [ -z "$(find console/web -path console/web/node_modules -prune -o \
      -path console/web/dist -prune -o -type f -newer "$made" -print | head -n 1)" ]; then
    return
  fi
  echo "== page: console/web" >&2
  (cd console/web && npm ci --no-audit --no-fund --loglevel=error >&2 && npm run --silent build >&2) ||
    echo "== page: left out, it could not be built" >&2
}

[ "$install" = no ] || deploy/install.sh
if [ ! -e "build/$preset/build.ninja" ]; then
  echo "== configuring build/$preset" >&2
  cmake --preset "$preset" >&2
fi
if [ $# -eq 0 ] || [ "$1" = console ] || [ "$1" = tacit ]; then build_page; fi
echo "== building build/$preset" >&2
if [ $# -gt 0 ]; then
  cmake --build "build/$preset" -j "$(jobs)" --target "$@" >&2
else
  cmake --build "build/$preset" -j "$(jobs)" >&2
fi
