// SPDX-License-Identifier: MIT
//
// Boots a UF2 file on the RP2040 of rp2040js (npm) as a Raspberry Pi Pico would, and writes what the panel's wires do:
//
//     node emulate.js FOLDER PICO.uf2 --frames N --events FILE     FOLDER holds node_modules/rp2040js
//     ... --hot BYTES --elf PICO.elf          and prints the lines of hot_code.ld, functions of so many bytes
//
// It ends when the firmware has told of N frames, and prints what that told over the UART, lines of a name and a value,
// with figures of the flash's cache behind them. The events are those of tests/panel/panel.h.
//
// rp2040js executes the processor with the cycles of each instruction, and models the blocks. What stands here is
//   - the boot ROM: takes the file as its USB drive does, checks the second stage's checksum, by zlib, and calls it;
//   - that blocks are in reset, clocks off and the timer without tick until the firmware changes it: it must not use
//     them before; that the flash is read only as boot2.S has set up the SSI; that pins carry what their function is;
//   - time: the processor's clock is what the firmware has set; SPI0 takes its bits' time for a byte, in mode 0 and 2
//     one bit more; DMA requests follow its FIFO;
//   - the flash's cache: 16 KB, two ways, lines of 8 bytes (data sheet, 2.6.3) that are filled by one read of 32 bits.
// Not modelled: contention on the bus between processor and DMA, cycles of interrupt entry, analogue start-up times.
'use strict';

const fs = require('fs');
const path = require('path');
const zlib = require('zlib');
const { spawnSync } = require('child_process');

const FLASH_START = 0x10000000, FLASH_END = 0x14000000, FLASH_BYTES = 2 * 1024 * 1024; // W25Q16JV
const BOOT2_AT = 0x20041f00, BOOT2_BYTES = 256;
const MOST_SECONDS = 30; // of emulated time
const PINS = { 16: 'dc', 17: 'cs', 20: 'backlight', 21: 'reset' };
const PIN_SCK = 18, PIN_MOSI = 19, PIN_LED = 25;
const FUNCTION_SPI = 1;

function fail(text) {
    console.error(`emulate.js: ${text}`);
    process.exit(1);
}

const hex = (value) => `0x${(value >>> 0).toString(16)}`;

function parseArguments() {
    const [folder, file, ...rest] = process.argv.slice(2);
    const options = {};
    for (let i = 0; i + 1 < rest.length; i += 2) {
        options[rest[i]] = rest[i + 1];
    }
    const frames = Number(options['--frames']);
    if (!file || !options['--events'] || !(frames > 0)) {
        fail('usage: node emulate.js FOLDER PICO.uf2 --frames N --events FILE');
    }
    return { folder, file, frames, events: options['--events'], hot: Number(options['--hot']), elf: options['--elf'] };
}

const { folder, file, frames, events, hot, elf } = parseArguments();
let RP2040;
try {
    ({ RP2040 } = require(path.resolve(folder, 'node_modules/rp2040js')));
} catch (error) {
    fail(`${folder}/node_modules has no rp2040js (npm package rp2040js): ${error.message.split('\n')[0]}`);
}

// ------------------------------------------------------------------------------------------------------- the boot ROM

// The blocks of a UF2 file, as the RP2040's drive takes them: those of its family, for its flash, all of them.
function loadUf2(flash) {
    const uf2 = fs.readFileSync(file), seen = new Set();
    const wrong = (i, what) => fail(`${file}: block ${i} ${what}`);
    if (uf2.length === 0 || uf2.length % 512 !== 0) {
        fail(`${file} has ${uf2.length} bytes, which are no UF2 blocks`);
    }
    for (let i = 0; i < uf2.length / 512; i++) {
        const word = (at) => uf2.readUInt32LE(512 * i + at);
        const address = word(12), bytes = word(16), number = word(20), count = word(24);
        if (word(0) !== 0x0a324655 || word(4) !== 0x9e5d5157 || word(508) !== 0x0ab16f30) {
            wrong(i, 'lacks a magic number');
        }
        if (word(8) !== 0x2000 || word(28) !== 0xe48bff56) {
            wrong(i, 'is not of the RP2040 family');
        }
        const inFlash = address >= FLASH_START && address + 256 <= FLASH_START + FLASH_BYTES;
        if (bytes !== 256 || address % 256 !== 0 || !inFlash) {
            wrong(i, `is for ${bytes} bytes at ${hex(address)}`);
        }
        if (count !== uf2.length / 512 || number >= count || seen.has(number)) {
            wrong(i, `is number ${number} of ${count}`);
        }
        seen.add(number);
        flash.set(uf2.subarray(512 * i + 32, 512 * i + 32 + 256), address - FLASH_START);
    }
}

