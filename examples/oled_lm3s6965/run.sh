#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# examples/oled_lm3s6965/run.sh BUILD: boots the firmware in QEMU's lm3s6965evb, waits for one turn of the teapot, and takes
# the picture that QEMU's own model of the SSD0323 shows. Writes what tools/boards/table.sh reads.
#
# QEMU runs an instruction in a nanosecond here (-icount shift=0), and its SysTick counts the 50 MHz that the firmware
# sets: one tick is 20 instructions. Times are those of a processor that takes one cycle for each instruction, which a
# Cortex-M3 on flash with wait states does not quite reach. The serial port is not timed in QEMU, so the time of the bits
# on the wire is put in place of a shorter count.
set -euo pipefail

build=$1
folder=$build/boards/oled_lm3s6965
instructions_per_tick=20
clock_hz=50000000
ssi_hz=$((clock_hz / 14))
limit_s=60

if ! command -v qemu-system-arm >/dev/null; then
    echo "oled_lm3s6965: qemu-system-arm is missing (Debian: qemu-system-arm)" >&2
    exit 1
fi

serial=$folder/serial.txt
: >"$serial"
coproc qemu { exec qemu-system-arm -M lm3s6965evb -display none -monitor none -icount shift=0 -serial "file:$serial" \
    -qmp stdio -kernel "$folder/firmware.elf" 2>"$folder/qemu.txt"; }
pid=$qemu_PID
exec {to}>&"${qemu[1]}" {from}<&"${qemu[0]}"
trap 'kill $pid 2>/dev/null || true' EXIT

command_qemu() { # JSON: waits for its answer, events in between are passed over
    echo "$1" >&$to
    local answer
    while IFS= read -r -t 20 -u $from answer; do
        case $answer in
        *'"error"'*)
            echo "oled_lm3s6965: QEMU refuses $1: $answer" >&2
            return 1
            ;;
        *'"return"'*) return 0 ;;
        esac
    done
    echo "oled_lm3s6965: QEMU does not answer to $1" >&2
    return 1
}

command_qemu '{"execute": "qmp_capabilities"}'
end=$((SECONDS + limit_s))
until grep -q '^turned' "$serial"; do
    if grep -q '^error' "$serial" || [ $SECONDS -ge $end ] || ! kill -0 $pid 2>/dev/null; then
        echo "oled_lm3s6965: the firmware did not come to the end of its turn; its last lines, and QEMU's:" >&2
        tail -n 3 "$serial" "$folder/qemu.txt" >&2
        exit 1
    fi
    sleep 0.1
done
command_qemu "{\"execute\": \"screendump\", \"arguments\": {\"filename\": \"$folder/screen.ppm\"}}"
command_qemu '{"execute": "quit"}' || true
wait $pid 2>/dev/null || true

# The last frame of the turn: QEMU shows each pixel as a square of four.
tr -d '\r' <"$serial" >"$folder/values.txt"
frame=$(awk '$1 == "frame" { last = $2 } END { print last }' "$folder/values.txt")
"$build/boards/shrink" 4 "$folder/screen.ppm" "$folder/teapot.panel.ppm"
"$folder/host-picture" "$frame" "$folder/teapot.host.ppm"

# shellcheck disable=SC2046 # three numbers
set -- $(arm-none-eabi-size "$folder/firmware.elf" | awk 'NR == 2 { print $1, $2, $3 }')
awk -v ticks=$instructions_per_tick -v hz=$clock_hz -v ssi=$ssi_hz -v text="$1" -v data="$2" -v bss="$3" '
    $1 == "frame" { frames++ }
    $1 == "draw_cycles" { draw += $2 * ticks }
    $1 == "send_cycles" { send += $2 * ticks }
    $1 == "frame_bytes" { bytes = $2 }
    $1 == "stack_bytes" { stack = $2 }
    END {
        draw_ms = draw / frames / hz * 1000
        send_ms = send / frames / hz * 1000
        wire_ms = bytes * 8 / ssi * 1000
        send_ms = send_ms > wire_ms ? send_ms : wire_ms
        print "emulator QEMU lm3s6965evb, instructions as cycles"
        printf "clock_mhz %d\n", hz / 1000000
        printf "frame_ms %.1f\ndraw_ms %.1f\nsend_ms %.1f\n", draw_ms + send_ms, draw_ms, send_ms
        printf "flash_bytes %d\nram_bytes %d\nstack_bytes %d\nleft_bytes %d\n", text + data, data + bss, stack,
            65536 - data - bss - stack
        printf "frame_bytes %d\nviolations -\n", bytes
    }' "$folder/values.txt" >"$folder/report.txt"
