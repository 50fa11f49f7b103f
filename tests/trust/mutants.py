#!/usr/bin/env python3
"""Would the tests notice? Small changes (mutants) of the sources of the library and the programs, one at a time.

    mutants.py SOURCE BUILD --mutants N --seed S [--jobs J] [--only REGEX] | --again

All mutants of the chosen files are made by universalmutator, shuffled with the seed, and taken in turn: one that does
not compile (a return left out is an error), or whose object file at -O2 is the original's, is no mutant and is passed
over, until there are N. Each is put into a copy of the tree below BUILD and built, and the tests run until one fails:
killed. What no test notices is listed, unless tests/trust/survivors.tsv says why nothing could notice it;
BUILD/survivors.json has it too, and --again takes those once more, when there are new tests.

Exit status: 0 at least 95 of 100 are killed or explained; 1 fewer, or one that is explained is killed; 2 usage, or a
row of survivors.tsv whose line is not there, or not as often as it says.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import queue
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

# What runs beyond an array, say, is noticed, as in CI's sanitizer build.
FLAGS = "-O1 -fsanitize=undefined -fno-sanitize-recover=undefined"

FOLDERS = ("src/lib", "src/console", "src/1987", "src/armtol")
WANTED = 0.95
TEST_SECONDS = 20
SLOWER = 4 # where the machine is shared: no timeout before this many times what the unchanged tree takes
UNTIMED = 60 # what is not timed: what takes long and is for survivors only
EXPLAINED = "tests/trust/survivors.tsv"

# Tests that run many times as long as the others, or build the project once more.
HEAVY = (r"^(memcheck|build|docs|fault|fuzz|machines|man)_|^(install|example.*|exports)$|_legacy$|"
         r"^test_(joint_orders.*|yield|reproduce)$")

# Where a folder's mistakes show first; the tests of the file's own name go before these, all others after them.
FIRST = {
    "src/lib": ("golden", "test_published", "test_errata_effects", "test_robots", "test_tool_error", "test_answer"),
    "src/console": ("golden", "test_number", "test_flags", "test_options", "test_armtol", "test_wrong_input"),
    "src/1987": ("golden", "test_options", "test_files", "test_wrong_input", "test_terminal", "test_faults"),
    "src/armtol": ("golden", "test_answer", "test_armtol", "test_lists", "test_arm_file", "test_urdf", "test_watched"),
}
OWN = {
    "optimum": "test_optimum", "center": "test_optimum", "factor": "test_optimum", "rows": "test_optimum",
    "arm": "test_arm|test_every_arm", "intelledex": "test_robots",
    "adept": "test_robots", "pose": "test_poses|test_tool_matrix", "sampler": "test_sampler",
    "sphere": "test_sphere", "corners": "test_corners", "tool_matrix": "test_tool_matrix",
    "lane": "test_poses", "sincos": "test_sampler|test_poses", "columns": "test_poses",
    "kernels": "test_poses|test_sampler",
    "frame": "test_sampler", "rotation": "test_sampler",
    "outfile": "test_files|test_faults|test_full_disk", "options": "test_options", "flags": "test_flags|test_options",
    "number": "test_number", "whole_number": "test_number|test_armtol", "dialogue": "test_terminal|test_wrong_input",
    "reader": "test_wrong_input|test_terminal", "session": "test_files", "report": "test_files", "help": "test_options",
    "analysis": "test_published|test_files", "table": "test_table", "message": "test_wrong_input",
    "drawing_file": "test_drawing_file|test_drawing_names", "drawn": "test_drawn", "discs": "test_discs",
    "farthest_round": "test_discs", "disc_draw": "test_sampler", "pose_lists": "test_lists",
    "parameter_lists": "test_lists", "cells": "test_lists|test_arm_file",
    "urdf": "test_urdf|test_urdf_memory",
    "arm_": "test_arm_file|test_urdf|test_arm_memory", "verification": "test_verification", "draw": "test_verification",
    "weights": "test_answer", "steps": "test_iso_286|test_iso_2768", "grades": "test_grades_told",
    "noise": "test_noise$", "noises": "test_noises_told",
    "text_grades": "test_grades_told", "named": "test_drawing_names",
    "budget": "test_budget", "parts": "test_answer|test_question", "json": "armtol_json",
    "number_list": "test_number_list", "text": "test_armtol|test_arm_file", "tell": "test_armtol",
    "ask": "test_armtol", "degrees": "test_degrees", "progress": "test_progress|test_watched",
    "answer": "test_question|test_answer", "check": "test_question", "find": "test_question|test_answer",
    "place": "test_question",
    "climb": "test_verification", "corner_search": "test_verification", "tally": "test_tally",
    "share_interval": "test_verification",
    "interrupt": "test_watched", "watched": "test_watched",
}


def fail(text):
    print("mutants: " + text, file=sys.stderr)
    sys.exit(2)


# ---- the mutants that there may be ----

def sources(root, only):
    files = []
    for folder in FOLDERS:
        files += sorted(p for p in (root / folder).rglob("*.c"))
        files += sorted(p for p in (root / folder).rglob("*.h") if re.search(r"static inline|LANE", p.read_text()))
    names = [str(p.relative_to(root)) for p in files]
    return [name for name in names if re.search(only, name)]


def code_only(text):
    """The text with comments made blank, line by line as long as before: a comment's mutants are none."""
    return re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


