#!/usr/bin/env bash
# Runs every fuzzer of a build for so many seconds, seeded with the repository's scenes and designs.
set -euo pipefail
[ $# = 2 ] || { echo "usage: tests/fuzz/run.sh BUILD SECONDS"; exit 2; }
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd) seconds=$2
mkdir -p "$build/found"
status=0
for target in scene asc gem gcs; do
  case $target in
    scene) seeds=$(find "$root" -path "$build" -prune -o \( -name '*.spar' -o -name '*.inc' -o -name '*.pov' \) -print) ;;
    *) seeds=$(find "$root/scenes" "$root/tests" -name "*.$target") ;;
  esac
  mkdir -p "$build/corpus/$target"
  if [ -d "$root/tests/fuzz/corpus/$target" ]; then cp "$root/tests/fuzz/corpus/$target"/* "$build/corpus/$target"; fi
  for seed in $seeds; do
    cp "$seed" "$build/corpus/$target/$(echo "${seed#"$root"/}" | tr / _)"
  done
  dictionary=()
  [ "$target" != scene ] || dictionary=(-dict="$root/tests/fuzz/spar.dict")
  nice "$build/tests/fuzz/fuzz_$target" "${dictionary[@]}" -max_total_time="$seconds" -timeout=5 \
    -rss_limit_mb=1024 -max_len=65536 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="$build/found/$target-" "$build/corpus/$target" || status=1
done
exit $status
