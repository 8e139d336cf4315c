"""The hand-written stub against the compiled module, and the types of the package."""
import importlib.util
import os
import subprocess
import sys

import pytest

import trivet

needs_mypy = pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="mypy is missing (Debian: mypy)")
PACKAGE = os.path.dirname(trivet.__file__)
FOLDER = os.path.dirname(os.path.abspath(__file__))


def run(*command):
    env = {**os.environ, "MYPYPATH": os.path.dirname(PACKAGE)}
    done = subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, env=env, timeout=300)
    if done.returncode != 0:
        pytest.fail(done.stdout + done.stderr, pytrace=False)


@needs_mypy
def test_the_stub_is_that_of_the_module():
    run("mypy.stubtest", "trivet._trivet", "--allowlist", os.path.join(FOLDER, "stubtest_allowlist.txt"))


@needs_mypy
def test_the_package_is_typed(tmp_path):
    run("mypy", "--strict", "--cache-dir", str(tmp_path), "-p", "trivet")


def test_all_that_is_public_is_documented():
    for name in trivet.__all__:
        one = getattr(trivet, name)
        assert name in ("CAUSES", "__version__") or one.__doc__, name
        if isinstance(one, type) and one.__module__.startswith("trivet."):
            for key, value in vars(one).items():
                if callable(value) and not key.startswith("_"):
                    assert value.__doc__, f"{name}.{key}"
