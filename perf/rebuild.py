"""Cost of compiling again what includes a header, and of a build from nothing.

rebuild.py BUILD [HEADER ...] [--sample N] [--only PREFIX]. BUILD is a configured folder with compile_commands.json. For each header:
sources that reach it, units (files of joined sources) that have one of these, and their lines with the project's headers of each unit
counted once. --sample N compiles N of all units, evenly spread over them by size, without the compiler cache, and scales CPU seconds
by lines; their precompiled headers have to be built (ninja's targets *.gch).
"""
import argparse
import json
import os
import re
import resource
import shlex
import subprocess
import sys

kInclude = re.compile(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]', re.M)


class Tree:
    """The project's files and which of its files each includes."""

    def __init__(self, root):
        self.root, self.direct, self.lines = root, {}, {}

    def includes(self, file):
        if file not in self.direct:
            text = ""
            if os.path.exists(file):  # what the build makes may not be there yet
                with open(file, errors="replace") as stream:
                    text = stream.read()
            self.lines[file] = text.count("\n")
            near = [self.root, os.path.join(self.root, "include"), os.path.join(self.root, "tests"), os.path.dirname(file)]
            paths = [next((p for d in near if os.path.isfile(p := os.path.normpath(os.path.join(d, name)))), None)
                     for name in kInclude.findall(text)]
            self.direct[file] = [p for p in paths if p]
        return self.direct[file]

    def reached(self, files):
        seen, open_files = set(files), list(files)
        while open_files:
            for found in self.includes(open_files.pop()):
                if found not in seen:
                    seen.add(found)
                    open_files.append(found)
        return seen


class Unit:
    """One run of the compiler."""

    def __init__(self, entry, tree):
        self.command, self.folder, file = entry["command"], entry["directory"], entry["file"]
        joined = kInclude.findall(open(file).read()) if os.path.basename(file).startswith("unity_") else []
        self.sources = [os.path.normpath(os.path.join(os.path.dirname(file), name)) for name in joined] or [file]
        self.reached = tree.reached(self.sources)
        self.lines = sum(tree.lines.get(each, 0) for each in self.reached)

    def seconds(self):
        words = shlex.split(self.command)
        words[words.index("-o") + 1] = os.devnull
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(words, cwd=self.folder, check=True, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def units_of(build, root, prefix):
    with open(os.path.join(build, "compile_commands.json")) as stream:
        entries = json.load(stream)
    tree = Tree(root)
    units = [Unit(e, tree) for e in entries if e["file"].endswith((".cpp", ".cxx")) and not e["file"].endswith("cmake_pch.hxx.cxx")]
    return tree, [u for u in units if all(os.path.relpath(s, root).startswith(prefix) for s in u.sources)]


def rate_of(units, count):
    """CPU seconds per line, by units of all sizes. What needs generated files that are not there is left out."""
    ordered = sorted(units, key=lambda unit: unit.lines)
    seconds = lines = 0
    for i in range(count):
        unit = ordered[(2 * i + 1) * len(ordered) // (2 * count)]
        try:
            seconds += unit.seconds()
            lines += unit.lines
        except subprocess.CalledProcessError:
            print("left out: " + unit.sources[0], file=sys.stderr)
    return seconds / lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("headers", nargs="*")
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    with open(os.path.join(arguments.build, "CMakeCache.txt")) as stream:
        root = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", stream.read(), re.M).group(1)
    tree, units = units_of(arguments.build, root, arguments.only)
    rate = rate_of(units, arguments.sample) if arguments.sample else None
    sources = [s for unit in units for s in unit.sources]
    print("| touched | sources | units | lines | CPU seconds |\n|---|---|---|---|---|")
    for header in [None] + arguments.headers:
        path = header and os.path.join(root, header)
        again = [unit for unit in units if not path or path in unit.reached]
        lines, num = sum(unit.lines for unit in again), sum(not path or path in tree.reached([s]) for s in sources)
        print(f"| {header or 'everything'} | {num} of {len(sources)} | {len(again)} of {len(units)} | {lines} | "
              f"{f'{rate * lines:.0f}' if rate else '-'} |")


if __name__ == "__main__":
    main()
