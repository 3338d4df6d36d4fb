#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Installs what the tests, the checks or the emulated targets need and the system does not have:
# tools/install-packages.sh test|verify|targets|cost|atlas|coverage|fuzz|proofs|boards
#
# Each need is probed (a command that runs, a header and library that link), so nothing is asked of the package manager
# when all is there. Says what it installs and why. Runs as root or with a sudo that asks for no password; without
# either it names the packages and the command, and ends with status 1. Plain sh: bash may be what is missing.
set -eu

stage=${1:-}
case $stage in
test | verify | targets | cost | atlas | coverage | fuzz | proofs | boards) ;;
*)
    echo "usage: tools/install-packages.sh test|verify|targets|cost|atlas|coverage|fuzz|proofs|boards" >&2
    exit 2
    ;;
esac

cc=${CC:-cc}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

has_command() {
    command -v "$1" >/dev/null 2>&1
}

# has_library PKG_CONFIG_NAME HEADERS: a program that includes the headers compiles and links.
has_library() {
    has_command pkg-config || return 1
    pkg-config --exists "$1" || return 1
    # shellcheck disable=SC2086 # several headers
    printf '#include <%s>\n' $2 >"$work/probe.c"
    echo 'int main(void) { return 0; }' >>"$work/probe.c"
    # shellcheck disable=SC2046,SC2086 # several words
    $cc "$work/probe.c" -o "$work/probe" $(pkg-config --cflags --libs "$1") >/dev/null 2>&1
}

# has_target COMMAND FLAGS HEADER: the cross compiler finds the header of its C library.
has_target() {
    has_command "$1" || return 1
    # shellcheck disable=SC2086 # flags are several words
    echo "#include <$3>" | "$1" $2 -c -x c - -o "$work/probe.o" >/dev/null 2>&1
}

# has_program COMMAND FLAGS: the cross compiler links a program with its C library.
has_program() {
    has_command "$1" || return 1
    echo 'int main(void) { return 0; }' | "$1" "$2" -x c - -o "$work/probe" >/dev/null 2>&1
}

has_compiler() {
    echo 'int main(void) { return 0; }' | "$1" -x "$2" - -o "$work/probe" >/dev/null 2>&1
}

has_sanitizers() {
    echo 'int main(void) { return 0; }' | "$1" -x c -fsanitize=address,undefined - -o "$work/probe" >/dev/null 2>&1
}

# Needs: a probe, why it is needed, and the package's name for each manager ("-" where there is none).
needs_test() {
    need "has_compiler $cc c" "compiles everything" "gcc libc6-dev" gcc gcc "gcc musl-dev" gcc gcc
    need "has_command bash" "runs the checks" bash bash bash bash bash bash
    need "has_command pkg-config" "finds the libraries" pkg-config pkgconf-pkg-config pkgconf pkgconf pkg-config pkg-config
    need "has_library cmocka stdarg.h\ stddef.h\ setjmp.h\ stdint.h\ cmocka.h" "test framework" \
        libcmocka-dev libcmocka-devel cmocka cmocka-dev libcmocka-devel cmocka
    need "has_library libpng png.h" "PNG output of the renderer" \
        libpng-dev libpng-devel libpng libpng-dev libpng16-devel libpng
    need "has_library assimp assimp/cimport.h" "scene importer (OBJ, glTF, COLLADA)" \
        libassimp-dev assimp-devel assimp assimp-dev assimp-devel assimp
    need "has_library libcjson cjson/cJSON.h" "tests of the JSON report" \
        libcjson-dev cjson-devel cjson cjson-dev cJSON-devel cjson
}

