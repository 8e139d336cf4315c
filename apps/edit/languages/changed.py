#!/usr/bin/env python3
"""Lists the texts of the editor that changed since a revision: gone ones and new ones, by their part of the program.

    changed.py REVISION [--refusals]

Texts of refusals and of readers, which the command line shares, are listed with --refusals only.
"""
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
FILE = "apps/edit/languages/trivet-edit_de.ts"
SHARED = "refusal"


def texts(xml: str) -> dict[str, set[str]]:
    return {context.find("name").text: {message.find("source").text for message in context.iter("message")}
            for context in ElementTree.fromstring(xml).iter("context")}


def text_at(revision: str) -> str:
    return subprocess.run(["git", "show", f"{revision}:{FILE}"], cwd=HERE, check=True, capture_output=True,
                          text=True).stdout


def main() -> None:
    revision, *options = sys.argv[1:] or sys.exit(__doc__)
    before, now = texts(text_at(revision)), texts((HERE / Path(FILE).name).read_text())
    for part in sorted(before.keys() | now.keys()):
        gone, new = before.get(part, set()) - now.get(part, set()), now.get(part, set()) - before.get(part, set())
        if not (gone or new) or (part == SHARED and "--refusals" not in options):
            continue
        print(f"{part}: {len(gone)} gone, {len(new)} new")
        for sign, changed in (("-", gone), ("+", new)):
            for text in sorted(changed):
                print(f"  {sign} {text}")


main()