const reverseBits = (value, count) => {
    let reversed = 0;
    for (let i = 0; i < count; i++) {
        reversed = reversed * 2 + ((value >>> i) & 1);
    }
    return reversed;
};

// The checksum that the boot ROM wants is zlib's with all bits in the other order and no inversion at the end. A gzip
// file ends with zlib's and the length.
function bootChecksum(bytes) {
    const zipped = zlib.gzipSync(Buffer.from(bytes.map((byte) => reverseBits(byte, 8))));
    return reverseBits(~zipped.readUInt32LE(zipped.length - 8) >>> 0, 32);
}

function bootRom(rp2040) {
    loadUf2(rp2040.flash);
    const stored = rp2040.flashView.getUint32(BOOT2_BYTES - 4, true);
    const computed = bootChecksum(rp2040.flash.slice(0, BOOT2_BYTES - 4));
    if (stored !== computed) {
        fail(`${file}: the second stage's checksum is ${hex(stored)}, not ${hex(computed)}: a Pico would not boot it`);
    }
    rp2040.sram.set(rp2040.flash.subarray(0, BOOT2_BYTES), BOOT2_AT - 0x20000000);
    rp2040.core.SP = BOOT2_AT;
    rp2040.core.LR = 0;
    rp2040.core.PC = BOOT2_AT;
}

// ------------------------------------------------------------------------------------- the chip as it is after a reset

// All blocks are in reset but those that the boot ROM reads the flash with.
function watchResets(rp2040) {
    const blocks = { 0x50000: 2, 0x40014: 5, 0x4001c: 8, 0x40028: 12, 0x4003c: 16, 0x40054: 21, 0x40034: 22 };
    const OUT = (1 << 6) | (1 << 9), RESET_DONE = 8;
    const resets = rp2040.peripherals[0x4000c], read = resets.readUint32.bind(resets);
    resets.reset = 0x1ffffff & ~OUT;
    resets.readUint32 = (offset) => (offset === RESET_DONE ? ~resets.reset & 0x1ffffff : read(offset));
    for (const [block, bit] of Object.entries(blocks)) {
        const peripheral = rp2040.peripherals[block];
        for (const access of ['readUint32', 'writeUint32']) {
            const inner = peripheral[access].bind(peripheral);
            peripheral[access] = (offset, value) => {
                if (resets.reset & (1 << bit)) {
                    fail(`${peripheral.name} is used while it is in reset, at ${hex(rp2040.core.PC)}`);
                }
                return inner(offset, value);
            };
        }
    }
}

// The timer counts ticks that the watchdog makes of clk_ref.
function watchTimer(rp2040) {
    const TICK = 0x2c, ENABLE = 1 << 9;
    const watchdog = rp2040.peripherals[0x40058], timer = rp2040.peripherals[0x40054];
    const write = watchdog.writeUint32.bind(watchdog), read = timer.readUint32.bind(timer);
    let cycles = 0;
    watchdog.writeUint32 = (offset, value) => {
        cycles = offset === TICK ? (value & ENABLE ? value & 0x1ff : 0) : cycles;
        write(offset, value);
    };
    timer.readUint32 = (offset) => {
        if (cycles * 1e6 !== rp2040.clocks.refFreq) {
            fail(`the timer is read with a tick every ${cycles} cycles of ${rp2040.clocks.refFreq} Hz`);
        }
        return read(offset);
    };
}

