#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Coverage of src/ by tests that have run: tools/coverage.sh BUILD EXPLANATIONS
#
# BUILD holds the flavours that gcc has built with --coverage. Prints a table of the files, then each line that was not
# reached and each line with a branch that was not taken, and why. EXPLANATIONS (docs/coverage.md says how it is
# written) must have an entry for each of them, and each of its entries must be of use; otherwise the exit status is 1.
set -eu

build=$(cd "$1" && pwd -P)
explanations=$2
root=$(pwd -P)
work=$build/gcov

# gcc notes how the tests' programs are laid out when it compiles them; what no longer runs is left from before.
find "$build" -name '*.gcno' | while read -r notes; do
    source=${notes##*/obj/}
    [ -f "${notes%.gcno}.gcda" ] || { [ -f "${source%.gcno}.c" ] && [ "${source#src/}" != "$source" ]; } || rm "$notes"
done

# gcov writes where it runs and finds sources from there: here, by links, so that the tree stays clean.
rm -rf "$work"
mkdir -p "$work"
for folder in src include tests tools examples; do
    ln -s "$root/$folder" "$work/$folder"
done

sources=$(printf '%s' "$root/src/" | sed 's|[^A-Za-z0-9_/-]|\\&|g') # a regular expression

# count NAME FOLDER...: what the flavours in these folders have counted, added up, to NAME.xml.
count() {
    local name=$1
    shift
    gcovr --no-markers --root "$work" --filter "$sources" --object-directory "$work" \
        --xml-pretty --xml "$build/$name.xml" "$@" >"$build/gcovr.log" 2>&1 || {
        cat "$build/gcovr.log" >&2
        exit 1
    }
}
# gcovr does not add up a function that stands in two places of a file, as the preprocessor chose: the rest is done here.
count usual "$build/single" "$build/threads"
count narrow "$build/narrow"

awk '
function trimmed(text) {
    gsub(/[ \t]+/, " ", text)
    gsub(/^ | $/, "", text)
    return text
}

function attribute(name,    at) {
    at = match($0, " " name "=\"[^\"]*\"")
    return at ? substr($0, at + length(name) + 3, RLENGTH - length(name) - 4) : ""
}

function percent(part, whole) {
    return whole ? sprintf("%.1f %%", int(1000 * part / whole) / 10) : "-"
}

function row(name, l, lt, b, bt) {
    printf "%-32s %6d of %4d %8s %6d of %4d %8s\n", name, l, lt, percent(l, lt), b, bt, percent(b, bt)
}

function plural(count, what) {
    return count + 0 " " what (count == 1 ? "" : what == "branch" ? "es" : "s")
}

function wrap(text, indent,    word, count, i, line) {
    count = split(text, word, " ")
    line = indent
    for (i = 1; i <= count; i++) {
        if (length(line) + length(word[i]) + 1 > 120) {
            print line
            line = indent
        }
        line = line (line == indent ? "" : " ") word[i]
    }
    print line
}

function complain(text) {
    complaints = complaints "  " text "\n"
}

function read_source(name,    text, n) {
    if (name in length_of) {
        return
    }
    n = 0
    while ((getline text < name) > 0) {
        source[name, ++n] = trimmed(text)
    }
    close(name)
    length_of[name] = n
}

# Of a line in both counts it is not known whether they took the same branches, so the better of the two counts alone,
# and the worse where it is not the same code.
function count_branches(missed, all) {
    if (!((file, number) in branches_of)) {
        branches_of[file, number] = all
        untaken[file, number] = missed
    } else if (branches_of[file, number] == all) {
        untaken[file, number] = missed < untaken[file, number] ? missed : untaken[file, number]
    } else if (missed > untaken[file, number]) {
        branches_of[file, number] = all
        untaken[file, number] = missed
    }
}

# An entry is complete: where its snippet stands, and what of it was not covered.
function finish_entry(    i, k, found, at, lines, branches, lines_said, branches_said, label, number) {
    if (!snippet_lines) {
        return
    }
    label = file ": " snippet[1]
    read_source(file)
    for (i = 1; i + snippet_lines - 1 <= length_of[file]; i++) {
        for (k = 1; k <= snippet_lines && source[file, i + k - 1] == snippet[k]; k++) {}
        if (k > snippet_lines) {
            found++
            at = i
        }
    }
    if (found != 1) {
        complain(label "  -- the file has these lines " (found ? found " times" : "no more"))
        return
    }
    for (i = at; i < at + snippet_lines; i++) {
        lines += ((file, i) in hits) && !hits[file, i]
        branches += untaken[file, i]
        explained[file, i] = explanation
    }
    number = explanation
    if (match(number, /^[0-9]+ lines?[,.] */)) {
        lines_said = number + 0
        number = substr(number, RLENGTH + 1)
    }
    if (match(number, /^[0-9]+ branch(es)?\. /)) {
        branches_said = number + 0
    }
    if (lines + branches == 0) {
        complain(label "  -- is covered now; the entry is of no use")
    } else if (lines > lines_said || branches > branches_said) {
        complain(label "  -- not covered: " plural(lines, "line") ", " plural(branches, "branch") \
            "; the entry says " plural(lines_said, "line") ", " plural(branches_said, "branch"))
    }
}

FILENAME ~ /\.xml$/ {
    if (/<class /) {
        file = attribute("filename")
        if (!(file in known)) {
            known[file] = 1
            files[++file_count] = file
        }
    } else if (/<line /) {
        number = attribute("number")
        if (!((file, number) in hits)) {
            lines_total[file]++
        }
        hits[file, number] += attribute("hits")
        if (match($0, /\([0-9]+\/[0-9]+\)/)) {
            split(substr($0, RSTART + 1, RLENGTH - 2), of, "/")
            count_branches(of[2] - of[1], of[2])
        }
    }
    next
}

# The explanations: a heading names the file, a fenced block is a snippet, what follows it says why.
/^## / || /^```/ || /^# / {
    if (/^```/ && within) {
        within = 0
        next
    }
    finish_entry()
    snippet_lines = 0
    explanation = ""
    if (/^## /) {
        file = $2
    } else if (/^```/) {
        within = 1
    }
    next
}
within {
    snippet[++snippet_lines] = trimmed($0)
    next
}
snippet_lines {
    explanation = trimmed(explanation " " $0)
}

