#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The table of `make boards`: tools/boards/table.sh BUILD BOARD...
#
# For each board, what examples/BOARD/run.sh left in BUILD/boards/BOARD: pictures TITLE.panel.ppm, which have to be the
# same bytes as TITLE.host.ppm, and report.txt with these lines (a "-" for what a board does not have):
#
#     emulator NAME      what ran it
#     clock_mhz N        the nominal clock of the processor that the times are for
#     frame_ms N         one frame, from the beginning of its drawing to the end of its sending
#     draw_ms N          the time of a frame in which the library draws
#     send_ms N          the time of a frame in which the panel is sent something
#     flash_bytes N      the whole program
#     ram_bytes N        static: variables and the library's memory
#     stack_bytes N      most that was used
#     left_bytes N       RAM that neither of these took
#     frame_bytes N      sent to the panel for a frame
#     violations N       of the panel's data sheet, found by tests/panel
#
# Ends with status 1 if a picture differs or is missing, a report is missing, or a violation was found.
set -euo pipefail

build=$1
shift
status=0

value() { # REPORT NAME
    awk -v name="$2" '$1 == name { $1 = ""; print substr($0, 2); found = 1; exit } END { if (!found) print "-" }' "$1"
}

# "N equal", or what is wrong
compare() { # FOLDER
    local equal=0 wrong=0 panel host
    for panel in "$1"/*.panel.ppm; do
        host=${panel%.panel.ppm}.host.ppm
        if [ -s "$panel" ] && [ -s "$host" ] && cmp -s "$panel" "$host"; then
            equal=$((equal + 1))
        else
            wrong=$((wrong + 1))
        fi
    done
    if [ $wrong -gt 0 ]; then
        echo "$wrong DIFFER"
    else
        echo "$equal equal"
    fi
}

row='%-15s%-10s%9s%10s%9s%9s%5s%9s%8s%7s%8s%8s%11s  %s\n'
# shellcheck disable=SC2059 # the row's format
printf "$row" board pictures frames/s 'frame ms' drawing sending MHz flash RAM stack left bytes forbidden 'run on'
for board in "$@"; do
    folder=$build/boards/$board
    report=$folder/report.txt
    if [ ! -s "$report" ]; then
        printf '%-15s%s\n' "$board" "FAILED: no report"
        status=1
        continue
    fi
    pictures=$(compare "$folder")
    violations=$(value "$report" violations)
    case $pictures in *DIFFER) status=1 ;; esac
    case $violations in 0 | -) ;; *) status=1 ;; esac
    frame_ms=$(value "$report" frame_ms)
    fps=$(awk -v ms="$frame_ms" 'BEGIN { if (ms > 0) printf "%.1f", 1000 / ms; else print "-" }')
    # shellcheck disable=SC2059
    printf "$row" "$board" "$pictures" "$fps" "$frame_ms" "$(value "$report" draw_ms)" "$(value "$report" send_ms)" \
        "$(value "$report" clock_mhz)" "$(value "$report" flash_bytes)" "$(value "$report" ram_bytes)" \
        "$(value "$report" stack_bytes)" "$(value "$report" left_bytes)" "$(value "$report" frame_bytes)" \
        "$violations" "$(value "$report" emulator)"
done
cat <<'EOF'

Pictures: those taken from the emulated panel that are the same bytes as what the host draws for that display. RAM is
static, with the library's memory; stack is the most that was used; left is what neither took; bytes are sent to the
panel for a frame; forbidden is what tests/panel found against the panel's data sheet. A - is what a board's emulator
does not tell.
EOF
[ $status -eq 0 ] || echo "FAILED: see above" >&2
exit $status
