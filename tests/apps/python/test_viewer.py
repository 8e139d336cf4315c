"""Pages of scenes: whole, and seen in a browser."""
import base64
import html
import json
import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from label_files import read_png  # noqa: E402

import trivet  # noqa: E402
from shapes import at, box, table_with_cup, torus  # noqa: E402

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
needs_chromium = pytest.mark.skipif(not CHROMIUM, reason="no chromium (Debian: chromium)")


def data_of(page):
    return json.loads(re.search(r'<script type="application/json" id="scene">(.*?)</script>', page, re.S).group(1))


def array(text, dtype):
    return np.frombuffer(base64.b64decode(text), dtype)


def small_scene():
    """A table, a cup on it in red, a stick that leans on nothing, and a box that is out of the scene."""
    scene = table_with_cup()
    scene.add("plate </script> & \"co\"", box(0.1, 0.1, 0.005).colored([0.8, 0.02, 0.02])).put([-0.2, -0.2, 0.5])
    scene.add("out", box())
    return scene


def test_a_page_needs_nothing_but_itself():
    page = small_scene().view(show=["contacts", "supports"]).html
    assert "http" not in page and "://" not in page
    assert not re.search(r"\b(src|href|import|fetch|XMLHttpRequest|WebSocket)\s*[=(]", page)
    assert page.count("</script>") == 2 and "@SCENE@" not in page


def test_a_page_has_the_scene():
    scene = small_scene()
    data = data_of(scene.view(show=["hulls"], highlight=[scene["cup"]]).html)
    placed = [o for o in scene if o.placed]
    assert [o["name"] for o in data["objects"]] == [o.name for o in placed] and data["show"] == ["hulls"]
    assert [o["highlight"] for o in data["objects"]] == [False, True, False]
    low = np.min([o.bounds[0] for o in placed], 0)
    high = np.max([o.bounds[1] for o in placed], 0)
    for one, shown in zip(placed, data["objects"]):
        mesh = data["meshes"][shown["mesh"]]
        matrix = np.array(shown["matrix"]).reshape(4, 4).T
        vertices = array(mesh["vertices"], np.float32).reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3] + (low + high) / 2
        wanted = one.shape.vertices @ one.matrix[:3, :3].T + one.matrix[:3, 3]
        assert np.abs(vertices - wanted).max() < 1e-6
        assert (array(mesh["faces"], np.uint32).reshape(-1, 3) == one.shape.faces).all()
        colors = np.array(mesh["palette"])[array(mesh["color"], np.uint16)]
        assert (colors == one.shape.face_colors()).all()
    assert len(array(data["contacts"]["point"], np.float32)) == 3 * len(scene.contacts())
    assert sorted(data["edges"]) == [[-1, 0], [0, 1], [0, 2]]
    cube = array(data["meshes"][0]["hull"], np.uint32)
    assert len(cube) == 2 * 12  # edges of a box; its diagonals are none


def test_crossings_are_highlighted():
    poses = [at(0, 0, 0.06), at(0.03, 0, 0.06), at(1, 0, 0.06), at(2, 0, 0)]
    scene = trivet.Scene.from_poses(["a", "b", "apart", "in the floor"], [box()] * 4, poses)
    found = scene.check().crossings
    assert {(one.a, one.b) for one in found} == {("a", "b"), ("in the floor", "floor")}
    wanted = ["a", "b", "in the floor"]
    data = data_of(scene.view(highlight=found).html)
    assert [o["name"] for o in data["objects"] if o["highlight"]] == wanted
    size = dict(size=(96, 54), samples=1)
    drawn = scene.render(highlight=found, **size)
    assert (drawn == scene.render(highlight=wanted, **size)).all()
    assert (drawn != scene.render(**size)).any()
    red = [1, 0, 0, 1]
    assert (scene.render(highlight={("a", "b"): red}, **size) == scene.render(highlight={"a": red, "b": red}, **size)).all()


