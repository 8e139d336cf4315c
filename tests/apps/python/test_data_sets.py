"""Data sets of labelled views: the files of the program, byte for byte."""
import os
import signal
import threading

import pytest

import trivet
from shapes import table_with_cup
from test_pictures import PROGRAM, needs_program, program, scene_file  # noqa: F401

SIZE = (80, 60)


def files_in(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@needs_program
@pytest.mark.parametrize("form, count", [("coco", 1 + 3), ("bop", 2 * 3 + 2 * 3 * 2 + 3 + 1 + 2 + 1)])
def test_the_files_are_those_of_the_program(scene_file, tmp_path, form, count):  # noqa: F811
    program("render", scene_file, "--" + form, tmp_path / "there", "--dome", 3, "--dome-seed", 5, "--width", SIZE[0],
            "--height", SIZE[1], "--samples", 2, folder=tmp_path)
    told = []
    scene = trivet.Scene.load(scene_file)
    scene.write_data_set(tmp_path / "here", scene.dome(3, seed=5, size=SIZE), form=form, samples=2,
                         progress=lambda *at: told.append(at))
    here, there = files_in(tmp_path / "here"), files_in(tmp_path / "there")
    assert sorted(here) == sorted(there) and len(here) == count
    assert [name for name in here if here[name] != there[name]] == []
    assert told == [(1, 3), (2, 3), (3, 3)]


def test_classes_are_those_that_are_given(tmp_path):
    scene = table_with_cup()
    scene.write_data_set(tmp_path, scene.dome(1, size=SIZE), classes={"cup": "vessel"}, samples=1)
    assert b'"vessel"' in (tmp_path / "annotations.json").read_bytes()


def test_what_stops_it_leaves_nothing(tmp_path):
    scene = table_with_cup()
    views = scene.dome(500, size=(320, 240))

    def stop(done, total):
        raise ZeroDivisionError(done)

    with pytest.raises(ZeroDivisionError, match="1"):
        scene.write_data_set(tmp_path / "new" / "set", views, samples=1, progress=stop)
    assert list(tmp_path.iterdir()) == []

    def stop_at_the_end(done, total):
        if done == total:
            raise ZeroDivisionError(done)

    for form in ("coco", "bop"):
        with pytest.raises(ZeroDivisionError, match="2"):
            scene.write_data_set(tmp_path / "set", views[:2], form=form, samples=1, progress=stop_at_the_end)
    assert list(tmp_path.iterdir()) == []
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        scene.write_data_set(tmp_path, views, samples=16)
    timer.join()
    assert list(tmp_path.iterdir()) == []


def test_bad_input(tmp_path):
    scene = table_with_cup()
    views = scene.dome(1, size=(8, 8))
    for options, says in ((dict(cameras=[]), ["cameras", "one camera"]), (dict(cameras=[None]), ["cameras", "dome"]),
                          (dict(cameras=["front"]), ["camera", "front"]), (dict(form="voc"), ["form", "voc", "coco"]),
                          (dict(depth_unit=0), ["depth_unit", "1e-9"]), (dict(samples=0), ["samples", "4096"]),
                          (dict(classes={"cup": ""}), ["classes"])):
        with pytest.raises(trivet.BadInputError) as caught:
            scene.write_data_set(tmp_path / "set", **{"cameras": views, **options})
        for part in says:
            assert part in str(caught.value), str(caught.value)
    with pytest.raises(trivet.NoSuchObject, match="spoon"):
        scene.write_data_set(tmp_path / "set", views, classes={"spoon": "x"})
    (tmp_path / "file").write_text("")
    with pytest.raises(trivet.EnvironmentFailure, match="file"):
        scene.write_data_set(tmp_path / "file" / "set", views, samples=1)
