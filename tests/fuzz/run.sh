#!/usr/bin/env bash
# Runs every fuzzer of a build for so many seconds of the processor's time, seeded with the repository's scenes and designs.
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
  nice "$build/tests/fuzz/fuzz_$target" "${dictionary[@]}" -timeout=5 \
    -rss_limit_mb=1024 -max_len=65536 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="$build/found/$target-" "$build/corpus/$target" &
  fuzzer=$!
  trap 'kill $fuzzer' EXIT
  # Fields 14 and 15 are ticks in the program and in the kernel; SIGUSR1 asks for an orderly end.
  while ticks=$(cut -d ' ' -f 14,15 "/proc/$fuzzer/stat" 2>/dev/null) && [ -n "$ticks" ]; do
    used=$(((${ticks/ /+}) / $(getconf CLK_TCK)))
    [ "$used" -lt "$seconds" ] || kill -USR1 $fuzzer 2>/dev/null || true
    sleep 1
  done
  wait $fuzzer || status=1
  trap - EXIT
  echo "$target: $used s of the processor"
done
exit $status