def test_colors_and_hulls_of_shapes():
    red = box().colored([1, 0, 0, 0.5])
    assert (red.face_colors() == [255, 0, 0, 128]).all() and red.face_colors().shape == (12, 4)
    grey = torus()
    assert (grey.face_colors() == grey.face_colors()[0]).all() and grey.face_colors()[0, 3] == 255
    hull = torus(8, 6).hull_faces()
    assert len(hull) > 10 and hull.max() < 48
    flat = trivet.Shape([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert flat.hull_faces().shape == (0, 3)
    scene = trivet.Scene(floor=False)
    scene.add("flat", flat, pose=at(0, 0, 0))
    assert array(data_of(scene.view().html)["meshes"][0]["hull"], np.uint32).size == 0
    assert data_of(trivet.Scene().view().html)["objects"] == []


def test_scenes_show_themselves_in_notebooks(tmp_path):
    scene = small_scene()
    shown = scene._repr_html_()
    page = html.unescape(re.search(r'<iframe srcdoc="(.*?)" sandbox="allow-scripts"', shown, re.S).group(1))
    assert page == scene.view().html and data_of(page)["objects"][2]["name"] == "plate </script> & \"co\""
    scene.view(height=300).save(tmp_path / "scene.html")
    assert (tmp_path / "scene.html").read_text(encoding="utf-8") == scene.view().html
    assert "height: 300px" in scene.view(height=300)._repr_html_()
    width, height, channels, values = read_png(scene._repr_png_())
    assert (width, height, channels) == (480, 270, 3)
    picture = scene.render(size=(48, 27), samples=1)
    assert np.array(read_png(trivet.encode_png(picture))[3]).reshape(picture.shape).tolist() == picture.tolist()


def test_pages_that_cannot_be():
    scene = small_scene()
    with pytest.raises(trivet.BadInputError, match="faces.*max_faces"):
        scene.view(max_faces=100)
    with pytest.raises(trivet.BadInputError, match="'shadows'.*hulls"):
        scene.view(show=["shadows"])
    with pytest.raises(trivet.NoSuchObject, match="spoon"):
        scene.view(highlight=["spoon"])
    for image in (np.zeros((2, 2)), np.zeros((2, 2, 3)), np.zeros((0, 2, 3), np.uint8), "image"):
        with pytest.raises(trivet.BadInputError, match="uint8"):
            trivet.encode_png(image)


def browse(page, folder, *options):
    """Opens a page in Chromium without graphics hardware; pictures have 800 x 480 pixels."""
    (folder / "page.html").write_text(page, encoding="utf-8")
    command = [CHROMIUM, "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
               "--hide-scrollbars", "--virtual-time-budget=4000", f"--user-data-dir={folder / 'profile'}",
               "--window-size=800,480", *options, "page.html"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300,
                          env={**os.environ, "HOME": str(folder)})


def screenshot(page, folder):
    """The page's pixels as an array."""
    done = browse(page, folder, f"--screenshot={folder / 'page.png'}")
    assert (folder / "page.png").exists(), done.stderr
    width, height, channels, values = read_png((folder / "page.png").read_bytes())
    kept = os.environ.get("TRIVET_PICTURES")
    if kept:
        shutil.copy(folder / "page.png", kept)
    return np.array(values, np.uint8).reshape(height, width, channels)[:, :, :3].astype(int)


@needs_chromium
def test_a_browser_draws_the_scene(tmp_path):
    scene = small_scene()
    plain = screenshot(scene.view().html, tmp_path)
    red = (plain[:, :, 0] > 120) & (plain[:, :, 1] < 90) & (plain[:, :, 2] < 90)
    assert red.sum() > 500  # the plate
    marked = screenshot(scene.view(show=["hulls", "contacts", "supports"]).html, tmp_path)
    green = (marked[:, :, 1] > 120) & (marked[:, :, 0] < 60) & (marked[:, :, 2] < 90)
    blue = (marked[:, :, 2] > 140) & (marked[:, :, 0] < 60) & (marked[:, :, 1] < 90)
    assert green.sum() > 20 and blue.sum() > 50 and (plain != marked).any()


# Clicks at the plate and beside all, drags, turns the wheel, and writes down what came of it.
HANDS = """<script>
canvas.setPointerCapture = () => {};
const told = {home: {...camera, target: [...camera.target]}};
const point = (type, x, y, more = {}) => canvas.dispatchEvent(
  new PointerEvent(type, {clientX: x, clientY: y, pointerId: 1, button: 0, buttons: 1, ...more}));
const drag = (x, y, more) => { point("pointerdown", 400, 400, more); point("pointermove", 400 + x, 400 + y, more); point("pointerup", 400 + x, 400 + y, more); };
draw_now();
const plate = ["left", "top"].map((side) => parseFloat(labels[2].style[side]) / 100);
const at = [plate[0] * innerWidth, plate[1] * innerHeight];
point("pointerdown", ...at); point("pointerup", ...at);
told.clicked = element("told").textContent;
point("pointerdown", 5, innerHeight - 5); point("pointerup", 5, innerHeight - 5);
told.missed = element("told").textContent;
drag(100, 50); told.turned = {...camera};
drag(100, 50, {buttons: 2, button: 2}); told.shifted = {...camera, target: [...camera.target]};
canvas.dispatchEvent(new WheelEvent("wheel", {deltaY: -500})); told.near = camera.distance;
element("home").click(); told.again = camera;
document.title = JSON.stringify(told);
</script>"""


@needs_chromium
def test_the_scene_follows_the_mouse(tmp_path):
    page = small_scene().view().html
    done = browse(page.replace("</body>", HANDS + "</body>"), tmp_path, "--dump-dom")
    told = json.loads(html.unescape(re.search(r"<title>(.*?)</title>", done.stdout, re.S).group(1)))
    assert told["clicked"] == 'plate </script> & "co" \u00b7 stable \u00b7 on table' and told["missed"] == ""
    assert told["turned"]["yaw"] == pytest.approx(told["home"]["yaw"] - 0.8)
    assert told["turned"]["pitch"] == pytest.approx(told["home"]["pitch"] + 0.4)
    assert told["shifted"]["yaw"] == told["turned"]["yaw"] and told["shifted"]["target"] != told["home"]["target"]
    assert told["near"] < 0.6 * told["home"]["distance"] and told["again"] == told["home"]
