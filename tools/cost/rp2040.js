// SPDX-License-Identifier: MIT
//
// Runs a program of tests/target/platform_rp2040.c on the Cortex-M0+ of rp2040js (npm), which knows the cycles of each
// instruction, and answers its semihosting calls:
//
//     node tools/cost/rp2040.js FOLDER PROGRAM.elf                      FOLDER holds node_modules/rp2040js
//     node tools/cost/rp2040.js FOLDER PROGRAM.elf --any-ram            with as much RAM as it was linked for
//     node tools/cost/rp2040.js FOLDER PROGRAM.elf --profile CASE       instructions of its first frame by function
//     node tools/cost/rp2040.js FOLDER PROGRAM.elf --stack CASE         how deep the stack of its first frame gets, and
//                                                                       with its memory how much RAM it takes
//
// The program is linked by tests/target/startup/cortex_m.ld, code from address 0: there the emulator's boot ROM is put
// aside for it. Code costs the same cycles wherever it is: the flash's cache is not modelled, nor contention of the bus.
//
// A profile counts each executed instruction of the call of glint_*_render() at its address. What the compiler inlined
// is told apart by the line tables: addr2line names the functions at each address, innermost first. stages.txt groups
// them.
'use strict';

const fs = require('fs');
const path = require('path');
const { spawnSync } = require('child_process');

const FLASH_BYTES = 512 * 1024; // COST_LINK of cost.mk
const RAM_START = 0x20000000;
const SYS_WRITE0 = 0x04, SYS_EXIT = 0x18, SYS_ELAPSED = 0x30;
const MOST_CYCLES = 20e9; // a program that has not ended by then hangs
const LINES = 25;

function fail(text) {
    console.error(`rp2040.js: ${text}`);
    process.exit(1);
}

// What is needed of a 32-bit little-endian ELF file: symbols, and segments with where they run (at) and are loaded.
function readElf(file) {
    const elf = fs.readFileSync(file);
    if (elf.length < 52 || elf.toString('latin1', 0, 4) !== '\x7fELF' || elf[4] !== 1 || elf[5] !== 1) {
        fail(`${file} is not a 32-bit little-endian ELF file`);
    }
    const segments = [], symbols = [];
    for (let i = 0, at = elf.readUInt32LE(28); i < elf.readUInt16LE(44); i++, at += elf.readUInt16LE(42)) {
        const offset = elf.readUInt32LE(at + 4), bytes = elf.readUInt32LE(at + 16);
        if (elf.readUInt32LE(at) === 1 && bytes > 0) {
            segments.push({ at: elf.readUInt32LE(at + 8), address: elf.readUInt32LE(at + 12),
                bytes: elf.subarray(offset, offset + bytes) });
        }
    }
    const section = (i) => {
        const at = elf.readUInt32LE(32) + i * elf.readUInt16LE(46);
        return { type: elf.readUInt32LE(at + 4), offset: elf.readUInt32LE(at + 16), bytes: elf.readUInt32LE(at + 20),
            link: elf.readUInt32LE(at + 24) };
    };
    for (let i = 0; i < elf.readUInt16LE(48); i++) {
        const table = section(i);
        if (table.type !== 2) {
            continue;
        }
        const names = section(table.link).offset;
        for (let at = table.offset; at < table.offset + table.bytes; at += 16) {
            const name = names + elf.readUInt32LE(at);
            symbols.push({ name: elf.toString('latin1', name, elf.indexOf(0, name)), address: elf.readUInt32LE(at + 4),
                bytes: elf.readUInt32LE(at + 8), type: elf[at + 12] & 15 });
        }
    }
    return { segments, symbols };
}

const [folder, file, option, chosen] = process.argv.slice(2);
const anyRam = option === '--any-ram';
if (!file || (option !== undefined && !anyRam && (!['--profile', '--stack'].includes(option) || !chosen))) {
    fail('usage: node rp2040.js FOLDER PROGRAM.elf [--any-ram | --profile CASE | --stack CASE]');
}
let RP2040;
try {
    ({ RP2040 } = require(path.resolve(folder, 'node_modules/rp2040js')));
} catch (error) {
    fail(`${folder}/node_modules has no rp2040js (npm package rp2040js): ${error.message.split('\n')[0]}`);
}

const { segments, symbols } = readElf(file);
const symbolNamed = (name) => symbols.find((s) => s.name === name) || fail(`${file} has no ${name}`);

