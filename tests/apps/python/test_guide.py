"""The guide, the front page and the tutorials: every block of code states its language, and what can run here runs.

bash and python run; json is judged by the program's schemas, wrapped where it is a part of a file; text is what a program
prints; console builds, installs or opens windows, which other tests do.
"""
import contextlib
import json
import os
import re
import shutil
import signal
import struct
import subprocess

import pytest

import trivet
from pages import PROGRAM, ROOT, blocks, folder, indented_blocks, page_text  # noqa: F401, a fixture

GUIDE = sorted("guide/" + path.name for path in (ROOT / "docs/guide").glob("*.md"))
CONSOLE = {"guide/packages.md": 2, "guide/editor.md": 1, "tutorial/cpp.md": 1}
# Blocks run with fewer scenes and smaller pictures than users want.
SMALLER = [(r"--count 1000\b", "--count 4"), (r"--dome 20\b", "--dome 2 --width 64 --height 48"), (r"--samples 64", "--samples 1"),
           (r"--width 1280 --height 720", "--width 128 --height 72"), (r"(^|\s)apps/", rf"\1{ROOT}/apps/"),
           (r"\bsbatch\b", "test -s"), (r"--fps 24", "--fps 2 --width 64 --height 48 --samples 1"), (r"8347", "18347"),
           (r"--simulate 5", "--simulate 0.2")]
SMALL_VIEWS = {"width": 64, "height": 48, "samples": 1, "dome": {"count": 1}}
CASES = ROOT / "tests/core/io/foreign/cases"
TABLE = """<mujoco><worldbody><geom type="plane" size="2 2 .1"/>
<body name="table" pos="0 0 .2"><geom type="box" size=".5 .5 .2"/></body>
<body name="plate" pos="0 0 .445"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
</worldbody></mujoco>"""
# Boxes of the models of guide/joints.md: centre and half extents.
UNIT = {"cabinet": [(-0.19, 0, 0.2, 0.01, 0.19, 0.2), (0.19, 0, 0.2, 0.01, 0.19, 0.2), (0, 0, 0.01, 0.18, 0.19, 0.01),
                    (0, 0, 0.2, 0.18, 0.19, 0.01), (0, 0, 0.39, 0.18, 0.19, 0.01), (0, 0.18, 0.2, 0.18, 0.01, 0.2)],
        "drawer": [(0, -0.0175, 0.23, 0.17, 0.1775, 0.005), (0, -0.2, 0.3, 0.185, 0.01, 0.08)], "door": [(-0.2, 0, 0.1, 0.19, 0.008, 0.09)],
        "spoon": [(0, 0, 0, 0.01, 0.06, 0.003)]}
LAYOUT = {"trivet": 1, "floor": True, "objects": [{"name": "cup", "model": "cup.glb"}],
          "operations": [{"op": "put", "object": "cup", "position": [0, 0, 1]}]}
# Names that guide/python.md presupposes.
PRESUPPOSED = """
import numpy as np, trivet

class Mesh:
    def __init__(self, shape):
        self.vertices, self.faces = shape.vertices, shape.faces
    def apply_transform(self, matrix):
        assert matrix.shape == (4, 4)

mesh, apples, mouse = Mesh(trivet.Shape.load("cup.glb")), [], [(0.02, 0.01)]
names, shapes, poses = ["cup"], [trivet.Shape.load("cup.glb")], [np.eye(4)]
camera = trivet.Camera.look_at([1, -2, 2], [0, 0, 0.7], size=(64, 48))
lid = pot = shapes[0]
lid_pose, pot_pose, axis, centre = np.eye(4), np.eye(4), [0, 0, 1], [0, 0, 0]
lid_pose[0, 3] = 0.5
"""

needs_program = pytest.mark.skipif(not PROGRAM, reason="TRIVET_PROGRAM is not set")


