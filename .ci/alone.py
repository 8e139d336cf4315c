#!/usr/bin/env python3
"""Compiles sources alone that may miss an include since a commit: those that were changed, and those that a header reaches
which has lost an include. Unity builds pass where another source of the unit includes what is missing; users' builds fail.
    .ci/alone.py BASE     for .ci/tidy.sh, whose compilation database it uses"""
import collections
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

MOST_SOURCES = 120  # of 5 s each; the nearest to what was changed come first
DATABASE = "build/tidy/compile_commands.json"
INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)


def git(*words):
    return subprocess.run(["git", *words], capture_output=True, text=True, check=True).stdout


def changed(base):
    """Sources that differ from the base, and headers that have lost an include since."""
    names = git("diff", "--name-only", "--no-renames", "--diff-filter=d", base, "--", "*.cpp", "*.h").split()
    lost = {name for name in names if name.endswith(".h")
            and re.search(r"^-#include", git("diff", "-U0", base, "--", name), re.MULTILINE)}
    return [name for name in names if name.endswith(".cpp")], lost


def reached(headers):
    """Sources that include one of the headers, themselves or by other headers, the nearest first."""
    includers = collections.defaultdict(list)
    for name in git("ls-files", "*.cpp", "*.h").split():
        with open(name, encoding="utf-8") as file:
            for included in INCLUDE.findall(file.read()):
                includers[included].append(name)
    seen, waiting = set(headers), collections.deque(sorted(headers))
    while waiting:
        for name in includers[waiting.popleft()]:
            if name not in seen:
                seen.add(name)
                waiting.append(name)
                if name.endswith(".cpp"):
                    yield name


def complaints(command):
    words = shlex.split(command)
    words[words.index("-o"):words.index("-o") + 2] = []
    done = subprocess.run([*words, "-fsyntax-only"], capture_output=True, text=True, check=False)
    return done.stderr if done.returncode else ""


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    with open(DATABASE, encoding="utf-8") as file:
        commands = {os.path.relpath(entry["file"]): entry["command"] for entry in json.load(file)}
    sources, lost = changed(sys.argv[1])
    names = [name for name in dict.fromkeys([*sources, *reached(lost)]) if name in commands]
    print(f"alone: {len(names)} sources may miss an include, {min(len(names), MOST_SOURCES)} of them are compiled")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        found = list(workers.map(complaints, (commands[name] for name in names[:MOST_SOURCES])))
    sys.stderr.write("".join(found))
    return any(found)


if __name__ == "__main__":
    sys.exit(main())
