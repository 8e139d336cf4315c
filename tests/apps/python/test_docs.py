"""The pages of the documentation: every block of code runs, on the command line and in Python; notebooks too, without Jupyter."""
import ast
import doctest
import inspect
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import trivet
from pages import blocks, folder  # noqa: F401, a fixture

DOCS = Path(__file__).resolve().parents[3] / "docs" / "python"
PROGRAM = os.environ.get("TRIVET_PROGRAM")
needs_program = pytest.mark.skipif(not PROGRAM, reason="TRIVET_PROGRAM is not set")


def test_the_ten_examples_are_doctests(folder):
    for file in ("examples.rst", "farm.py"):
        shutil.copy(DOCS / file, folder)
    found = doctest.testfile(str(folder / "examples.rst"), module_relative=False)
    assert found.failed == 0 and found.attempted > 50
    assert len(re.findall(r"^\d+\. ", (DOCS / "examples.rst").read_text(encoding="utf-8"), re.M)) == 10


@needs_program
@pytest.mark.parametrize("page, least", [("python/index.rst", 1), ("python/tutorial.rst", 9), ("python/cookbook.rst", 29),
                                         ("tutorial/command-line.md", 4), ("tutorial/python.md", 5)])
def test_every_block_of_a_page_runs(page, least, folder):
    subprocess.run([PROGRAM, "demo", "breakfast", "-o", "breakfast.glb", "--export", "models", "--quiet"], check=True)
    names, count = {"__name__": "page"}, 0
    for language, file, text in blocks(page):
        count += 1
        if file:
            (folder / file).write_text(text)
        elif language == "python":
            exec(compile(text, f"{page}, block {count}", "exec"), names)
        else:
            assert language == "bash", language
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], capture_output=True, text=True, timeout=600)
            assert done.returncode == 0, f"{page}, block {count}:\n{text}\n{done.stdout}\n{done.stderr}"
    assert count >= least


def test_the_cookbook_has_eighteen_tasks():
    text = (DOCS / "cookbook.rst").read_text(encoding="utf-8")
    assert re.findall(r"^(\d+)\. .*\n-+$", text, re.M) == [str(k) for k in range(1, 19)]


def test_the_environment_is_reset_to_a_seed():
    names = {"__name__": "environment"}
    exec(compile((DOCS / "environment.py").read_text(encoding="utf-8"), "environment.py", "exec"), names)
    one, two = names["PushBlocks"](), names["PushBlocks"]()
    first, info = one.reset(seed=5)
    assert info == {} and first.shape == (3, 3) and (two.reset(seed=5)[0] == first).all()
    assert (two.reset(seed=6)[0] != first).any() and (two.reset(seed=5)[0] == first).all()
    for _ in range(20):
        seen, reward, done, cut, told = one.step(names["push_home"](one))
        assert (two.step(names["push_home"](two))[0] == seen).all() and told["refused"] in (False, True)
        if done:
            break
    assert done and -0.05 < reward < 0 and one.scene.check().ok


def run_cell(source, names):
    """As a notebook does: the value of a last expression is shown. Returns what would be."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if last is None:
        return None
    value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    return value._repr_html_() if hasattr(value, "_repr_html_") else repr(value)


@pytest.mark.parametrize("path", sorted((DOCS / "notebooks").glob("*.ipynb")), ids=lambda path: path.stem)
def test_notebooks_run(path, folder):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    assert (notebook["nbformat"], notebook["nbformat_minor"]) == (4, 5)
    names = {"__name__": "notebook"}
    shown = [run_cell("".join(cell["source"]), names) for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] for cell in notebook["cells"] if cell["cell_type"] == "code")
    assert len(shown) >= 3 and any("iframe" in (one or "") for one in shown)


def public_callables():
    """(name, function) of all that users call, but for what tuples have."""
    for name in trivet.__all__:
        one = getattr(trivet, name)
        if not isinstance(one, type):
            if callable(one):
                yield name, one
            continue
        for key, value in inspect.getmembers(one):
            home = getattr(value, "__module__", None) or ""
            if not key.startswith("_") and inspect.isroutine(value) and home.startswith("trivet."):
                yield f"{name}.{key}", value


def test_every_parameter_and_every_result_is_documented():
    """In numpydoc's sections; ``try_put`` and the like refer to the function that they are like."""
    docscrape = pytest.importorskip("numpydoc.docscrape", reason="numpydoc is missing (Debian: python3-numpydoc)")
    missing, count = [], 0
    for name, function in public_callables():
        count += 1
        signature = inspect.signature(function)
        given = [key for key in signature.parameters if key != "self"]
        text = inspect.getdoc(function)
        if re.match(r"As `\w+`, with its parameters", text) or not given:
            continue
        doc = docscrape.FunctionDoc(function)
        known = {part.strip().lstrip("*") for one in doc["Parameters"] for part in one.name.split(",")}
        missing += [f"{name}: {key}" for key in given if key not in known]
        missing += [f"{name}: there is no {key}" for key in known - set(given)]
        if signature.return_annotation not in ("None", None) and not doc["Returns"]:
            missing.append(f"{name}: Returns")
    assert count > 60 and missing == []


def test_every_property_is_documented():
    properties = [(f"{name}.{key}", value) for name in trivet.__all__ if isinstance(getattr(trivet, name), type)
                  for key, value in inspect.getmembers(getattr(trivet, name)) if isinstance(value, property)]
    assert len(properties) > 50
    assert [name for name, value in properties if not value.__doc__] == []


def test_all_that_is_public_has_a_place():
    text = (DOCS / "api.rst").read_text(encoding="utf-8")
    for name in trivet.__all__:
        assert name == "__version__" or f"trivet.{name}" in text, name
