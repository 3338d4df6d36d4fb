#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs glint-panel on an emulated arm64 board under Debian's kernel, with a real libgpiod and spidev, and listens to the
# board's GPIO lines:
#
#     tests/linux_panel/emulated/run-job.sh BUILD JOB GPIOD CONTROLLER WxH [X,Y [DEGREES]]
#
# BUILD is the build folder of the host's tools (the arm64 programs are in BUILD/boards/linux_panel/arm64), JOB one of
# press, stop, failures, GPIOD 1 or 2; then the panel's size, its offset and rotation. Prints lines "name value", leaves
# pictures in BUILD/boards/linux_panel (CONTROLLER-WHEN.panel.ppm beside .host.ppm), and all it saw in a folder of the
# job there. Status 1 if something is not as it should be, after a line that begins with "wrong".
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
job=$2 gpiod=$3 controller=$4 size=$5 offset=${6:-0,0} rotation=${7:-0}
scene=${SCENE:-teapot}
limit_s=${LIMIT_S:-300}
folder=$build/boards/linux_panel
name=${job}_${controller}_gpiod$gpiod
work=$folder/$name
arm64=$folder/arm64
root=$arm64/root
wrong=0

say() {
    printf '%s_%s %s\n' "$name" "$1" "$2"
}

wrong() {
    printf 'wrong %s: %s\n' "$name" "$*"
    wrong=1
}

# ----------------------------------------------------------------------------------------------------------- the machine

rm -rf "$work"
mkdir -p "$work"/initramfs/{bin,dev,proc,sys,tmp,etc,lib}
cp "$here/init" "$work/initramfs/"
cp "$arm64/glint-panel-gpiod$gpiod" "$work/initramfs/glint-panel"
cp "$root/bin/busybox" "$root/usr/bin/gpioinfo" "$root/usr/bin/gpioset" "$work/initramfs/bin/"
cp "$root"/lib/modules/*/kernel/drivers/spi/spi-{gpio,bitbang}.ko "$work/initramfs/"
cp -L "$root"/lib/ld-linux-aarch64.so.1 "$root"/lib/aarch64-linux-gnu/{libc,libm}.so.6 \
    "$root"/usr/lib/aarch64-linux-gnu/libgpiod.so.2 "$work/initramfs/lib/"
{
    printf "PROGRAM='%s --controller %s --size %s --offset %s --rotate %s" \
        "$scene" "$controller" "$size" "$offset" "$rotation"
    echo " --dc DC --reset RESET --backlight BACKLIGHT'"
    cat "$here/job-$job"
} >"$work/initramfs/job"
(cd "$work/initramfs" && find . | cpio --quiet -o -H newc) >"$work/initramfs.cpio"
rm -rf "$work/initramfs"

machine=(-M virt -cpu cortex-a53 -m 256 -nic none -display none)
qemu-system-aarch64 "${machine[@]}" -M dumpdtb="$work/virt.dtb" 2>"$work/qemu.log"
{
    dtc -q -I dtb -O dts "$work/virt.dtb"
    cat "$here/board.dtsi"
} | dtc -q -I dts -O dtb -o "$work/board.dtb"

# --------------------------------------------------------------------------------------------------------------- the run

mkfifo "$work/trace" "$work/monitor.in" "$work/monitor.out"
"$build/pl061-events" <"$work/trace" >"$work/events" 2>"$work/events.log" &
listener=$!
cat "$work/monitor.out" >"$work/monitor.log" &
monitor=$!
trap 'kill $monitor 2>/dev/null || true' EXIT
# Held open from here too, so that nobody waits for an emulator that did not start.
exec 3<>"$work/monitor.in" 4<>"$work/trace"

machine_run() {
    timeout "$limit_s" qemu-system-aarch64 "${machine[@]}" -kernel "$root"/boot/vmlinuz-* -initrd "$work/initramfs.cpio" \
        -dtb "$work/board.dtb" -append "console=ttyAMA0 quiet panic=-1" -no-reboot -serial stdio \
        -chardev pipe,id=monitor,path="$work/monitor" -mon monitor \
        -trace pl061_set_output -msg timestamp=on -D "$work/trace" 2>>"$work/qemu.log" </dev/null
}

# Reads the console and keeps what init tells: see there.
status= shown= file=
: >"$work/lines" >"$work/output" >"$work/failures"
while IFS= read -r line; do
    line=${line%$'\r'}
    printf '%s\n' "$line" >>"$work/console.log"
    if [ -n "$file" ]; then
        if [ "$line" = END ]; then
            base64 -d "$work/file" | gunzip >"$work/$file"
            file=
        else
            printf '%s\n' "$line" >>"$work/file"
        fi
        continue
    fi
    case $line in
    "SHOWN 1")
        shown=$(date +%s%N)
        [ "$job" != press ] || echo system_powerdown >&3 # a pulse of 0.1 s on line 3
        ;;
    "FILE "*)
        file=${line#FILE }
        : >"$work/file"
        ;;
    "STATUS "*) status=${line#STATUS } ;;
    "LINE "*) printf '%s\n' "${line#LINE }" >>"$work/lines" ;;
    "OUTPUT "*) printf '%s\n' "${line#OUTPUT }" >>"$work/output" ;;
    "FAILURE "*) printf '%s\n' "${line#FAILURE }" >>"$work/failures" ;;
    DONE) break ;;
    esac
done < <(machine_run)
exec 3>&- 4>&-
wait "$listener" || wrong "the trace could not be read: $(cat "$work/events.log")"

[ "$status" = 0 ] || wrong "glint-panel ended with status '$status': $(cat "$work/output" "$work/qemu.log")"
held=$(grep -c glint-panel "$work/lines" || true)
free=$(grep -cE '"(DC|RESET|BACKLIGHT|BUTTON)" +unused' "$work/lines" || true)
[ "$held" -eq 0 ] && [ "$free" -eq 4 ] || wrong "lines are not released: $(cat "$work/lines")"
say lines_released "$free"

# ---------------------------------------------------------------------------------------------------------- what was sent

# decode FILE OPTIONS: the picture that the panel shows, upright, and the protocol's violations.
decode() {
    local picture=$1
    shift
    "$build/glint-panel-decode" --controller "$controller" --size "$size" --offset "$offset" \
        --turned $(((360 - rotation) % 360)) -o "$picture" "$@" >"$work/decoded" || true
}

# expect FILE TURN: the picture that the library draws on the host.
expect() {
    local upright=$size
    [ $((rotation % 180)) -eq 0 ] || upright=${size#*x}x${size%x*}
    "$build/glint-render" "$scene" --size "$upright" --format rgb565 --tolerance 1 --turn "$2" -o "$1"
}

same() {
    cmp -s "$1" "$2" || wrong "$1 and $2 differ"
}

differ() {
    ! cmp -s "$1" "$2" || wrong "$1 and $2 are the same"
}

count() {
    awk -v name="$1" '$1 == name { print $2 }' "$work/decoded"
}

check_violations() {
    [ "$(count violations)" = 0 ] || wrong "$(cat "$work/decoded")"
    say violations "$(count violations)"
    say transitions "$(wc -l <"$work/events")"
    say bytes "$(count bytes)"
}

pictures=$folder/$controller
case $job in
press)
    for moment in before after; do
        rm -f "$pictures-$moment".*.ppm
    done
    expect "$pictures-before.host.ppm" 0
    expect "$pictures-after.host.ppm" 22.5
    awk -v end="$shown" '$1 <= end' "$work/events" | decode "$pictures-before.panel.ppm"
    say first_frame_bytes "$(count bytes)"
    decode "$pictures-after.panel.ppm" <"$work/events"
    check_violations
    differ "$pictures-before.host.ppm" "$pictures-after.host.ppm"
    same "$pictures-before.panel.ppm" "$pictures-before.host.ppm"
    same "$pictures-after.panel.ppm" "$pictures-after.host.ppm"
    same "$work/frame-1.ppm" "$pictures-before.host.ppm" # what --dump wrote
    same "$work/frame-2.ppm" "$pictures-after.host.ppm"
    # of the emulation, not of a board: bit-banging every edge through it takes a hundred times as long
    sed -nE "s/^frame ([0-9]+): .* drawn in ([0-9.]+) ms, ([0-9]+) of .* sent in ([0-9.]+) ms, .*/\
