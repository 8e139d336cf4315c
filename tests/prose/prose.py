#!/usr/bin/env python3
"""Counts in documents and comments what can be counted: long lines and sentences, comments without a subject, histories.
    tests/prose/prose.py ROOT [--list]
Prints a table, with --list each finding, the words of each page and the comments of each folder of algorithms; the status is 1
where a count is beyond its limit."""
import ast
import re
import subprocess
import sys
from pathlib import Path

import bodies

ROOT = Path(sys.argv[1]).resolve()
MOST_WORDS_OF_SENTENCE, MOST_COLUMNS = 30, 100
OPENING = re.compile(r"(Of|Those|What|Whatever|Whether|Whoever|That|Nothing|Beside|How)\b")
HISTORY = re.compile(r"\b20\d\d-\d\d-\d\d\b|\b(?=[0-9a-f]*\d)(?=[0-9a-f]*[a-f])[0-9a-f]{7,12}\b|\bload (of )?\d")
# Most words of a page.
PAGES = [(re.compile(r"README\.md$"), 700), (re.compile(r".+/README\.md$"), 200), (re.compile(r"CONTRIBUTING\.md$"), 500)]
MOST_WORDS_OF_READMES = 8000
LEAST_COMMENTS_OF_BODIES = 8  # lines per 100 in bodies of functions of the algorithms
# Histories are what these are for.
DATED = ("CHANGELOG.md", "docs/measurements/", "docs/design/decisions.md", "perf/results/")
LIMITS = {"comments that open without a subject": 0, "docstrings that open without a subject": 0, "long lines in prose": 0,
          "long sentences": 0, "pages above their limit of words": 0, "dates, hashes and loads": 0}


def tracked(*patterns):
    done = subprocess.run(["git", "-C", ROOT, "ls-files", *patterns], capture_output=True, text=True, check=True)
    return [name for name in done.stdout.split("\n") if name]


def read(name):
    return (ROOT / name).read_text(encoding="utf-8", errors="replace")


def openings(name):
    """Lines on which a block of comments begins without a subject."""
    mark = re.compile(r"\s*#\s(.*)" if name.endswith((".py", ".sh")) else r"\s*///?<?\s(.*)")
    inside = False
    for number, line in enumerate(read(name).split("\n"), 1):
        found = mark.fullmatch(line)
        if found and not inside and OPENING.match(found.group(1)):
            yield number, found.group(1)
        inside = bool(found)


def docstrings(name):
    """Docstrings that begin without a subject."""
    for node in ast.walk(ast.parse(read(name))):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            text = ast.get_docstring(node) or ""
            if OPENING.match(text):
                yield node.body[0].lineno, text.split("\n")[0]


def prose(text):
    """(line number, line) of running text: no code, tables, headings, links that cannot be broken."""
    fenced = False
    for number, line in enumerate(text.split("\n"), 1):
        if line.lstrip().startswith(("```", ":::")):
            fenced = not fenced
        elif not fenced and not line.startswith(("    ", "|", "#", "![", "```")):
            yield number, line


def sentences(text):
    """(first line number, sentence) of paragraphs and items of lists."""
    paragraph, start = [], 0
    for number, line in list(prose(text)) + [(0, "")]:
        if not line.strip() or re.match(r"\s*(?:[-*]|\d+\.) ", line):
            for one in re.split(r"(?<=[.!?:;])\s+", " ".join(paragraph)):
                yield start, one
            paragraph = []
        if line.strip():
            start = start if paragraph else number
            paragraph.append(line.strip())


def findings():
    for name in tracked("*.h", "*.cpp", "*.py", "*.sh"):
        for number, text in openings(name):
            yield "comments that open without a subject", f"{name}:{number}: {text}"
    for name in tracked("*.py"):
        for number, text in docstrings(name):
            yield "docstrings that open without a subject", f"{name}:{number}: {text}"
    for name in tracked("*.md"):
        text = read(name)
        for pattern, most in PAGES:
            if pattern.fullmatch(name) and len(text.split()) > most:
                yield "pages above their limit of words", f"{name}: {len(text.split())} words, at most {most}"
        for number, line in prose(text):
            if len(line) > MOST_COLUMNS and " " in line.strip()[2:]:
                yield "long lines in prose", f"{name}:{number}: {len(line)} columns"
        for number, sentence in sentences(text):
            if len(sentence.split()) > MOST_WORDS_OF_SENTENCE:
                yield "long sentences", f"{name}:{number}: {len(sentence.split())} words: {sentence}"
        if not name.startswith(DATED):
            for number, line in enumerate(text.split("\n"), 1):
                if HISTORY.search(line):
                    yield "dates, hashes and loads", f"{name}:{number}: {line.strip()}"


def comments_of_algorithms():
    """Lines of comments per 100 in bodies of functions, of each folder and of all."""
    found = {}
    for folder in bodies.ALGORITHMS:
        counted = [bodies.counts(read(name)) for name in tracked(folder + "*.h", folder + "*.cpp")]
        found[folder] = [sum(column) for column in zip(*counted)]
    found["all"] = [sum(column) for column in zip(*found.values())]
    return {folder: 100 * comments / lines for folder, (comments, lines) in found.items()}


counts = dict.fromkeys(LIMITS, 0)
for kind, text in findings():
    counts[kind] += 1
    if "--list" in sys.argv or counts[kind] <= 20 and LIMITS[kind] == 0:
        print(f"{kind}: {text}")
for kind, limit in LIMITS.items():
    print(f"{counts[kind]:6}  {kind} (at most {limit})")
words = {name: len(read(name).split()) for name in tracked("*.md")}
if "--list" in sys.argv:
    for name, count in words.items():
        print(f"{count:6}  words of {name}")
rates = comments_of_algorithms()
if "--list" in sys.argv:
    for folder, rate in rates.items():
        print(f"{rate:6.1f}  lines of comments per 100 in bodies of {folder}")
words_of_readmes = sum(n for name, n in words.items() if name.endswith("README.md"))
print(f"{words_of_readmes:6}  words of READMEs (at most {MOST_WORDS_OF_READMES})")
print(f"{sum(n for name, n in words.items() if name.startswith('docs/')):6}  words of docs")
print(f"{rates['all']:6.1f}  lines of comments per 100 in bodies of the algorithms (at least {LEAST_COMMENTS_OF_BODIES})")
sys.exit(words_of_readmes > MOST_WORDS_OF_READMES or rates["all"] < LEAST_COMMENTS_OF_BODIES
         or any(counts[kind] > limit for kind, limit in LIMITS.items()))