needs_verify() {
    need "has_compiler gcc c" "sanitizers, bit identity" gcc gcc gcc gcc gcc gcc
    need "has_sanitizers gcc" "sanitizers" gcc "libasan libubsan" gcc gcc gcc gcc
    need "has_compiler g++ c++" "C++ program against the installed library" g++ gcc-c++ gcc g++ gcc-c++ gcc
    need "has_compiler clang c" "second compiler" clang clang clang clang clang llvm
    need "has_command clang-tidy" "static analysis" clang-tidy clang-tools-extra clang clang-extra-tools clang-tools llvm
    need "has_command clang-format" "format check" clang-format clang-tools-extra clang clang-extra-tools clang-tools llvm
    need "has_command cppcheck" "static analysis" cppcheck cppcheck cppcheck cppcheck cppcheck cppcheck
    needs_libgpiod
    needs_cross
}

# The Linux board's kernel and libraries are Debian's packages for arm64, which are unpacked, not installed.
needs_linux_panel() {
    needs_libgpiod
    need "has_library cmocka stdarg.h\ stddef.h\ setjmp.h\ stdint.h\ cmocka.h" "test framework" \
        libcmocka-dev libcmocka-devel cmocka cmocka-dev libcmocka-devel cmocka
    need "has_library libcjson cjson/cJSON.h" "tests" libcjson-dev cjson-devel cjson cjson-dev cJSON-devel cjson
    need "python3 -m pip --version >/dev/null 2>&1" "gets the source of libgpiod 2" \
        python3-pip python3-pip python-pip py3-pip python3-pip python
    need "has_program aarch64-linux-gnu-gcc -pthread" "arm64 compiler and C library" \
        "gcc-aarch64-linux-gnu libc6-dev-arm64-cross" - aarch64-linux-gnu-gcc - - -
    need "has_command qemu-system-aarch64" "arm64 emulator" \
        qemu-system-arm qemu-system-aarch64-core qemu-system-aarch64 qemu-system-aarch64 qemu-arm qemu
    need "has_command dtc" "device tree of the emulated Linux board" device-tree-compiler dtc dtc dtc dtc dtc
    need "has_command cpio" "memory disk of the emulated Linux board" cpio cpio cpio cpio cpio cpio
}

needs_libgpiod() {
    need "has_command pkg-config" "finds the libraries" pkg-config pkgconf-pkg-config pkgconf pkgconf pkg-config pkg-config
    need "has_library libgpiod gpiod.h" "GPIO lines of Linux boards" \
        libgpiod-dev libgpiod-devel libgpiod libgpiod-dev libgpiod-devel -
}

needs_proofs() {
    need "has_compiler $cc c" "compiles the measurements" "gcc libc6-dev" gcc gcc "gcc musl-dev" gcc gcc
    need "has_command bash" "runs the proofs" bash bash bash bash bash bash
    need "has_command gappa" "proves rounding bounds" gappa gappa - - - gappa
    need "has_command z3" "proves integer identities" z3 z3 z3 z3 z3 z3
}

needs_fuzz() {
    need "has_compiler clang c" "compiles the fuzzers" clang clang clang clang clang llvm
    # Debian's clang only recommends its runtime libraries
    need "has_fuzzer" "libFuzzer and the sanitizers" "$(clang_runtime)" compiler-rt compiler-rt compiler-rt clang llvm
    need "has_library assimp assimp/cimport.h" "the importer's fuzzer" \
        libassimp-dev assimp-devel assimp assimp-dev assimp-devel assimp
}

has_fuzzer() {
    echo '#include <stddef.h>
        int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size) { return data == NULL && size; }' |
        clang -x c -fsanitize=fuzzer,address,undefined - -o "$work/probe" >/dev/null 2>&1
}

# Of the version of clang that is there, as Debian 12 has it (libclang-rt-14-dev), or of the system's own.
clang_runtime() {
    version=$(clang -dumpversion 2>/dev/null | cut -d . -f 1)
    echo "libclang-rt-${version:+$version-}dev"
}

# The processors that `make cross`, `make targets`, `make cost` and `make boards` compile for.
needs_arm() {
    need "has_target arm-none-eabi-gcc -mcpu=cortex-m0plus\ -mthumb string.h" "Cortex-M compiler and C library" \
        "gcc-arm-none-eabi libnewlib-arm-none-eabi" "arm-none-eabi-gcc-cs arm-none-eabi-newlib" \
        "arm-none-eabi-gcc arm-none-eabi-newlib" "gcc-arm-none-eabi newlib-arm-none-eabi" \
        "cross-arm-none-gcc12 cross-arm-none-newlib-devel" arm-none-eabi-gcc
}