// What boot2.S makes of the SSI is held against the plain serial read at each read of the flash; returns its cycles.
function watchFlash(rp2040) {
    const ssi = rp2040.peripherals[0x18000], write = ssi.writeUint32.bind(ssi);
    const SER = 0x10, MOST_HZ = 50e6, READ_CLOCKS = 8 + 24 + 32;
    let selected = 0;
    ssi.writeUint32 = (offset, value) => {
        if (offset !== 8 && ssi.ssienr & 1) {
            fail('the SSI is set up while it is on');
        }
        if (offset === SER) {
            selected = value;
        } else {
            write(offset, value);
        }
    };
    return () => {
        const wanted = { // enabled; 32 bits of data, read after what is written; one frame; 03h, 8 bits, 24 of address
            ssienr: 1, crtlr0: (31 << 16) | (3 << 8), crtlr1: 0, spictlr0: (3 << 24) | (2 << 8) | (6 << 2),
        };
        for (const [register, value] of Object.entries(wanted)) {
            if (ssi[register] !== value) {
                fail(`the flash is read with the SSI's ${register} ${hex(ssi[register])}, not ${hex(value)}`);
            }
        }
        if (selected !== 1 || ssi.baudr < 2 || ssi.baudr % 2 !== 0) {
            fail(`the flash is read with the SSI's SER ${selected} and BAUDR ${ssi.baudr}`);
        }
        if (rp2040.clkSys / ssi.baudr > MOST_HZ) {
            fail(`the flash is clocked at ${rp2040.clkSys / ssi.baudr} Hz, more than its plain read takes`);
        }
        return READ_CLOCKS * ssi.baudr;
    };
}

// Counts accesses and misses; the caller takes the cycles that they cost.
function addCache(rp2040, checkFlash) {
    const SETS = 1024;
    const lines = [new Int32Array(SETS).fill(-1), new Int32Array(SETS).fill(-1)];
    const halves = [new Uint8Array(SETS), new Uint8Array(SETS)], older = new Uint8Array(SETS);
    const cache = { accesses: 0, misses: 0, stall: 0 };
    const look = (address) => {
        const line = (address & 0xffffff) >>> 3, set = line % SETS, half = address & 4 ? 2 : 1;
        cache.accesses++;
        let way = lines[0][set] === line ? 0 : lines[1][set] === line ? 1 : -1;
        if (way < 0) {
            way = older[set];
            lines[way][set] = line;
            halves[way][set] = 0;
        }
        older[set] = 1 - way;
        if (!(halves[way][set] & half)) {
            halves[way][set] |= half;
            cache.misses++;
            cache.stall += checkFlash();
        }
    };
    for (const access of ['readUint32', 'readUint16', 'readUint8']) {
        const inner = rp2040[access].bind(rp2040);
        rp2040[access] = (address) => {
            address >>>= 0;
            if (address >= FLASH_START && address < FLASH_END) {
                look(address);
            }
            return inner(address);
        };
    }
    return cache;
}

// ---------------------------------------------------------------------------------------------------- what is attached

function openEvents(clock) {
    const output = fs.openSync(events, 'w');
    let lines = [];
    const flush = () => {
        fs.writeSync(output, lines.join(''));
        lines = [];
    };
    return {
        add(text) {
            lines.push(`${Math.round(clock.nanos)} ${text}\n`);
            if (lines.length >= 10000) {
                flush();
            }
        },
        close() {
            flush();
            fs.closeSync(output);
        },
    };
}

function attachPanel(rp2040, stream) {
    const TXDMAE = 2, SPH = 1 << 7, SSPDMACR = 0x24;
    const spi = rp2040.spi[0], write = spi.writeUint32.bind(spi);
    for (const [pin, line] of Object.entries(PINS)) {
        rp2040.gpio[pin].addListener((value) => {
            if (value === 0 || value === 1) {
                stream.add(`${line} ${value}`);
            }
        });
    }
    rp2040.gpio[PIN_LED].addListener((value) => {
        if (value === 1) {
            fail(`the firmware has stopped, LED on; it has told:\n${told.join('\n')}`);
        }
    });

    let byte = 0;
    const sent = rp2040.clock.createAlarm(() => {
        stream.add(`byte ${byte.toString(16).padStart(2, '0')}`);
        spi.completeTransmit(0);
    });
    spi.onTransmit = (value) => {
        const wired = [PIN_SCK, PIN_MOSI].every((pin) => rp2040.gpio[pin].functionSelect === FUNCTION_SPI);
        if (!wired || !spi.enabled || !(spi.clockFrequency > 0) || spi.dataBits !== 8) {
            fail(`SPI0 sends with its pins, its clock (${spi.clockFrequency} Hz) or its frames not as they have to be`);
        }
        byte = value;
        sent.schedule((spi.dataBits + (spi.control0 & SPH ? 0 : 1)) * 1e9 / spi.clockFrequency);
    };
    // a request only while SPI0's DMA is enabled
    spi.updateDMATx = () => {
        if (spi.txFIFO.full || !(spi.dmaControl & TXDMAE)) {
            rp2040.dma.clearDREQ(spi.dreq.tx);
        } else {
            rp2040.dma.setDREQ(spi.dreq.tx);
        }
    };
    spi.writeUint32 = (offset, value) => {
        write(offset, value);
        if (offset === SSPDMACR) {
            spi.updateDMATx();
        }
    };
    spi.updateDMATx();
}

