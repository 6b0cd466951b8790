#!/bin/sh
# Six robots that learn guard a target, over DDS; ends with the table of metrics.
set -eu
cd "$(dirname "$0")/.."

usage() {
  cat <<END
usage: deploy/demo.sh [--no-install] [--preset NAME] [-- OPTION...]

Installs what is missing, builds, and runs
  tacit run guard --robots 6 --learner lm --strategy 1 --seed 7
The second time it goes straight to the run.

  --no-install    do not call apt-get
  --preset NAME   dev, release (default), asan, tsan or coverage
  -- OPTION...    more options for \`tacit run\`, as in: deploy/demo.sh -- --duration 60
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
    *) echo "demo: unknown option \"$1\", see --help" >&2; exit 2 ;;
  esac
  shift
done

deploy/build.sh $install --preset "$preset" tacit world_server robot_agent console
echo "== tacit run guard --robots 6 --learner lm --strategy 1 --seed 7 $*" >&2
exec "build/$preset/bin/tacit" run guard --robots 6 --learner lm --strategy 1 --seed 7 "$@"
