#!/bin/sh
# Installs what Tacit is built from. The one list of packages is here.
# shellcheck disable=SC2086  # lists of packages are meant to fall into words
set -eu

compilers="build-essential ccache cmake ninja-build pkg-config"
generators="default-jre-headless fastddsgen"
libraries="libboost1.81-dev libbullet-dev libcli11-dev libeigen3-dev libfastcdr-dev libfastrtps-dev
  libfmt-dev libspdlog-dev libsqlite3-dev libsqlitecpp-dev libssl-dev libtomlplusplus-dev
  libzstd-dev nlohmann-json3-dev prometheus-cpp-dev tao-pegtl-dev"
# clang is for the fuzzers alone.
tests="clang-14 libbenchmark-dev libclang-rt-14-dev libgmock-dev libgtest-dev"
# For the console's page. A Node of another origin will do.
pages="nodejs npm"
if command -v npm >/dev/null &&
  node -e 'process.exit(parseInt(process.versions.node) < 18 ? 1 : 0)' 2>/dev/null; then
  pages=
fi
packages="$compilers $generators $libraries $tests $pages"

usage() {
  cat <<END
usage: deploy/install.sh [--list] [--help]

Installs the Debian 12 packages that are missing, without questions. Run as root or with sudo at
hand. Does nothing when all are there.

  --list   print the packages and what is missing, install nothing
END
}

missing() {
  for package in $packages; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    case "$status" in installed*) ;; *) echo "$package" ;; esac
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    echo "install: not root, and there is no sudo. As root, run:" >&2
    echo "  apt-get install --no-install-recommends" $wanted >&2
    exit 1
  fi
}

wanted=$(missing)
case "${1:-}" in
  --help | -h) usage; exit 0 ;;
  --list)
    echo "wanted: " $packages
    echo "missing:" $wanted
    exit 0
    ;;
  "") ;;
  *) echo "install: unknown option \"$1\", wanted --list or --help" >&2; exit 2 ;;
esac

if ! command -v apt-get >/dev/null; then
  echo "install: there is no apt-get here; these are the Debian 12 packages to have:" >&2
  echo " " $packages >&2
  exit 1
fi

if [ -z "$wanted" ]; then
  exit 0
fi
echo "== installing:" $wanted >&2
as_root apt-get update -q >&2
as_root apt-get install -y -q --no-install-recommends -o Acquire::Retries=3 $wanted >&2