needs_riscv() {
    # The compiler comes with its C library on most systems; Debian has picolibc beside it.
    riscv_flags="-march=rv32imac\\ -mabi=ilp32"
    if has_command riscv64-unknown-elf-gcc && [ -f "$(riscv64-unknown-elf-gcc -print-file-name=picolibc.specs)" ]; then
        riscv_flags="--specs=picolibc.specs\\ $riscv_flags"
    fi
    need "has_command riscv64-unknown-elf-gcc" "RISC-V compiler" \
        gcc-riscv64-unknown-elf riscv64-elf-gcc riscv64-elf-gcc gcc-riscv-none-elf cross-riscv64-elf-gcc12 riscv64-elf-gcc
    need "has_target riscv64-unknown-elf-gcc $riscv_flags string.h" "RISC-V C library" \
        picolibc-riscv64-unknown-elf - riscv64-elf-newlib newlib-riscv-none-elf - -
}

needs_avr() {
    need "has_target avr-gcc -mmcu=atmega1284p avr/pgmspace.h" "AVR compiler and C library" \
        "gcc-avr avr-libc" "avr-gcc avr-libc" "avr-gcc avr-libc" "gcc-avr avr-libc" "cross-avr-gcc12 avr-libc" avr-gcc
}

needs_cross() {
    needs_arm
    needs_riscv
    needs_avr
}

needs_targets() {
    need "has_compiler $cc c" "compiles for the host" "gcc libc6-dev" gcc gcc "gcc musl-dev" gcc gcc
    need "has_command bash" "runs the emulators" bash bash bash bash bash bash
    needs_cross
    need "has_program s390x-linux-gnu-gcc -static" "s390x compiler and C library (big-endian)" \
        "gcc-s390x-linux-gnu libc6-dev-s390x-cross" - - - - -
    need "has_program i686-linux-gnu-gcc -static" "32-bit x86 compiler and C library" \
        "gcc-i686-linux-gnu libc6-dev-i386-cross" - - - - -
    need "has_command qemu-system-arm" "Cortex-M emulator" \
        qemu-system-arm qemu-system-arm-core qemu-system-arm qemu-system-arm qemu-arm qemu
    need "has_command qemu-system-riscv32" "RISC-V emulator" \
        qemu-system-misc qemu-system-riscv-core qemu-system-riscv qemu-system-riscv32 qemu-extra qemu
    need "has_command qemu-s390x" "s390x emulator" qemu-user qemu-user qemu-user qemu-s390x qemu-linux-user -
    need "has_command qemu-i386" "32-bit x86 emulator" qemu-user qemu-user qemu-user qemu-i386 qemu-linux-user -
    need "has_command simavr" "AVR emulator" simavr simavr - - - simavr
}

needs_coverage() {
    need "has_compiler gcc c" "counts what runs" gcc gcc gcc gcc gcc gcc
    need "has_command gcovr" "reads the counts" gcovr gcovr gcovr gcovr - gcovr
}

needs_cost() {
    need "has_command bash" "runs the emulators" bash bash bash bash bash bash
    needs_cross
    need "has_command qemu-system-arm" "Cortex-M emulator" \
        qemu-system-arm qemu-system-arm-core qemu-system-arm qemu-system-arm qemu-arm qemu
    need "has_command qemu-system-riscv32" "RISC-V emulator" \
        qemu-system-misc qemu-system-riscv-core qemu-system-riscv qemu-system-riscv32 qemu-extra qemu
    need "has_command simavr" "AVR emulator" simavr simavr - - - simavr
    need "has_command node" "runs the RP2040 emulator" nodejs nodejs nodejs nodejs nodejs node
    need "has_command npm" "gets the RP2040 emulator, rp2040js" npm nodejs-npm npm npm npm node
}

