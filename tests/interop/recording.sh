#!/bin/sh
# recording.sh TACIT FOLDER: records short runs and has them read by other people's programs. FOLDER
# is where those are installed. 77 when that cannot be.
set -eu

tacit=$1
folder=$2
here=$(dirname "$0")

if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  echo "skipped: there is no node with npm here"
  exit 77
fi
mkdir -p "$folder"
cp "$here/package.json" "$here/package-lock.json" "$here"/*.mjs "$folder"
if [ ! -d "$folder/node_modules" ] ||
  ! cmp -s "$folder/package-lock.json" "$folder/node_modules/installed"; then
  if ! (cd "$folder" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error); then
    echo "skipped: npm ci does not work here"
    exit 77
  fi
  cp "$folder/package-lock.json" "$folder/node_modules/installed"
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

check() {
  run=$scratch/$1
  shift
  "$tacit" run "$@" --quiet --record --out "$run" >/dev/null
  "$tacit" replay "$run" --info --json >"$run.json"
  "$tacit" replay "$run" --csv >"$run.csv"
  node "$folder/check_recording.mjs" "$run/run.mcap" "$run.json" "$run.csv"
}

check one guard --duration 60 --one-process
check dds guard --duration 900
check ticks guard --duration 60 --trajectories
check forage forage --duration 60 --one-process
check operation "$here/../../deploy/missions/biohazard.cdl" \
  --map "$here/../../deploy/maps/office.ovl" --duration 60 --one-process
