"""Rooms that a run of the program enters, and its climbs: calls from a room to one above it.

walk.py ROOT PROFILE. The profile is callgrind's, of a build with symbols:
    valgrind --tool=callgrind --callgrind-out-file=PROFILE --compress-strings=no --compress-pos=no \\
        build/dev/apps/trivet run layout.json -o scene.glb --threads 1 --detector bvh --import-in-process
A room is a folder. Universal Ctags tells where a function is; names that stand in several rooms are left out, and calls pass through
them as through the standard library.
"""
import collections
import re
import subprocess
import sys

ROOT, PROFILE = sys.argv[1:]
ROOMS = ["core/" + r for r in ("base mesh motion index contact exact candidates model flex scene convex io picture").split()]
ROOMS += ["raster", "gpu"]
ROOMS += ["ops/" + r for r in ("base detect placement settle stability free_places operations check arrange mend files session "
                               "simulation").split()]
ROOMS += ["apps/" + r for r in "detection demo library trivet python edit farm".split()]


def room_of_file(file):
    parts = file.split("/")
    return parts[0] if parts[0] in ("raster", "gpu") else "/".join(parts[:2])


def definitions():
    """Rooms of functions by their qualified names."""
    files = subprocess.run(["git", "-C", ROOT, "ls-files", "core", "raster", "gpu", "ops", "apps"], capture_output=True, text=True,
                           check=True).stdout.split()
    files = [f for f in files if f.endswith((".h", ".cpp"))]
    tags = subprocess.run(["ctags", "-x", "--language-force=C++", "--kinds-C++=f", "--_xformat=%N %F %s", *files], cwd=ROOT,
                          capture_output=True, text=True, check=True).stdout
    out = collections.defaultdict(set)
    for words in map(str.split, tags.splitlines()):
        scope = [part for part in (words[2] if len(words) > 2 else "").split("::") if part and not part.startswith("__anon")]
        out["::".join([*scope, words[0]])].add(room_of_file(words[1]))
    return out


def bare(function):
    """Its qualified name without arguments and the type that templates return."""
    name, depth, begin = function.replace("(anonymous namespace)", "anonymous"), 0, 0
    for at, letter in enumerate(name):
        depth += (letter == "<") - (letter == ">")
        if letter == " " and depth == 0:
            begin = at + 1
        if letter == "(" and depth == 0:
            return re.sub(r"<.*>", "", name[begin:at])
    return re.sub(r"<.*>", "", name[begin:])


class Rooms:
    def __init__(self):
        self.where, self.known = definitions(), {}

    def of(self, function):
        if function not in self.known:
            self.known[function] = self.find([part for part in bare(function).split("::") if part != "anonymous"])
        return self.known[function]

    def find(self, names):
        if names[0] != "trivet" or names[-1] == names[-2]:  # not ours, or made by the compiler
            return None
        rooms = self.where.get("::".join(names), set())
        return min(rooms) if len(rooms) == 1 else None


def calls():
    out, current = collections.defaultdict(set), None
    with open(PROFILE) as profile:
        for line in profile:
            if line.startswith("fn="):
                current = line[3:].strip()
            elif line.startswith("cfn="):
                out[current].add(line[4:].strip())
    return out


def callees(function, graph, rooms, seen):
    """(function, passed through others?) of those whose rooms are known."""
    for called in graph.get(function, ()):
        if called in seen:
            continue
        seen.add(called)
        if rooms.of(called):
            yield called
        else:
            yield from callees(called, graph, rooms, seen)


def main():
    sys.setrecursionlimit(100_000)
    graph, rooms = calls(), Rooms()
    entered, climbs = collections.Counter(), set()
    for function in list(graph):
        here = rooms.of(function)
        if not here:
            continue
        entered[here] += 1
        for called in callees(function, graph, rooms, set()):
            there = rooms.of(called)
            hidden = "(anonymous" in called and called in graph[function]  # of its own file: the tags err
            if not hidden and here in ROOMS and there in ROOMS and ROOMS.index(there) > ROOMS.index(here):
                climbs.add((here, there, bare(called)))
    print(f"{len(entered)} rooms: " + ", ".join(f"{room} ({count} functions)" for room, count in entered.most_common()))
    for climb in sorted(climbs):
        print("climb: %s to %s, %s" % climb)


main()
