"""Random scenes of recipes: in this process the bits of the program's batches; batches with callbacks."""
import json
import subprocess
import tarfile
import threading

import pytest

import trivet
from shapes import box_arrays, table_with_cup
from test_pictures import PROGRAM, needs_program

RECIPE = {"trivet_recipe": 1,
          "objects": [{"name": "slab", "model": "slab.obj", "fixed": True, "position": [0, 0, 0.05]}],
          "groups": [{"name": "brick", "count": [1, 3], "on": "slab", "models": [
              {"model": "brick.obj", "class": "toy", "mass": [0.1, 0.3],
               "material": {"friction": [0.3, 0.6], "density": [500, 900]}}]}]}


@pytest.fixture
def folder(tmp_path):
    for name, sizes in (("slab.obj", (0.3, 0.3, 0.05)), ("brick.obj", (0.03, 0.02, 0.01))):
        vertices, faces = box_arrays(*sizes)
        (tmp_path / name).write_text("".join("v %r %r %r\n" % tuple(v) for v in vertices.tolist())
                                     + "".join("f %d %d %d\n" % tuple(f + 1) for f in faces))
    (tmp_path / "recipe.json").write_text(json.dumps(RECIPE))
    return tmp_path


def rows_of(out):
    found = {}
    for tar in sorted(out.glob("0000/*.tar")):
        with tarfile.open(tar) as file:
            for member in file.getmembers():
                if member.name.endswith(".json") and "manifest" not in member.name:
                    scene = json.load(file.extractfile(member))
                    found[scene["k"]] = scene
    return found


def test_scenes_at_rest_with_masses_of_the_ranges(folder):
    recipe = trivet.Recipe(folder / "recipe.json", seed=7)
    assert recipe.seed == 7 and "seed 7" in repr(recipe)
    masses, frictions = set(), set()
    for made in recipe.scenes(6):
        assert made and made.ok and made.reason == "" and made.scene.check().ok
        bricks = [one for one in made.info["objects"] if one["name"].startswith("brick")]
        assert 1 <= len(bricks) <= 3
        for brick in bricks:
            assert 0.1 <= brick["mass"] <= 0.3 and brick["kilograms"] == pytest.approx(brick["mass"])
            assert 0.3 <= brick["material"]["friction"] <= 0.6 and 500 <= brick["material"]["density"] <= 900
            assert brick["class"] == "toy" and brick["supports"]
            weight = made.scene[brick["name"]].weight
            assert weight == pytest.approx(9.80665 * brick["mass"])
            masses.add(brick["mass"]), frictions.add(brick["material"]["friction"])
    assert len(masses) > 5 and len(frictions) > 5


