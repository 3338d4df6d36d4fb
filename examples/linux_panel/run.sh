#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# examples/linux_panel/run.sh BUILD, for `make boards`: the tests of glint-panel on a board of fakes, then glint-panel on
# an emulated arm64 board. Both controllers, both versions of libgpiod, upright and turned; a press of a button, SIGINT in
# mid-frame, each failure. Prints lines "name value" and leaves them, the report and the pictures in
# BUILD/boards/linux_panel.
set -euo pipefail
build=$1
top=$(cd "$(dirname "$0")/../.." && pwd)
jobs=$top/tests/linux_panel/emulated
folder=$build/boards/linux_panel

"$top/tools/check-tests.sh" 2 "$build"/tests/linux_panel/test_*-gpiod[12]

# Two at a time: the emulator of each takes a processor.
run() {
    local name
    name=$(echo "$*" | tr ' ' '-')
    "$jobs/run-job.sh" "$build" "$@" >"$folder/$name.txt" 2>&1 || echo "wrong $*: status $?" >>"$folder/$name.txt"
}
rm -f "$folder"/*.txt
{
    run press 1 st7789 240x240
    run stop 2 st7789 135x240 52,40
    run failures 1 st7789 16x16
} &
first=$!
{
    run press 2 ili9341 240x320 0,0 90
    run failures 2 st7789 16x16
} &
wait $first $!
cat "$folder"/*.txt | tee "$folder/all"
if grep -q '^wrong' "$folder/all"; then
    exit 1
fi

{
    echo "emulator QEMU, $(cat "$folder/arm64/kernel")"
    echo "flash_bytes $(stat -c %s "$folder/arm64/glint-panel-gpiod1")"
    # what the bytes take at the ST7789's default clock, 32 MHz: the emulated board bit-bangs
    awk '$1 == "press_st7789_gpiod1_first_frame_bytes" { printf "send_ms %.1f\n", $2 * 8 / 32e3 }' "$folder/all"
    echo "frame_bytes $(awk '$1 == "press_st7789_gpiod1_first_frame_bytes" { print $2 }' "$folder/all")"
    echo "violations $(awk '$1 ~ /_violations$/ { sum += $2 } END { print sum + 0 }' "$folder/all")"
} >"$folder/report.txt"