def program(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def without_extras(value):
    if isinstance(value, dict):
        return {key: without_extras(one) for key, one in value.items() if key != "extras"}
    return [without_extras(one) for one in value] if isinstance(value, list) else value


def write_foreign_room(path):
    """BREAKFAST as another program would write it, with an apple that is called vase."""
    program("demo", "breakfast", "-o", path)
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]  # of the first chunk, which is JSON
    room = without_extras(json.loads(data[20:20 + length]))
    room["asset"]["generator"] = "another program"
    for node in room["nodes"]:
        if node.get("name") == "apple_1":
            node["name"] = "vase"
    text = json.dumps(room).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    path.write_bytes(struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(rest), len(text), b"JSON") + text + rest)


def small_recipe():
    """The recipe of guide/batches.md, with small pictures."""
    text = next(text for language, _, text in blocks("guide/batches.md") if language == "json")
    return {**json.loads(text), "views": SMALL_VIEWS}


# A simulator in which nothing moves.
ENGINE = """#!/usr/bin/env python3
import json
rows = [json.loads(line) for line in open("still.jsonl")]
print(json.dumps({"objects": [{"name": r["name"], "position": [r["x"], r["y"], r["z"]],
                               "rotation": [r["qw"], r["qx"], r["qy"], r["qz"]]} for r in rows if not r["fixed"]]}))
"""


def obj_of(boxes):
    lines = []
    for first, (x, y, z, a, b, c) in enumerate(boxes):
        lines += ["v %g %g %g" % (x + (a if i & 1 else -a), y + (b if i & 2 else -b), z + (c if i & 4 else -c)) for i in range(8)]
        lines += ["f %d %d %d %d" % tuple(8 * first + 1 + v for v in side) for side in
                  ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))]
    return "\n".join(lines) + "\n"


def prepare(folder, page):
    """Writes the files that pages presuppose: the models of BREAKFAST in models and here, and files that they name."""
    program("demo", "breakfast", "-o", "breakfast.glb", "--export", "models", "--quiet")
    for path in (folder / "models").glob("*.glb"):
        shutil.copy(path, folder)
    for name in ("a.glb", "b.glb", "room.glb"):
        shutil.copy("breakfast.glb", name)
    (folder / "layout.json").write_text(json.dumps(LAYOUT))
    (folder / "recipe.json").write_text(json.dumps(small_recipe()))
    if page == "guide/in-place.md":
        write_foreign_room(folder / "room.glb")
    if page == "guide/joints.md":
        for name, boxes in UNIT.items():
            (folder / (name + ".obj")).write_text(obj_of(boxes))
        (folder / "layout.json").write_text(next(text for language, _, text in blocks(page) if language == "json"))
    if page == "guide/sessions.md":
        shutil.copy(CASES / "drawer.xml", "kitchen.xml")
    if page == "guide/simulators.md":
        program("settle", str(CASES / "drawer.xml"), "-o", "kitchen.xml")
        shutil.copy(CASES / "drawer.urdf", "cabinet.urdf")
        program("export", "breakfast.glb", "-o", "still.jsonl")
        (folder / "engine").write_text(ENGINE)
        (folder / "engine").chmod(0o755)
    if page == "guide/scenes-of-others.md":
        for name in ("robot.urdf", "world.sdf"):
            program("export", "breakfast.glb", "-o", name)
        shutil.copy(CASES / "drawer.usda", "room.usda")
        (folder / "dataset").mkdir()
        shutil.copy(CASES / "drawer.urdf", "cabinet.urdf")
        kitchen = (CASES / "drawer.xml").read_text().replace('"in the drawer"', '"cube"').replace('name="slide"', 'name="drawer"')
        for name in ("kitchen.xml", "dataset/one.xml"):
            (folder / name).write_text(kitchen)
        (folder / "table.xml").write_text(TABLE)


def run_bash(text, where):
    """Runs a block. Verdicts may find something: that is status 1."""
    for pattern, other in SMALLER:
        text = re.sub(pattern, other, text, flags=re.M)
    before = 'trivet() { command trivet "$@" || [ $? = 1 ]; }\n'
    with open("block.log", "w+") as log:  # a pipe would wait for servers that a block leaves behind
        bash = subprocess.Popen(["bash", "-euo", "pipefail", "-c", before + text], stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                start_new_session=True)
        try:
            status = bash.wait(timeout=600)
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(bash.pid, signal.SIGTERM)
        log.seek(0)
        assert status == 0, f"{where}:\n{text}\n{log.read()}"