needs_boards() {
    need "has_compiler $cc c" "compiles for the host" "gcc libc6-dev" gcc gcc "gcc musl-dev" gcc gcc
    need "has_command bash" "runs the emulators" bash bash bash bash bash bash
    need "has_command pkg-config" "finds the libraries" pkg-config pkgconf-pkg-config pkgconf pkgconf pkg-config pkg-config
    needs_arm
    needs_avr
    need "has_command qemu-system-arm" "emulates the LM3S6965 with its OLED" \
        qemu-system-arm qemu-system-arm-core qemu-system-arm qemu-system-arm qemu-arm qemu
    need "has_library simavr sim_avr.h" "emulates the ATmega1284P with its OLED" libsimavr-dev simavr-devel - - - simavr
    need "has_library libelf libelf.h" "simavr reads firmware with it" \
        libelf-dev elfutils-libelf-devel libelf elfutils-dev libelf-devel -
    need "has_command node" "runs the RP2040 emulator" nodejs nodejs nodejs nodejs nodejs node
    need "has_command npm" "gets the RP2040 emulator, rp2040js" npm nodejs-npm npm npm npm node
    needs_linux_panel
}

needs_atlas() {
    needs_cost
    need "has_command gnuplot" "plots" gnuplot-nox gnuplot gnuplot gnuplot gnuplot gnuplot
    need "has_library libpng png.h" "pictures of the page" libpng-dev libpng-devel libpng libpng-dev libpng16-devel libpng
}

manager=
for candidate in apt-get dnf pacman apk zypper brew; do
    if has_command $candidate; then
        manager=$candidate
        break
    fi
done
case $manager in
apt-get) column=3 ;; dnf) column=4 ;; pacman) column=5 ;; apk) column=6 ;; zypper) column=7 ;; brew) column=8 ;;
*) column=3 ;; # without a manager, Debian's names say best what is meant
esac

# need PROBE WHY apt dnf pacman apk zypper brew
need() {
    eval "$1" && return 0
    why=$2
    eval "names=\$$column"
    missing="$missing${missing:+; }$why"
    if [ "$names" = - ]; then
        echo "  (no package known)  $why"
        return 0
    fi
    echo "  $names  ($why)"
    for name in $names; do
        case " $packages " in *" $name "*) ;; *) packages="$packages${packages:+ }$name" ;; esac
    done
}

echo "Looking for what 'make $stage' needs ..."
packages='' missing=''
needs_$stage
if [ -z "$missing" ]; then
    echo "  all there"
    exit 0
fi
if [ -z "$packages" ]; then
    echo "Not found: $missing. Please install it." >&2
    exit 1
fi

case $manager in
apt-get) command="env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages" ;;
dnf) command="dnf install -y $packages" ;;
pacman) command="pacman -S --needed --noconfirm $packages" ;;
apk) command="apk add $packages" ;;
zypper) command="zypper --non-interactive install $packages" ;;
brew) command="brew install $packages" ;;
*)
    echo "No package manager that this script knows. Please install (Debian's names): $packages" >&2
    exit 1
    ;;
esac
as_root=
if [ "$manager" != brew ] && [ "$(id -u)" -ne 0 ]; then
    if has_command sudo && sudo -n true 2>/dev/null; then
        as_root=sudo
    else
        echo "Installing needs root. Please run:  sudo $command" >&2
        exit 1
    fi
fi

# A new machine has no package lists yet, an old one stale ones: get them when a package is not to be had.
# shellcheck disable=SC2086 # commands and packages are several words
{
    if [ "$manager" = apt-get ] && ! apt-cache show $packages >/dev/null 2>&1; then
        $as_root apt-get update -q
    fi
    echo "Installing: $command"
    if ! $as_root $command; then
        [ "$manager" = apt-get ] || exit 1
        $as_root apt-get update -q
        $as_root $command
    fi
}

echo "Looking again ..."
packages='' missing=''
needs_$stage
if [ -n "$missing" ]; then
    echo "Still missing after the installation: $missing" >&2
    exit 1
fi
echo "  all there"