${name}_frame_\1_draw_ms \2\n${name}_frame_\1_bands_sent \3\n${name}_frame_\1_send_ms \4/p" "$work/output"
    ;;
stop)
    expect "$work/expected-1.ppm" 0
    expect "$work/expected-2.ppm" 2.8125
    # the first thing that blanking does is to turn the backlight off
    blanked=$(awk '$2 == "backlight" && $3 == 0 { at = $1 } END { print at }' "$work/events")
    decode "$work/stopped.ppm" --at $((blanked - 1)) <"$work/events"
    decode "$work/end.ppm" <"$work/events"
    check_violations
    # in mid-frame: the second frame down to some pixel, from there on still the first
    at=$({ cmp "$work/stopped.ppm" "$work/expected-2.ppm" || true; } | sed 's/.*byte \([0-9]*\),.*/\1/')
    [ -n "$at" ] || wrong "the second frame was complete when the signal came"
    cmp -s -i $((${at:-1} - 1)) "$work/stopped.ppm" "$work/expected-1.ppm" || wrong "neither frame 1 nor 2 was shown"
    differ "$work/stopped.ppm" "$work/expected-1.ppm"
    [ "$(tail -c +16 "$work/end.ppm" | tr -d '\0' | wc -c)" -eq 0 ] || wrong "the panel is not dark at the end"
    say frame_2_percent_when_stopped $((100 * ${at:-1} / $(wc -c <"$work/expected-1.ppm")))
    ;;
failures)
    while read -r what expected pattern; do
        line=$(grep "^$what " "$work/failures" || true)
        # shellcheck disable=SC2053,SC2254 # a pattern
        case $line in
        "$what $expected "$pattern) say "$what" told ;;
        *) wrong "$what: expected $expected $pattern, got: ${line:-nothing}" ;;
        esac
    done < <(grep -v '^#' "$here/failures.txt")
    ;;
esac
# trace and memory disk are large, and of use only to find what was wrong
[ "$wrong" -ne 0 ] || rm -f "$work/events" "$work/initramfs.cpio"
exit "$wrong"
