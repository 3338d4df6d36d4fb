#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# examples/pico_st7789/run.sh BUILD: boots the UF2 file on rp2040js, see emulate.js, until a few frames are on the
# panel, and takes the pictures of the first and of the last from what was sent. Writes what tools/boards/table.sh reads.
set -euo pipefail

build=$1
folder=$build/boards/pico_st7789
frames=3
pixels_bytes=$((240 * 240 * 2))
chip_ram_bytes=$((264 * 1024))

if ! command -v node >/dev/null; then
    echo "pico_st7789: node is missing, which runs the emulator (Debian: nodejs)" >&2
    exit 1
fi

events=$folder/events.txt
values=$folder/values.txt
node examples/pico_st7789/emulate.js "$build/cost/node" "$folder/firmware.uf2" --frames $frames --events "$events" \
    >"$values"

# Whole frames that were sent before the one of the animation that is told of first: each speed's three of measuring.
measured=$(awk '$1 == "sending_us" { n += 3 } END { print n }' "$values")
decode() { # FRAMES SENT, TITLE
    "$build/glint-panel-decode" --controller st7789 --size 240x240 --frame "$1" -o "$folder/$2.panel.ppm" <"$events" \
        >"$folder/decoded.txt" || true
}
shown=$(awk '$1 == "frame" { print $2 }' "$values" | head -n 1)
decode $((measured + 1)) first
"$folder/host-picture" "$shown" "$folder/first.host.ppm"
shown=$(awk '$1 == "frame" { last = $2 } END { print last }' "$values")
decode $((measured + frames)) last
"$folder/host-picture" "$shown" "$folder/last.host.ppm"

awk -v violations="$(awk '$1 == "violations" { print $2 }' "$folder/decoded.txt")" -v bytes=$pixels_bytes \
    -v ram=$chip_ram_bytes '
    { value[$1] = $2 } # of both speeds the second, at which it goes on
    $1 == "frame_us" { sum += $2; count++ }
    END {
        print "emulator rp2040js, flash cache modelled"
        printf "clock_mhz %d\n", value["clk_sys_hz"] / 1000000
        printf "frame_ms %.1f\ndraw_ms %.1f\nsend_ms %.1f\n", sum / count / 1000, value["drawing_us"] / 1000,
            value["sending_us"] / 1000
        printf "flash_bytes %d\nram_bytes %d\nstack_bytes %d\nframe_bytes %d\nviolations %s\n", value["flash_bytes"],
            value["ram_bytes"], value["stack_bytes"], bytes, violations == "" ? "unknown" : violations
        printf "left_bytes %d\n", ram - value["ram_bytes"]
    }' "$values" >"$folder/report.txt"

echo "pico_st7789: a frame drawn, sent, one after the other, at once (ms), share of the larger of the two:"
awk '{ value[$1] = $2 / 1000 }
    $1 == "at_once_us" {
        larger = value["drawing_us"] > value["sending_us"] ? value["drawing_us"] : value["sending_us"]
        printf "  SPI %5.1f MHz %8.1f %8.1f %8.1f %8.1f   %.3f\n", value["spi_khz"], value["drawing_us"],
            value["sending_us"], value["in_turn_us"], value["at_once_us"], value["at_once_us"] / larger
    }' "$values"