def json_values(text):
    """The values of a block, one after the other; a member without braces gets some."""
    decoder, values = json.JSONDecoder(), []
    text = "{" + text + "}" if text.startswith('"') else text
    while text.strip():
        value, end = decoder.raw_decode(text.strip())
        values.append(value)
        text = text.strip()[end:]
    return values


def whole(value):
    """(schema, document) of a value: a layout or a recipe that has it."""
    recipe = small_recipe()
    if "trivet" in value or "trivet_recipe" in value:
        return ("recipe" if "trivet_recipe" in value else "layout"), value
    if "views" in value:
        return "recipe", {**recipe, **value}
    if "look" in value:
        return "recipe", {**recipe, "groups": [{**recipe["groups"][0], **value}]}
    if "model" in value and "name" not in value:
        return "recipe", {**recipe, "groups": [{**recipe["groups"][0], "models": [value]}]}
    if "op" in value:
        return "layout", {**LAYOUT, "operations": [value]}
    return "layout", {**LAYOUT, **value} if "pairs" in value else {**LAYOUT, "objects": [value], "operations": []}


def judge_json(text, where):
    jsonschema = pytest.importorskip("jsonschema", reason="jsonschema is missing (Debian: python3-jsonschema)")
    for value in json_values(text):
        kind, document = whole(value)
        validator = jsonschema.Draft202012Validator(json.loads(program("schema", kind)))
        assert [error.message for error in validator.iter_errors(document)] == [], where


@needs_program
@pytest.mark.parametrize("page", [page for page in GUIDE if page not in ("guide/index.md", "guide/python.md")])
def test_every_block_of_the_guide(page, folder):
    prepare(folder, page)
    names = {"__name__": "page", "trivet": trivet}
    for number, (language, file, text) in enumerate(blocks(page), 1):
        where = f"{page}, block {number}"
        if file and file != "recipe.json":
            (folder / file).write_text(text)
        if language == "json":
            judge_json(text, where)
        elif language == "python":
            exec(compile(re.sub(r"\b1000\b", "4", text), where, "exec"), names)
        elif language == "bash":
            run_bash(text, where)
        else:
            assert language in ("text", "console"), where


@needs_program
def test_the_lines_of_the_front_page(folder):
    commands = [one for one in indented_blocks("README.md") if one.startswith("trivet ")]
    assert len(commands) == 1
    run_bash(commands[0], "README.md")
    (lines,) = [one for one in indented_blocks("README.md") if one.startswith("scene = ")]
    exec(compile(lines, "README.md", "exec"), {"trivet": trivet})


@needs_program
def test_python_at_a_glance(folder):
    """The lines of guide/python.md, with the names that they presuppose."""
    prepare(folder, "guide/python.md")
    (lines,) = [text for language, _, text in blocks("guide/python.md") if language == "python"]
    names = {}
    exec(PRESUPPOSED, names)
    exec(compile(re.sub(r"dome\(100", "dome(2", lines), "guide/python.md", "exec"), names)


@pytest.mark.parametrize("page", GUIDE + ["tutorial/cpp.md", "tutorial/blender.md", "tutorial/editor.md"])
def test_blocks_state_their_language(page):
    assert indented_blocks("docs/" + page) == []
    assert sum(language == "console" for language, _, _ in blocks(page)) == CONSOLE.get(page, 0)
    assert {language for language, _, _ in blocks(page)} <= {"bash", "python", "json", "text", "console", "cpp", "cmake"}


def test_the_tutorial_in_cpp_has_the_program_of_the_front_page():
    """tests/install compiles the front page's."""
    def lines(text):
        return [line.strip() for line in text.splitlines() if line.strip()]
    (program_of_readme,) = re.findall(r"```cpp\n(.*?)```", page_text("README.md"), re.S)
    first = next(text for language, _, text in blocks("tutorial/cpp.md") if language == "cpp")
    body = [re.sub(r"\s+// .*", "", line) for line in lines(first)]
    assert [line for line in lines(program_of_readme) if line not in body] == []