END {
    finish_entry()
    for (key in hits) {
        split(key, at, SUBSEP)
        lines_reached[at[1]] += hits[key] > 0
        if (key in branches_of) {
            branches_total[at[1]] += branches_of[key]
            branches_taken[at[1]] += branches_of[key] - untaken[key]
        }
    }
    printf "%-32s %14s %8s %14s %8s\n", "", "lines", "", "branches", ""
    for (f = 1; f <= file_count; f++) {
        name = files[f]
        row(name, lines_reached[name], lines_total[name], branches_taken[name], branches_total[name])
        reached += lines_reached[name]
        lines += lines_total[name]
        taken += branches_taken[name]
        branches += branches_total[name]
    }
    row("all", reached, lines, taken, branches)
    if (!lines) {
        complain("nothing was counted")
    }
    print "\nNot covered, and why:"
    for (f = 1; f <= file_count; f++) {
        name = files[f]
        read_source(name)
        for (i = 1; i <= length_of[name]; i++) {
            line = ((name, i) in hits) && !hits[name, i]
            if (!line && !untaken[name, i]) {
                continue
            }
            listed++
            print ""
            print name ":" i ": " (line ? "not reached" : "") (line && untaken[name, i] ? ", " : "") \
                (untaken[name, i] ? untaken[name, i] " of " plural(branches_of[name, i], "branch") " not taken" : "")
            print "    " source[name, i]
            if ((name, i) in explained) {
                wrap(explained[name, i], "    = ")
            } else {
                print "    = NOT EXPLAINED"
                complain(name ":" i ": " source[name, i] "  -- not explained")
            }
        }
    }
    if (!listed) {
        print "  nothing"
    }
    if (complaints) {
        printf "\ncoverage: failed, see docs/coverage.md\n%s", complaints
        exit 1
    }
    printf "\n%s of %d lines, %s of %d branches; %s not covered, each explained\n", percent(reached, lines), lines, \
        percent(taken, branches), branches, plural(listed, "line")
}' "$build/usual.xml" "$build/narrow.xml" "$explanations"
