#!/bin/sh
# run.sh SERVER_PROGRAM FOLDER: installs Foxglove's client in FOLDER and lets it try the server.
# Says "skipped: ..." when there is no node, or nothing to install it from.
set -eu
program=$1
folder=$2
here=$(cd "$(dirname "$0")" && pwd)

for tool in node npm; do
  if ! command -v $tool >/dev/null; then
    echo "skipped: no $tool; packages nodejs and npm have it"
    exit 0
  fi
done
mkdir -p "$folder"
cp "$here/package.json" "$here/package-lock.json" "$here/client.mjs" "$folder"
cd "$folder"
if ! cmp -s package-lock.json node_modules/.installed; then
  if ! npm ci --ignore-scripts --prefer-offline --no-audit --no-fund >npm.log 2>&1; then
    cat npm.log
    echo "skipped: npm could not install @foxglove/ws-protocol and ws"
    exit 0
  fi
  cp package-lock.json node_modules/.installed
fi
exec node client.mjs "$program"