const rp2040 = new RP2040();
const core = rp2040.core;
const rom = new Uint8Array(FLASH_BYTES);
rp2040.bootrom = new Uint32Array(rom.buffer);
const ramTop = symbolNamed('link_stack_top').address;
if (ramTop - RAM_START > rp2040.sram.length) {
    if (!chosen && !anyRam) {
        fail(`${file} has ${ramTop - RAM_START} bytes of RAM, the RP2040 ${rp2040.sram.length}`);
    }
    rp2040.sram = new Uint8Array(ramTop - RAM_START); // where it runs, not how, so that any scene fits
    rp2040.sramView = new DataView(rp2040.sram.buffer);
}
for (const { address, bytes } of segments) {
    if (address + bytes.length > FLASH_BYTES) {
        fail(`${file} has bytes at 0x${address.toString(16)}, beyond the flash`);
    }
    rom.set(bytes, address);
}
if (chosen) {
    const name = symbolNamed('cost_chosen');
    if (chosen.length >= name.bytes) {
        fail(`no case has a name as long as '${chosen}'`);
    }
    const holds = segments.find((s) => name.address >= s.at && name.address < s.at + s.bytes.length);
    rom.set(Buffer.from(`${chosen}\0`, 'latin1'), holds.address + name.address - holds.at);
}

let ended = false, output = '';
rp2040.onBreak = (number) => {
    if (number !== 0xab) {
        fail(`breakpoint ${number} at 0x${core.PC.toString(16)}`);
    }
    const [operation, argument] = core.registers;
    if (operation === SYS_WRITE0) {
        for (let at = argument, byte; (byte = rp2040.readUint8(at)) !== 0; at++) {
            output += String.fromCharCode(byte);
        }
        if (!chosen) {
            fs.writeSync(1, output);
            output = '';
        }
    } else if (operation === SYS_ELAPSED) {
        rp2040.writeUint32(argument, cycles % 2 ** 32);
        rp2040.writeUint32(argument + 4, Math.floor(cycles / 2 ** 32));
    } else if (operation === SYS_EXIT) {
        ended = true;
    } else {
        fail(`semihosting operation ${operation} is not known`);
    }
};

let cycles = 0;
core.reset();

function step() {
    cycles += core.executeInstruction();
    if (cycles > MOST_CYCLES) {
        fail(`not ended after ${MOST_CYCLES} cycles`);
    }
}

// stages.txt: its stages in order, and which of them a function belongs to ('': none).
function readStages() {
    const patterns = [], known = new Map();
    for (const line of fs.readFileSync(path.join(__dirname, 'stages.txt'), 'latin1').split('\n')) {
        const [stage, names] = line.split(': ');
        if (line !== '' && line[0] !== '#') {
            for (const name of names.trim().split(/ +/)) {
                patterns.push({ stage, name: name.replace('*', ''), all: name.endsWith('*') });
            }
        }
    }
    const stageOf = (symbol) => {
        const name = symbol.replace(/\..*/, ''); // .isra.0, .part.0: the compiler's
        if (!known.has(name)) {
            const fitting = patterns.filter((p) => (p.all ? name.startsWith(p.name) : name === p.name));
            fitting.sort((a, b) => a.all - b.all || b.name.length - a.name.length);
            known.set(name, fitting.length > 0 ? fitting[0].stage : '');
        }
        return known.get(name);
    };
    return { stages: [...new Set(patterns.map((p) => p.stage))], stageOf };
}

const { stages, stageOf } = readStages();

// 1 at the addresses of functions that belong to their callers' stage.
function helpers() {
    const marks = new Uint8Array(FLASH_BYTES / 2);
    for (const { name, address, bytes } of symbols.filter((s) => s.type === 2 && stageOf(s.name) === '')) {
        marks.fill(1, address >>> 1, (address + bytes + 1) >>> 1);
    }
    return marks;
}

// Runs to the first call of glint_*_render().
function enterFrame() {
    const entries = ['glint_fixed_render', 'glint_float_render'].map((name) => symbolNamed(name).address & ~1);
    while (!ended && !entries.includes(core.PC & ~1)) {
        step();
    }
    if (ended) {
        const why = output.split('\n').find((line) => /^(left|failed) /.test(line));
        fail(why || `no case's name begins '${chosen}': tools/cost/cases.c has them`);
    }
}

// The stack of that call, the caller's arguments on it included, and the program's own words on the frame's memory.
function showStack() {
    enterFrame();
    const back = core.LR & ~1, stack = core.SP;
    let deepest = stack;
    while ((core.PC & ~1) !== back || core.SP !== stack) {
        step();
        deepest = Math.min(deepest, core.SP);
    }
    const bytes = stack - deepest + 8; // the fifth and sixth argument
    while (!ended && !/^cost .*\n/m.test(output)) {
        step();
    }
    const line = /^memory (.*)$/m.exec(output) || fail(`${file} tells nothing of its memory`);
    const [least, full, used] = line[1].split(' ').slice(-3).map(Number);
    const cells = [bytes, least, least + bytes, full, full + bytes, used, used + bytes].map((n) => String(n).padStart(7));
    console.log(`${chosen.padEnd(24)}${cells.join('')}`);
}

