#!/bin/sh
# Six robots that learn guard a target, over DDS; ends with the table of metrics.
set -eu
cd "$(dirname "$0")/.."

usage() {
  cat <<END
usage: deploy/demo.sh [--no-install] [--preset NAME] [--speed X] [--no-page] [-- OPTION...]

Installs what is missing, builds, serves a page to watch it on, and runs
  tacit run guard --robots 6 --learner lm --strategy 1 --seed 7
The second time it goes straight to the run. At a terminal the page stays afterwards, until Ctrl-C.

  --no-install    do not call apt-get
  --speed X       times real time, or max (default 20)
  --no-page       only the run
  --preset NAME   dev, release (default), asan, tsan or coverage
  -- OPTION...    more options for \`tacit run\`, as in: deploy/demo.sh -- --duration 60
END
}

install=
preset=release
speed=20
watch=yes
while [ $# -gt 0 ]; do
  case "$1" in
    --help | -h) usage; exit 0 ;;
    --no-install) install=--no-install ;;
    --preset)
      preset="${2:?wanted a name after --preset}"
      shift
      ;;
    --speed)
      speed="${2:?wanted a number after --speed}"
      shift
      ;;
    --no-page) watch=no ;;
    --) shift; break ;;
    *) echo "demo: unknown option \"$1\", see --help" >&2; exit 2 ;;
  esac
  shift
done

deploy/build.sh $install --preset "$preset" tacit world_server robot_agent console wizard_service
programs="build/$preset/bin"
address=$(mktemp)
page=
end_page() {
  [ -z "$page" ] || kill "$page" 2>/dev/null || true
  rm -f "$address"
}
trap end_page EXIT
trap 'exit 130' INT TERM

if [ "$watch" = yes ]; then
  "$programs/tacit" console --port 0 --runs runs >"$address" 2>/dev/null &
  page=$!
  for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    [ -s "$address" ] && break
    sleep 0.1
  done
  echo "== watch it at $(cat "$address")" >&2
fi
echo "== tacit run guard --robots 6 --learner lm --strategy 1 --seed 7 --speed $speed $*" >&2
"$programs/tacit" run guard --robots 6 --learner lm --strategy 1 --seed 7 --speed "$speed" "$@"
if [ -n "$page" ] && [ -t 0 ]; then
  echo "== the page stays at $(cat "$address"), where missions can be planned; Ctrl-C ends" >&2
  wait "$page"
fi
