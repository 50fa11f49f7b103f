#!/usr/bin/env python3
"""Lines that no test runs: each has to be explained.

    uncovered.py SOURCE EXPLAINED COUNTS...

COUNTS are gcovr's (--json), of one build tree each; a line is run when it is in any of them. EXPLAINED has a row a
group of lines that follow each other: file, the line before the group, the group's first line, how many lines it has,
why nothing runs it; tabs between. Where that begins with "machine: ", another machine may run them.

Exit status: 0 all lines are run or explained; 1 some are not, or what is explained is run after all; 2 usage.
"""

import json
import pathlib
import sys


def counts_of(paths):
    """{file: {line: was it run}}"""
    files = {}
    for path in paths:
        for entry in json.loads(pathlib.Path(path).read_text())["files"]:
            lines = files.setdefault(entry["file"], {})
            for line in entry["lines"]:
                if not line.get("gcovr/noncode"):
                    number = line["line_number"]
                    lines[number] = lines.get(number, False) or line["count"] > 0
    return files


def groups_of(lines):
    """Lines not run that follow each other, each group behind a line that is run."""
    before, group = None, []
    for number in sorted(lines):
        if lines[number]:
            if group:
                yield before, group
            before, group = number, []
        else:
            group.append(number)
    if group:
        yield before, group


def read_explained(path):
    rows = {}
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            file, before, first, count, reason = line.split("\t")
            rows[file, before, first, int(count)] = reason
    return rows


def main():
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    source, explained = pathlib.Path(sys.argv[1]), read_explained(pathlib.Path(sys.argv[2]))
    files = counts_of(sys.argv[3:])
    unused, wrong, named = set(explained), 0, 0
    for file in sorted(files):
        text = (source / file).read_text().splitlines()
        for before, group in groups_of(files[file]):
            key = file, text[before - 1].strip() if before else "", text[group[0] - 1].strip(), len(group)
            if key in explained:
                unused.discard(key)
                named += len(group)
                print("%s:%d-%d: %s" % (file, group[0], group[-1], explained[key]))
            else:
                wrong += len(group)
                print("%s:%d-%d: no test runs these %d, behind: %s" % (file, group[0], group[-1], len(group), key[1]))
    unused = [key for key in sorted(unused) if not explained[key].startswith("machine: ")]
    for file, _, first, count in unused:
        print("%s: explained, but run, gone, or no longer %d lines: %s" % (file, count, first))
    total = sum(len(lines) for lines in files.values())
    print("lines: %d, run by the tests %d, explained %d, neither %d" % (total, total - named - wrong, named, wrong))
    sys.exit(1 if wrong or unused else 0)


if __name__ == "__main__":
    main()