def mutants_of(root, name):
    from universalmutator import mutator
    lines = (root / name).read_text().splitlines(keepends=True)
    code = code_only("".join(lines)).splitlines(keepends=True)
    devnull = open(os.devnull, "w")
    stdout, sys.stdout = sys.stdout, devnull
    try:
        rules = ["universal.rules", "c.rules", "c_like.rules"]
        found = mutator.mutants_regexp(lines, ruleFiles=rules, ignorePatterns=[],
                                       ignoreStringOnly=True)
    finally:
        sys.stdout = stdout
        devnull.close()
    seen, result = set(), []
    for mutant in found:
        number, changed = mutant[0], mutant[1]
        line = code[number - 1].strip()
        if not line or line.startswith("#") or changed == lines[number - 1] or (number, changed) in seen:
            continue
        seen.add((number, changed))
        result.append((name, number, changed))
    return result


# ---- does it compile, to something else? ----

class Compiler:
    """Compiles the units that a file is part of, as the build does but at -O2."""

    def __init__(self, root, build):
        self.root = root
        self.units = {}
        for entry in json.loads((build / "compile_commands.json").read_text()):
            path = os.path.relpath(entry["file"], root)
            if path.startswith(FOLDERS) and path not in self.units:
                self.units[path] = (shlex.split(entry["command"]), entry["directory"])
        self.originals = {}
        self.including = {}

    def _run(self, unit, extra, output):
        words, folder = self.units[unit]
        words = words[:words.index("-o")] + words[words.index("-o") + 2:]
        # without the sanitizer, which writes the places of the source into the object
        command = words + ["-O2", "-fno-sanitize=all", "-Werror=return-type"] + extra + ["-o", output]
        return subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)

    def units_of(self, name):
        if name in self.units:
            return [name]
        if not self.including:
            for unit in self.units:
                for header in self._run(unit, ["-MM"], "/dev/stdout").stdout.decode().replace("\\\n", " ").split():
                    path = os.path.relpath(os.path.join(self.units[unit][1], header), self.root)
                    self.including.setdefault(path, []).append(unit)
        return self.including.get(name, [])

    def _object(self, unit, output):
        if self._run(unit, [], output).returncode != 0:
            return None
        subprocess.run(["strip", "--strip-debug", output], check=False)
        return hashlib.sha256(pathlib.Path(output).read_bytes()).digest()

    def differs(self, name, output):
        """None where it does not compile."""
        different = False
        for unit in self.units_of(name):
            now = self._object(unit, output)
            if now is None:
                return None
            different = different or now != self.originals[unit]
        return different

    def remember(self, name, output):
        for unit in self.units_of(name):
            if unit not in self.originals:
                self.originals[unit] = self._object(unit, output)


# ---- one tree, and what its tests say ----

def left_behind(folder, at, names):
    """What is not copied of a folder: the history, and build trees, the one that is copied to among them."""
    return [name for name in names if name in (".git", "build") or name.startswith("build-")
            or pathlib.Path(at, name) in folder.parents]


