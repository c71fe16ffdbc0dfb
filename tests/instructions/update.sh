#!/bin/sh
# Rewrites the stored instruction counts of the compiler that a build folder uses: tests/instructions/update.sh build/release
set -eu
build=${1:?give a build folder}
cmake --build "$build" --target odemark_count_cells
cmake -DUPDATE=ON -P "$build/tests/instructions_here.cmake"