// The first call of glint_*_render(): how often each address was executed, and its cycles; and for
// each address from which a helper was called, the same of all that the helpers did.
function profile() {
    const counts = new Float64Array(FLASH_BYTES / 2), taken = new Float64Array(FLASH_BYTES / 2);
    enterFrame();
    const isHelper = helpers();
    const helped = { counts: new Float64Array(FLASH_BYTES / 2), taken: new Float64Array(FLASH_BYTES / 2) };
    const back = core.LR & ~1, stack = core.SP;
    let caller = core.PC >>> 1;
    while ((core.PC & ~1) !== back || core.SP !== stack) {
        const at = core.PC >>> 1, before = cycles;
        step();
        counts[at]++;
        taken[at] += cycles - before;
        if (isHelper[at]) {
            helped.counts[caller]++;
            helped.taken[caller] += cycles - before;
        } else {
            caller = at;
        }
    }
    return { counts, taken, isHelper, helped };
}

function table(title, rows, total) {
    print(title, [...rows].sort((a, b) => b[1].counts - a[1].counts).slice(0, LINES), total);
}

function print(title, rows, total) {
    console.log(`\n${title}`);
    console.log('instructions      %      cycles       calls  ');
    for (const [name, row] of rows) {
        const share = (100 * row.counts / total).toFixed(1);
        console.log(`${String(row.counts).padStart(12)} ${share.padStart(6)} ${String(row.taken).padStart(11)} ` +
            `${String(row.calls === undefined ? '' : row.calls).padStart(11)}  ${name}`);
    }
}

function add(rows, name, counts, taken) {
    const row = rows.get(name) || { counts: 0, taken: 0 };
    row.counts += counts;
    row.taken += taken;
    rows.set(name, row);
    return row;
}

// The innermost function and the line at each address, by the line tables.
function inlined(addresses) {
    const tool = spawnSync('arm-none-eabi-addr2line', ['-e', file, '-f', '-s', '-a', '-i'],
        { input: addresses.map((a) => `0x${a.toString(16)}\n`).join(''), maxBuffer: 1 << 28, encoding: 'latin1' });
    if (tool.status !== 0) {
        fail(`arm-none-eabi-addr2line: ${tool.error ? tool.error.message : tool.stderr}`);
    }
    const places = new Map();
    for (const block of tool.stdout.split(/^0x/m).slice(1)) {
        const lines = block.trimEnd().split('\n');
        places.set(parseInt(lines[0], 16), { name: lines[1], line: lines[2].replace(/ \(discriminator.*/, ''),
            within: lines[lines.length - 2], chain: lines.filter((_, i) => i % 2 === 1) });
    }
    return places;
}

function stageAt(place) {
    return place.chain.map(stageOf).find((stage) => stage !== '') || 'other';
}

function show({ counts, taken, isHelper, helped }) {
    const functions = symbols.filter((s) => s.type === 2).map((s) => ({ ...s, address: s.address & ~1 }))
        .sort((a, b) => a.address - b.address);
    const bySymbol = new Map(), byFunction = new Map(), byLine = new Map();
    const byStage = new Map([...stages, 'other'].map((stage) => [stage, { counts: 0, taken: 0 }]));
    const executed = [];
    let total = 0, totalTaken = 0;
    counts.forEach((n, i) => {
        if (n > 0) {
            executed.push(2 * i);
            total += n;
            totalTaken += taken[i];
        }
    });
    const places = inlined(executed);
    let at = 0;
    for (const address of executed) {
        while (at + 1 < functions.length && functions[at + 1].address <= address) {
            at++;
        }
        const n = counts[address >>> 1], t = taken[address >>> 1], place = places.get(address);
        const row = add(bySymbol, functions[at].name, n, t);
        if (functions[at].address === address) {
            row.calls = n;
        }
        const name = place.name === '??' ? functions[at].name : place.name;
        add(byFunction, place.name === place.within || place.name === '??' ? name : `${name}  in ${place.within}`, n, t);
        add(byLine, `${place.line}  ${name}`, n, t);
        const own = isHelper[address >>> 1] ? 0 : 1;
        add(byStage, stageAt(place), own * n + helped.counts[address >>> 1], own * t + helped.taken[address >>> 1]);
    }
    console.log(`${chosen}: ${total} instructions, ${totalTaken} cycles, one frame (ARMv6-M on rp2040js)`);
    table(`By function as compiled, self cost; what is inlined counts where it ended up. The first ${LINES}:`, bySymbol, total);
    table(`By function as written, self cost; "a in b": a inlined into b. The first ${LINES}:`, byFunction, total);
    table(`By line. The first ${LINES}:`, byLine, total);
    print('By stage, see tools/cost/stages.txt:', [...byStage].filter(([, row]) => row.counts > 0), total);
}

if (option === '--stack') {
    showStack();
} else if (chosen) {
    show(profile());
} else {
    while (!ended) {
        step();
    }
}
