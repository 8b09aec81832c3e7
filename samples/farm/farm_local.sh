#!/usr/bin/env bash
# A sequence on one machine, or on several by ssh: JOBS=4 farm_local.sh INPUT -o out.####.png --frames 0..999 ...
set -euo pipefail

export PARALLEL_SHELL=/bin/bash
program=${HACHURE:-hachure}
jobs=${JOBS:-$(nproc)}

# One share per job. Each has one thread: several programs fill a machine better than one with several threads.
# --halt: when a share fails the others are stopped, and leave whole files. The same line again goes on from there.
seq "$jobs" | parallel --will-cite --jobs "$jobs" --quote --halt now,fail=1 \
  "$program" render "$@" --chunk "{}/$jobs" --resume --threads 1
