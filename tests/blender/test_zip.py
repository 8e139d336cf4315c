"""The zip that Blender installs."""
import ast
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPT = os.path.join(ROOT, "apps", "blender", "make_zip.py")


def make(path):
    subprocess.run([sys.executable, SCRIPT, path], check=True, capture_output=True)
    with open(path, "rb") as file:
        return file.read()


class Zip(unittest.TestCase):
    def test_has_the_version_of_the_project_in_both_places(self):
        with open(os.path.join(ROOT, "include/trivet/version.h"), encoding="utf-8") as file:
            version = ".".join(re.findall(r"#define TRIVET_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", file.read()))
        with tempfile.TemporaryDirectory() as folder:
            make(os.path.join(folder, "t.zip"))
            with zipfile.ZipFile(os.path.join(folder, "t.zip")) as archive:
                init = archive.read("trivet_addon/__init__.py").decode()
                manifest = archive.read("trivet_addon/blender_manifest.toml").decode()
        self.assertIn(f'version = "{version}"', manifest)
        info = next(node.value for node in ast.parse(init).body
                    if isinstance(node, ast.Assign) and node.targets[0].id == "bl_info")
        self.assertEqual(".".join(map(str, ast.literal_eval(info)["version"])), version)

    def test_has_the_same_bytes_each_time_and_every_module(self):
        with tempfile.TemporaryDirectory() as folder:
            first = make(os.path.join(folder, "a.zip"))
            self.assertEqual(make(os.path.join(folder, "b.zip")), first)
            with zipfile.ZipFile(os.path.join(folder, "a.zip")) as archive:
                names = set(archive.namelist())
        modules = [name for name in os.listdir(os.path.join(ROOT, "apps", "blender", "trivet_addon")) if name.endswith(".py")]
        self.assertEqual({f"trivet_addon/{name}" for name in modules},
                         names - {"trivet_addon/blender_manifest.toml", "trivet_addon/LICENSE"})

    def test_refuses_other_names(self):
        done = subprocess.run([sys.executable, SCRIPT, "addon.tar"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("usage", done.stderr)


class Package(unittest.TestCase):
    def test_imports_without_blender(self):
        self.assertIsNone(importlib.util.find_spec("bpy"))
        for name in ("bodies", "layouts", "work", "module", "program", "backends"):
            importlib.import_module(f"trivet_addon.{name}")
