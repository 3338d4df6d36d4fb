#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs glint-panel on an emulated arm64 board under Debian's kernel, with a real libgpiod and spidev, and listens to the
# board's GPIO lines:
#
#     tests/linux_panel/emulated/run.sh BUILD JOB GPIOD CONTROLLER WxH
#
# BUILD is the build folder of the host's tools (the arm64 programs are in BUILD/arm64), JOB one of press, stop,
# failures, GPIOD 1 or 2. Prints lines "name value"; what was sent, and the pictures, stay in BUILD/linux_panel/. Status
# 1 if something is not as it should be, after a line that begins with "wrong".
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
job=$2 gpiod=$3 controller=$4 size=$5
scene=${SCENE:-teapot}
decoder=${DECODER:-$build/glint-panel-decode}
limit_s=${LIMIT_S:-300}
name=linux_${controller}_${job}
work=$build/linux_panel/$job-$controller-gpiod$gpiod
root=$build/arm64/root
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
mkdir -p "$work"/initramfs/{bin,dev,proc,sys,tmp,etc,lib} "$work/pictures"
cp "$here/init" "$build/arm64/glint-panel-gpiod$gpiod" "$work/initramfs/"
mv "$work/initramfs/glint-panel-gpiod$gpiod" "$work/initramfs/glint-panel"
cp "$root/bin/busybox" "$root/usr/bin/gpioinfo" "$root/usr/bin/gpioset" "$work/initramfs/bin/"
cp "$root"/lib/modules/*/kernel/drivers/spi/spi-{gpio,bitbang}.ko "$work/initramfs/"
cp -L "$root"/lib/ld-linux-aarch64.so.1 "$root"/lib/aarch64-linux-gnu/{libc,libm}.so.6 \
    "$root"/usr/lib/aarch64-linux-gnu/libgpiod.so.2 "$work/initramfs/lib/"
{
    echo "PROGRAM='$scene --controller $controller --size $size --dc DC --reset RESET --backlight BACKLIGHT'"
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
exec 3<>"$work/monitor.in"

machine_run() {
    timeout "$limit_s" qemu-system-aarch64 "${machine[@]}" -kernel "$root"/boot/vmlinuz-* -initrd "$work/initramfs.cpio" \
        -dtb "$work/board.dtb" -append "console=ttyAMA0 quiet panic=-1" -no-reboot -serial stdio \
        -chardev pipe,id=monitor,path="$work/monitor" -mon monitor \
        -trace pl061_set_output -msg timestamp=on -D "$work/trace" 2>>"$work/qemu.log" </dev/null
}

# Reads the console and keeps what init tells: see there.
status= stopping= shown= file=
: >"$work/lines" >"$work/output" >"$work/failures"
while IFS= read -r line; do
    line=${line%$'\r'}
    printf '%s\n' "$line" >>"$work/console.log"
    if [ -n "$file" ]; then
        if [ "$line" = END ]; then
            base64 -d "$work/file" | gunzip >"$work/pictures/$file"
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
    STOPPING) stopping=$(date +%s%N) ;;
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
exec 3>&-
wait "$listener" || wrong "the trace could not be read: $(cat "$work/events.log")"

[ "$status" = 0 ] || wrong "glint-panel ended with status '$status': $(cat "$work/output" "$work/qemu.log")"
held=$(grep -c glint-panel "$work/lines" || true)
free=$(grep -cE '"(DC|RESET|BACKLIGHT|BUTTON)" +unused' "$work/lines" || true)
[ "$held" -eq 0 ] && [ "$free" -eq 4 ] || wrong "lines are not released: $(cat "$work/lines")"
say lines_released "$free"

# ---------------------------------------------------------------------------------------------------------- what was sent

# decode NAME OPTIONS: the picture that the panel shows, and the protocol's violations.
decode() {
    local picture=$1
    shift
    "$decoder" --controller "$controller" --size "$size" -o "$work/pictures/$picture" "$@" <"$work/events" \
        >"$work/decoded" || true
}

# expect NAME TURN: the picture that the library draws on the host.
expect() {
    "$build/glint-render" "$scene" --size "$size" --format rgb565 --tolerance 1 --turn "$2" -o "$work/pictures/$1"
}

same() {
    cmp -s "$work/pictures/$1" "$work/pictures/$2" || wrong "$1 and $2 differ"
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

if [ "$job" = press ]; then
    expect expected-1.ppm 0
    expect expected-2.ppm 22.5
    decode panel-1.ppm --at "$shown"
    decode panel-2.ppm
    check_violations
    for frame in 1 2; do
        same "panel-$frame.ppm" "expected-$frame.ppm"
        same "frame-$frame.ppm" "expected-$frame.ppm"
    done
    ! cmp -s "$work/pictures/expected-1.ppm" "$work/pictures/expected-2.ppm" || wrong "the press changes nothing"
    sed -n "s/^frame/${name}_frame/p" "$work/output"
elif [ "$job" = stop ]; then
    expect expected-1.ppm 0
    expect expected-2.ppm 2.8125
    decode panel-stopping.ppm --at "$stopping"
    decode panel-end.ppm
    check_violations
    # in mid-frame: the second frame down to some pixel, from there on still the first
    at=$({ cmp "$work"/pictures/{panel-stopping,expected-2}.ppm || true; } | awk '{ sub(",", "", $5); print $5 }')
    [ -n "$at" ] || wrong "the second frame was complete when the signal came"
    cmp -s -i $((${at:-1} - 1)) "$work"/pictures/{panel-stopping,expected-1}.ppm || wrong "neither frame 1 nor 2"
    ! cmp -s "$work"/pictures/{panel-stopping,expected-1}.ppm || wrong "nothing of the second frame was sent"
    [ "$(tail -c +16 "$work/pictures/panel-end.ppm" | tr -d '\0' | wc -c)" -eq 0 ] || wrong "the panel is not dark"
    say frame_2_sent_percent $((100 * ${at:-1} / $(wc -c <"$work/pictures/expected-1.ppm")))
elif [ "$job" = failures ]; then
    cat "$work/failures"
fi
[ "$wrong" -ne 0 ] || rm -f "$work/events" "$work/initramfs.cpio"
exit "$wrong"
