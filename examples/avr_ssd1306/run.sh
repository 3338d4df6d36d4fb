#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# examples/avr_ssd1306/run.sh BUILD: runs the firmware in simavr until its lamp has gone round, with simavr's own model of
# the SSD1306 and ours side by side on the bus. Writes what tools/boards/table.sh reads.
set -euo pipefail

build=$1
folder=$build/boards/avr_ssd1306
clock_hz=16000000
limit_s=300

if ! timeout $limit_s "$folder/simulate" "$folder/firmware.elf" "$folder" \
    >"$folder/values.txt" 2>"$folder/errors.txt"; then
    echo "avr_ssd1306: the simulation failed; its last lines:" >&2
    tail -n 5 "$folder/values.txt" "$folder/errors.txt" >&2
    exit 1
fi
grep violation "$folder/errors.txt" >&2 || true

frame=$(awk '$1 == "frame" { last = $2 } END { print last }' "$folder/values.txt")
for panel in simavr decoder; do
    "$folder/host-picture" "$frame" "$folder/$panel.host.ppm"
done

# shellcheck disable=SC2046 # three numbers
set -- $(avr-size "$folder/firmware.elf" | awk 'NR == 2 { print $1, $2, $3 }')
awk -v hz=$clock_hz -v text="$1" -v data="$2" -v bss="$3" '
    { value[$1] = $2 }
    END {
        draw_ms = value["draw_cycles"] / value["frames"] / hz * 1000
        send_ms = value["send_cycles"] / value["frames"] / hz * 1000
        print "emulator simavr atmega1284p, cycles"
        printf "clock_mhz %d\n", hz / 1000000
        printf "frame_ms %.1f\ndraw_ms %.1f\nsend_ms %.1f\n", draw_ms + send_ms, draw_ms, send_ms
        printf "flash_bytes %d\nram_bytes %d\nstack_bytes %d\nleft_bytes %d\nframe_bytes %d\nviolations %d\n", text + data,
            data + bss, value["stack_bytes"], value["stack_free"], 128 * 64 / 8, value["violations"]
    }' "$folder/values.txt" >"$folder/report.txt"

# What the library leaves of the 16 KB is the rest of the program's.
left=$(awk '$1 == "left_bytes" { print $2 }' "$folder/report.txt")
if [ "$left" -lt 4096 ]; then
    echo "avr_ssd1306: only $left bytes of RAM are left, 4096 were promised" >&2
    rm "$folder/report.txt"
    exit 1
fi
