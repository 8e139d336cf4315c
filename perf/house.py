"""Counts of a source tree that docs/measurements/house.md lists: one for each bar that can be counted without building.

house.py ROOT. Universal Ctags finds the functions. Bodies are sources without headers; comments are lines that hold nothing else.
"""
import pathlib
import re
import statistics
import subprocess
import sys

ROOT = pathlib.Path(sys.argv[1])
TOP = ("include", "core", "raster", "gpu", "ops", "apps")
OPENING = re.compile(r"\s*///?<?\s(Of|Those|What|Whether|That|Nothing|Beside|How)\b")


def files(*endings):
    return [p for top in TOP for p in sorted((ROOT / top).rglob("*")) if p.suffix in endings and p.is_file()]


def lines(path):
    return path.read_text(encoding="utf-8", errors="replace").split("\n")[:-1]


def is_comment(line):
    return line.strip().startswith("//")


def is_code(line):
    return bool(line.strip()) and not is_comment(line)


def functions():
    """Lines of each function."""
    command = ["ctags", "-x", "--language-force=C++", "--kinds-C++=f", "--_xformat=%n %e %N %F", *map(str, files(".h", ".cpp"))]
    out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    spans = [line.split()[:2] for line in out.splitlines()]
    return sorted(int(end) - int(begin) + 1 for begin, end in spans)


def comments_per_hundred(paths):
    texts = [lines(p) for p in paths]
    return 100 * sum(map(is_comment, sum(texts, []))) / sum(map(is_code, sum(texts, [])))


def openings():
    """Blocks of comments that begin without a subject."""
    count = 0
    for path in files(".h", ".cpp"):
        before = ""
        for line in lines(path):
            count += bool(OPENING.match(line)) and not is_comment(before)
            before = line
    return count


def members(path):
    """Members of the classes in a header, by their names."""
    return len(set(re.findall(r"\bm_\w+", "\n".join(lines(path)))))


def naming(word):
    pattern = re.compile(r"\b%s\b" % word)
    return sum(any(pattern.search(line) for line in lines(p)) for p in files(".h", ".cpp", ".py", ".js", ".json"))


def row(name, *values):
    print("| " + " | ".join([name, *(f"{v:,.1f}".rstrip("0").rstrip(".") if isinstance(v, float) else f"{v:,}" for v in values)]) + " |")


def main():
    sizes = sorted(len(lines(p)) for p in files(".h", ".cpp", ".py", ".js", ".mjs"))
    spans = functions()
    row("product lines", sum(sizes))
    row("files; their median, longest", len(sizes), int(statistics.median(sizes)), sizes[-1])
    row("files over 350 lines", sum(size > 350 for size in sizes))
    row("functions; their median, 95 %, longest", len(spans), int(statistics.median(spans)), spans[95 * len(spans) // 100], spans[-1])
    row("comment lines per 100 of code: headers", comments_per_hundred(files(".h")))
    row("the same: bodies", comments_per_hundred(files(".cpp")))
    row("comments that open without a subject", openings())
    row("product files naming step_up", naming("step_up"))
    row("members of the classes in a header, at most", max(map(members, files(".h"))))


main()
