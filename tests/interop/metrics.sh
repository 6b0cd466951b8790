#!/bin/sh
# Prometheus's own promtool on what the console tells it: metrics.sh CONSOLE. Exits with 77 without.
set -eu
command -v promtool >/dev/null || { echo "skipped: promtool is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'kill "$console" 2>/dev/null || true; rm -rf "$folder"' EXIT
"$1" serve --port 0 --runs "$folder/runs" --cases "$folder/cases.db" >"$folder/address" 2>"$folder/log" &
console=$!
for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
  [ -s "$folder/address" ] && break
  sleep 0.1
done
node -e '
  const url = require("fs").readFileSync(process.argv[1], "utf8").trim();
  fetch(url + "api/health").then(() => fetch(url + "metrics")).then((a) => a.text()).then((t) => process.stdout.write(t));
' "$folder/address" | promtool check metrics
