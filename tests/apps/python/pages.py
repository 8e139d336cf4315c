"""Blocks of code of the documentation's pages, and a folder in which they run."""
import os
import re
import textwrap
from pathlib import Path

import pytest

import trivet

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("TRIVET_PROGRAM")
BLOCK = re.compile(r"^\.\. code-block:: (\w+)\n((?:   :\w+:.*\n)*)\n((?:(?:   .*)?\n)+)", re.M)
FENCE = re.compile(r"^```(?:\{code-block\} )?(\w+)\n(?::caption: (\S+)\n\n)?(.*?)^```$", re.M | re.S)
INDENTED = re.compile(r"(?<=\n\n)((?:    .*\n)+)")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty folder to work in, with the program on the path, and Python where the package is."""
    monkeypatch.chdir(tmp_path)
    package = str(Path(trivet.__file__).parents[1])
    monkeypatch.setenv("PYTHONPATH", package + os.pathsep + os.environ.get("PYTHONPATH", ""))
    if PROGRAM:
        monkeypatch.setenv("PATH", os.path.dirname(PROGRAM) + os.pathsep + os.environ["PATH"])
    return tmp_path


def page_text(page):
    return (ROOT / page).read_text(encoding="utf-8") + "\n"


def blocks(page):
    """(language, file name, text) of each block of code of a page of docs."""
    source = page_text("docs/" + page)
    if page.endswith(".md"):
        for language, caption, text in FENCE.findall(source):
            yield language, caption, text
        return
    for language, options, text in BLOCK.findall(source):
        caption = re.search(r":caption: (\S+)", options)
        yield language, caption and caption.group(1), textwrap.dedent(text)


def indented_blocks(page):
    """Texts of a page's blocks of code without a language."""
    return [textwrap.dedent(text) for text in INDENTED.findall(re.sub(FENCE, "", page_text(page)))]