def test_the_same_bits_again_and_in_threads(folder):
    recipe = trivet.Recipe(RECIPE, seed=3, folder=folder)
    alone = [made.scene.fingerprint for made in recipe.scenes(4)]
    assert [trivet.Recipe(folder / "recipe.json", seed=3).scene(k).scene.fingerprint for k in range(4)] == alone
    assert trivet.Recipe(RECIPE, seed=4, folder=folder).scene(0).scene.fingerprint != alone[0]
    together = {}
    threads = [threading.Thread(target=lambda k=k: together.update({k: recipe.scene(k).scene.fingerprint})) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [together[k] for k in range(4)] == alone
    made = recipe.scene(1)
    brick = next(one for one in made.scene if one.name.startswith("brick"))
    brick.push([1.0, 0.0], 0.01)  # it is a scene like any other
    assert made.scene.check().ok


def test_a_wrong_recipe_is_refused(folder):
    with pytest.raises(trivet.BadInputError, match="/groups/0/models/0/mass"):
        wrong = json.loads(json.dumps(RECIPE))
        wrong["groups"][0]["models"][0]["mass"] = [2, 1]
        trivet.Recipe(wrong, folder=folder)
    with pytest.raises(trivet.BadInputError, match="recipe"):
        trivet.Recipe({"trivet_recipe": float("nan")}, folder=folder)
    with pytest.raises(trivet.BadInputError, match="none.json"):
        trivet.Recipe(folder / "none.json")
    with pytest.raises(TimeoutError):
        trivet.Recipe(RECIPE, folder=folder).scene(0, seconds=1e-9)


@needs_program
def test_a_batch_has_the_scenes_of_this_process(folder):
    recipe = trivet.Recipe(RECIPE, seed=7, folder=folder)
    told = []
    totals = recipe.batch(folder / "out", 8, per_tar=2, jobs=1, progress=lambda *at: told.append(at))
    assert totals["ok"] == 8 and totals["units"] == 4
    assert told[-1] == (4, 4) and told == sorted(told)
    rows = rows_of(folder / "out")
    assert sorted(rows) == list(range(8))
    for k in range(8):
        here, there = recipe.scene(k).info, rows[k]
        assert here == there, k
    again = subprocess.run([PROGRAM, "batch", "recipe.json", "--count", "8", "--seed", "7", "--per-tar", "2", "--out", "there",
                            "--quiet"], cwd=folder, timeout=300)
    assert again.returncode == 0
    for tar in (folder / "out").glob("0000/*.tar"):
        assert tar.read_bytes() == (folder / "there" / "0000" / tar.name).read_bytes()


@needs_program
def test_pictures_and_exports_of_a_batch(folder):
    recipe = trivet.Recipe(RECIPE, seed=7, folder=folder)
    recipe.batch(folder / "scenes", 2, per_tar=2, jobs=1)
    views = {"width": 40, "height": 30, "samples": 1, "dome": {"count": 1}, "look": {"lamps": {"kind": "bulb"}}}
    assert trivet.batch_pictures(folder / "scenes", folder / "set", form="bop", views=views, jobs=1)["ok"] == 2
    assert (folder / "set" / "train_pbr" / "000001" / "rgb" / "000000.png").exists()
    told = []
    totals = trivet.batch_export(folder / "scenes", folder / "files", ["mjcf", "usd"], jobs=1, progress=lambda *at: told.append(at))
    assert totals["ok"] == 2 and told[-1] == (1, 1)
    assert len(list((folder / "files" / "0000").rglob("*.xml"))) == 2
    with pytest.raises(trivet.BadInputError, match="cad"):
        trivet.batch_export(folder / "scenes", folder / "more", ["cad"])
    with pytest.raises(trivet.BadInputError, match='"pictures", "bop" or "coco"'):
        trivet.batch_pictures(folder / "scenes", folder / "more", form="voc")


@needs_program
def test_what_progress_raises_stops_the_batch(folder):
    def stop(done, total):
        if done:
            raise ZeroDivisionError(done)

    recipe = trivet.Recipe(RECIPE, folder=folder)
    with pytest.raises(ZeroDivisionError):
        recipe.batch(folder / "out", 5000, per_tar=1, jobs=1, progress=stop)
    assert 0 < len(list((folder / "out").glob("0000/*.tar"))) < 5000


def test_export_simulates_and_reports(tmp_path):
    scene = table_with_cup()
    done = scene.export(tmp_path / "a.xml", report=tmp_path / "a.json")
    assert done.simulated is None
    assert json.loads((tmp_path / "a.json").read_text())["objects"]
    try:
        done = scene.export(tmp_path / "a.xml", simulate=0.2, report=tmp_path / "a.json")
    except trivet.BadInputError as error:
        pytest.skip(str(error))
    assert done.simulated and "MuJoCo" in done.simulated.simulator
    moved, turned = done.simulated.objects["cup"]
    assert moved < 0.01 and turned < 10
    assert "simulated" in json.loads((tmp_path / "a.json").read_text())
    with pytest.raises(trivet.BadInputError, match="simulate"):
        scene.export(tmp_path / "a.xml", simulate=-1)
    with pytest.raises(trivet.BadInputError):
        scene.export(tmp_path / "a.urdf", simulate=1)


def test_a_scene_is_the_same_after_it_was_changed(folder):
    """As environments of learning reset to a seed."""
    recipe = trivet.Recipe(folder / "recipe.json")
    brick = recipe.scene(11).scene["brick_0"]
    at = brick.position.copy()
    brick.try_push([1.0, 0.0], 0.02)
    assert (recipe.scene(11).scene["brick_0"].position == at).all()