class Tree:
    def __init__(self, source, folder, cmake):
        self.root, self.build = folder / "source", folder / "build"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(source, self.root, symlinks=True, ignore=lambda at, names: left_behind(folder, at, names))
        run = lambda *words: subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if shutil.which("ninja"):
            cmake = ["-G", "Ninja"] + cmake # much the quicker where little has changed
        done = run("cmake", "-S", str(self.root), "-B", str(self.build), "-DBUILD_TESTING=ON",
                   "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_C_FLAGS_RELEASE=" + FLAGS,
                   "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *cmake)
        if done.returncode == 0:
            done = run("cmake", "--build", str(self.build), "--parallel", "2")
        if done.returncode != 0:
            fail("the unchanged tree does not build:\n" + done.stdout[-3000:])
        self.compiler = Compiler(self.root, self.build)
        self.seconds = {}
        listed = json.loads(run("ctest", "--test-dir", str(self.build), "--show-only=json-v1").stdout)
        every = [t["name"] for t in listed["tests"]]
        self.tests = [name for name in every if not re.search(HEAVY, name)]
        self.slow = [name for name in every if re.search(r"^(memcheck|fault)_", name)]

    def try_unchanged(self):
        """Times the tests; one that fails in the unchanged tree says nothing, and is returned."""
        failing = []
        for test in self.tests:
            start = time.monotonic()
            if self._ctest([test]) != "passed":
                failing.append(test)
            self.seconds[test] = time.monotonic() - start
        self.tests = [test for test in self.tests if test not in failing]
        return failing

    def _limit(self, tests):
        return max([TEST_SECONDS] + [int(SLOWER * self.seconds.get(test, UNTIMED)) for test in tests])

    def _ctest(self, tests):
        pattern = "^(" + "|".join(tests) + ")$"
        words = ["ctest", "--test-dir", str(self.build), "-R", pattern, "--stop-on-failure",
                 "--timeout", str(self._limit(tests)), "--output-on-failure"]
        group = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            said = group.communicate(timeout=60 + self._limit(tests) * len(tests))[0].decode(errors="replace")
        except subprocess.TimeoutExpired:
            os.killpg(group.pid, signal.SIGKILL)
            group.communicate()
            return "timeout"
        if group.returncode == 0:
            return "passed"
        return "timeout" if "***Timeout" in said else "killed"

    def _make(self, targets):
        words = ["cmake", "--build", str(self.build), "--parallel", "1"]
        for target in targets:
            words += ["--target", target]
        return subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def _own_tests(self, name):
        parts = os.path.splitext(name)[0].split("/")
        wanted = {"test_" + parts[-1]}
        for start, pattern in OWN.items():
            if any(part.startswith(start) for part in parts) or (start in parts[-1] and start.endswith("kernel")):
                wanted |= set(pattern.split("|"))
        return [t for t in self.tests if t in wanted]

    def steps(self, name):
        own = self._own_tests(name)
        folder = next(f for f in FOLDERS if name.startswith(f + "/"))
        first = [t for t in FIRST[folder] if t in self.tests and t not in own]
        rest = [t for t in self.tests if t not in own and t not in first]
        return [step for step in (own, first, rest) if step], self._slow_ones(own + first)

    def _slow_ones(self, tests):
        """For what is still there: the same under valgrind, and everything failing beneath the programs."""
        watched = ["memcheck_" + test for test in tests + ["test_armtol_memory", "programs"]]
        return [test for test in self.slow if test in watched or test.startswith("fault_")]

    def judge(self, mutant):
        """'killed', 'timeout', 'survived'; None for what is no mutant."""
        name, number, changed = mutant
        path = self.root / name
        original = path.read_text()
        lines = original.splitlines(keepends=True)
        scratch = str(self.build / "mutant.o")
        self.compiler.remember(name, scratch)
        known = key_of(self.root, mutant) in explained(self.root)
        lines[number - 1] = changed
        try:
            path.write_text("".join(lines))
            if not self.compiler.differs(name, scratch):
                return None
            built = False
            steps, slow = self.steps(name)
            for place, step in enumerate(steps):
                executables = [t for t in step if t.startswith("test_")]
                if place == 0 and len(executables) == len(step):
                    if not self._make(executables):
                        return None
                elif not built:
                    built = True
                    if not self._make([]):
                        return None
                found = self._ctest(step)
                if found != "passed":
                    return found
            if known:
                return "survived"
            found = self._ctest(slow)
            path.write_text(original)
            if found == "passed" or not self._make([]) or self._ctest(slow) != "passed":
                return "survived" # what fails in the unchanged tree too says nothing
            return found
        finally:
            path.write_text(original)


# ---- all of it ----

def explained(root):
    """{what key_of gives: how many such lines there are, and why nothing notices}"""
    rows = (line.split("\t") for line in (root / EXPLAINED).read_text().splitlines() if not line.startswith("#"))
    return {tuple(row[:3]): (int(row[3]), row[4]) for row in rows}


def one_line(text):
    """Any white space as a blank: a table has a line a mutant."""
    return " ".join(text.split())


def write_survivors(build, root, results):
    left = [(m[0], m[1], key_of(root, m)[1], m[2]) for m, verdict in results if verdict == "survived"]
    (build / "survivors.json").write_text(json.dumps(left, indent=1))


def survivors_of(build, root):
    """Those of the last run whose line is still there: the one nearest to where it was."""
    path = build / "survivors.json"
    if not path.exists():
        fail("there is no %s; run without --again first" % path)
    mutants = []
    for name, number, line, changed in json.loads(path.read_text()):
        lines = (root / name).read_text().splitlines()
        there = [n for n in range(1, len(lines) + 1) if line_of(lines, n) == line]
        if there:
            mutants.append((name, min(there, key=lambda n: abs(n - number)), changed))
    return mutants


def line_of(lines, number):
    """A line; one that is no more than a brace with what stands before it."""
    text = one_line(lines[number - 1])
    return text if len(text) > 2 or number == 1 else line_of(lines, number - 1) + " " + text


def key_of(root, mutant):
    name, number, changed = mutant
    return name, line_of((root / name).read_text().splitlines(), number), one_line(changed)


def check_explained(root):
    """A row has to mean as many lines as it says."""
    for (name, line, _), (count, _) in explained(root).items():
        lines = (root / name).read_text().splitlines() if (root / name).exists() else []
        there = sum(line_of(lines, n) == line for n in range(1, len(lines) + 1))
        if there != count:
            fail("%s: %s: there are %d lines \"%s\"; expected %d" % (EXPLAINED, name, there, line, count))


def draw(trees, pool, wanted, report):
    """The first `wanted` of the pool that are mutants, judged, in the pool's order whatever finishes first."""
    free = queue.Queue()
    for tree in trees:
        free.put(tree)

    def judge(mutant):
        tree = free.get()
        try:
            return tree.judge(mutant)
        finally:
            free.put(tree)

    results, pending, position = [], [], iter(pool)
    with concurrent.futures.ThreadPoolExecutor(len(trees)) as threads:
        while len(results) < wanted:
            while len(pending) < len(trees) + 1:
                mutant = next(position, None)
                if mutant is None:
                    break
                pending.append((mutant, threads.submit(judge, mutant)))
            if not pending:
                break
            mutant, future = pending.pop(0)
            verdict = future.result()
            if verdict is not None:
                results.append((mutant, verdict))
                report(len(results), mutant, verdict)
        for _, future in pending:
            future.cancel()
    return results


def print_table(results, reasons, root):
    print("\n%-12s %8s %8s %8s %10s %9s" % ("folder", "mutants", "killed", "timeout", "equivalent", "survived"))
    good = 0
    for folder in FOLDERS + ("all",):
        mine = [(m, v) for m, v in results if folder == "all" or m[0].startswith(folder + "/")]
        same = [m for m, v in mine if v == "survived" and key_of(root, m) in reasons]
        count = lambda verdict: sum(v == verdict for _, v in mine)
        print("%-12s %8d %8d %8d %10d %9d" % (folder, len(mine), count("killed"), count("timeout"), len(same),
                                              count("survived") - len(same)))
        good = count("killed") + count("timeout") + len(same)
    return good / max(1, len(results))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--mutants", type=int, default=100)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--cmake", action="append", default=[])
    asked = parser.parse_args()
    root, build = asked.source.resolve(), asked.build.resolve()
    try:
        import universalmutator  # noqa: F401
    except ImportError:
        fail("the Python package universalmutator is not to be had")

    check_explained(root)
    if asked.again:
        pool = survivors_of(build, root)
        print("%d mutants that survived before" % len(pool), flush=True)
    else:
        pool = [mutant for name in sources(root, asked.only) for mutant in mutants_of(root, name)]
        random.Random(asked.seed).shuffle(pool)
        print("%d mutants, drawn with seed %s from %d" % (asked.mutants, asked.seed, len(pool)), flush=True)

    trees = [Tree(root, build / ("tree-%d" % i), asked.cmake) for i in range(asked.jobs)]
    failing = trees[0].try_unchanged()
    for tree in trees[1:]:
        tree.tests, tree.seconds = trees[0].tests, trees[0].seconds
    if failing:
        print("left out, they fail in the unchanged tree: " + " ".join(failing))
    print("%d tests, %d seconds each at the most" % (len(trees[0].tests), TEST_SECONDS), flush=True)
    reasons = explained(root)
    lines = {}

    def report(n, mutant, verdict):
        name, number, changed = mutant
        if name not in lines:
            lines[name] = (root / name).read_text().splitlines()
        known = verdict == "survived" and reasons.get(key_of(root, mutant))
        print("%4d %-9s %s:%d" % (n, "equivalent" if known else verdict, name, number), flush=True)
        if verdict == "survived" and not known:
            print("     - %s\n     + %s" % (lines[name][number - 1].strip(), changed.strip()), flush=True)

    results = draw(trees, pool, len(pool) if asked.again else asked.mutants, report)
    write_survivors(build, root, results)
    share = print_table(results, reasons, root)
    killed = sum(verdict != "survived" for _, verdict in results) / max(1, len(results))
    print("\n%.1f of 100 killed; with those that nothing could notice %.1f; wanted: %.0f"
          % (100 * killed, 100 * share, 100 * WANTED))
    wrong = [m for m, verdict in results if verdict != "survived" and key_of(root, m) in reasons]
    for mutant in wrong:
        print("%s explains what is killed: %s" % (EXPLAINED, "\t".join(key_of(root, mutant))))
    sys.exit(0 if share >= WANTED and not wrong else 1)


if __name__ == "__main__":
    main()