const told = [];
let framesTold = 0;

function attachUart(rp2040) {
    let line = '';
    rp2040.uart[0].onByte = (byte) => {
        if (byte !== 10) {
            line += byte === 13 ? '' : String.fromCharCode(byte);
            return;
        }
        told.push(line);
        framesTold += line.startsWith('frame_us ') ? 1 : 0;
        line = '';
    };
}

// ------------------------------------------------------------------------------------------------- what belongs in RAM

// Executed instructions of the frames by address, and from them the functions that earn their bytes best.
function countInstructions() {
    const counts = new Map();
    return {
        add(address) {
            counts.set(address, (counts.get(address) || 0) + 1);
        },
        print() {
            const nm = spawnSync('arm-none-eabi-nm', ['-S', elf], { encoding: 'latin1' });
            if (nm.status !== 0) {
                fail(`arm-none-eabi-nm: ${nm.error ? nm.error.message : nm.stderr}`);
            }
            const functions = nm.stdout.split('\n').map((line) => line.split(' '))
                .filter((words) => words.length === 4 && /^[tT]$/.test(words[2]) && !words[3].startsWith('_'))
                .map(([address, bytes, , name]) =>
                    ({ name, address: parseInt(address, 16), bytes: parseInt(bytes, 16) }));
            for (const f of functions) {
                f.executed = 0;
                for (let address = f.address; address < f.address + f.bytes; address += 2) {
                    f.executed += counts.get(address) || 0;
                }
            }
            let left = hot;
            functions.sort((a, b) => b.executed / b.bytes - a.executed / a.bytes);
            for (const { name, bytes, executed } of functions) {
                if (executed > 0 && bytes <= left) {
                    left -= bytes;
                    const written = name.replace(/\..*/, ''); // .isra.0, .part.0: the compiler's
                    console.log(`*(.text.${written} .text.${written}.*)`);
                }
            }
        },
    };
}

// ------------------------------------------------------------------------------------------------------------- the run

const rp2040 = new RP2040();
const stop = (name, message) => fail(`${name}: ${message}, at ${hex(rp2040.core.PC)}`);
rp2040.logger = { debug() {}, info() {}, warn: stop, error: stop };
rp2040.onBreak = (code) => fail(`breakpoint ${code} at ${hex(rp2040.core.PC)}`);
rp2040.clkSys = rp2040.roscFreq;
rp2040.clkPeri = 0;

const stream = openEvents(rp2040.clock);
attachPanel(rp2040, stream);
attachUart(rp2040);
watchResets(rp2040);
watchTimer(rp2040);
bootRom(rp2040);
const cache = addCache(rp2040, watchFlash(rp2040));

const counter = hot > 0 ? countInstructions() : null;
let instructions = 0, stalledCycles = 0, frameEnded = 0, frameStalled = 0;
while (framesTold < frames) {
    if (rp2040.core.waiting) {
        if (rp2040.clock.nextAlarm === null) {
            fail(`the processor sleeps for ever, at ${hex(rp2040.core.PC)}`);
        }
        rp2040.clock.tick(rp2040.clock.nanosToNextAlarm);
    } else {
        if (counter && framesTold > 0) {
            counter.add(rp2040.core.PC);
        }
        const cycles = rp2040.core.executeInstruction() + cache.stall;
        stalledCycles += cache.stall;
        cache.stall = 0;
        instructions++;
        rp2040.clock.tick(cycles * 1e9 / rp2040.clkSys);
    }
    if (framesTold > frameEnded) {
        frameEnded = framesTold;
        frameStalled = stalledCycles;
        stalledCycles = 0;
    }
    if (rp2040.clock.nanos > MOST_SECONDS * 1e9) {
        fail(`not ended after ${MOST_SECONDS} s; the firmware has told:\n${told.join('\n')}`);
    }
}
stream.close();
if (counter) {
    counter.print();
    process.exit(0);
}
console.log(told.join('\n'));
console.log(`clk_sys_hz ${rp2040.clkSys}`);
console.log(`instructions ${instructions}`);
console.log(`frame_stalled_us ${Math.round(frameStalled * 1e6 / rp2040.clkSys)}`); // of the last frame, for the cache
console.log(`cache_accesses ${cache.accesses}`);
console.log(`cache_misses ${cache.misses}`);
