"""Drags and transactions in wrong threads and order, values without end, copies: exceptions, and scenes that stay sound.

What could crash runs in a process of its own.
"""
import copy
import pickle
import threading

import numpy as np
import pytest

import trivet
from shapes import box, box_arrays, table_with_cup
from test_threads import run_script


def run_soundly(script):
    """@return what the script printed; it must end well."""
    done = run_script("""
        import faulthandler, threading, time, trivet
        faulthandler.enable()
        from shapes import box, table_with_cup
        scene = table_with_cup()
        cup = scene["cup"]
        told = set()
        def tell(work):
            try:
                work()
            except Exception as error:
                told.add(type(error).__name__)
        def in_thread(work):
            thread = threading.Thread(target=tell, args=(work,))
            thread.start()
            return thread
    """ + script)
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


def test_four_threads_follow_one_drag():
    assert run_soundly("""
        before = cup.position.copy()
        with scene.drag(cup) as hand:
            def work(k):
                for i in range(100):
                    tell(lambda: hand.follow([0.1 + 0.01 * (i % 7), 0.1 + 0.01 * k]))
            threads = [in_thread(lambda k=k: work(k)) for k in range(4)]
            for thread in threads:
                thread.join()
            print(*told)
            hand.follow([0.2, 0.1])
        print(hand.result.end, scene.check().ok, (cup.position != before).any())
    """) == ["SceneBusy", "reached", "True", "True"]


def test_a_drag_is_cancelled_only_by_its_thread():
    assert run_soundly("""
        with scene.drag(cup) as hand:
            def work():
                for _ in range(200):
                    tell(hand.cancel)
                    tell(hand.poses)
                    tell(lambda: hand.__exit__(None, None, None))
            thread = in_thread(work)
            while thread.is_alive():
                hand.follow([0.2, 0.1])
                hand.follow([0.1, 0.1])
            thread.join()
            assert hand.follow([0.2, 0.2]).end == "reached"
            hand.cancel()
        print(*told, scene.check().ok, cup.position.round(3).tolist()[:2])
    """) == ["SceneBusy", "True", "[0.1,", "0.1]"]


@pytest.mark.parametrize("fails", [True, False])
def test_a_transaction_is_ended_only_by_its_thread(fails):
    script = """
        before = scene.fingerprint
        for _ in range(10):
            open = scene.transaction()
            open.__enter__()
            def work():
                time.sleep(0.002)
                open.__exit__(*((ValueError, ValueError("x"), None) if FAILS else (None, None, None)))
            thread = in_thread(work)
            while thread.is_alive():
                cup.try_put([0.1, 0.2, 1.0])
            thread.join()
            open.__exit__(ValueError, ValueError("x"), None)
            assert scene.fingerprint == before
        print(*told, scene.check().ok, len(scene.steps))
    """
    steps = str(len(table_with_cup().steps))
    assert run_soundly(script.replace("FAILS", str(fails))) == ["SceneBusy", "True", steps]


def test_a_lost_transaction_is_taken_back():
    """Also by another thread in the middle of an operation of its own: when that ends."""
    scene = table_with_cup()
    before, steps = scene.fingerprint, len(scene.steps)
    lost = scene.transaction()
    lost.__enter__()
    scene["cup"].put([0.2, 0.2, 1.0])
    del lost
    assert scene.fingerprint == before and scene.undo() and len(scene.steps) < steps
    assert run_soundly("""
        before = scene.fingerprint
        kept = [scene.transaction()]
        kept[0].__enter__()
        def work():
            time.sleep(0.002)
            kept.clear()
        thread = in_thread(work)
        while thread.is_alive():
            cup.try_put([0.1, 0.2, 1.0])
        thread.join()
        other = in_thread(lambda: scene.undo())
        other.join(20)
        print(other.is_alive(), scene.check().ok, *told)
    """) == ["False", "True"]


def test_transactions_end_in_order():
    scene = table_with_cup()
    cup, before = scene["cup"], scene.fingerprint
    outer, inner = scene.transaction(), scene.transaction()
    outer.__enter__()
    cup.put([0.2, 0.2, 1.0])
    middle = scene.fingerprint
    inner.__enter__()
    cup.put([0.3, 0.3, 1.0])
    with pytest.raises(trivet.SceneBusy, match="within"):
        outer.__exit__(None, None, None)
    inner.__exit__(ValueError, ValueError("x"), None)
    assert scene.fingerprint == middle
    outer.__exit__(None, None, None)
    assert scene.undo() and scene.fingerprint == before
    assert scene.redo() and scene.fingerprint == middle
    with pytest.raises(trivet.SceneBusy, match="not open"):
        outer.__exit__(None, None, None)


def test_objects_pickle_after_deletions():
    scene = trivet.Scene()
    for name in ("a", "b", "c"):
        scene.add(name, box()).put([0.5 * len(scene), 0, 1])
    scene["a"].remove()
    late = scene.add("late", box())
    late.put([3, 0, 1])
    for one in (scene["b"], scene["c"], late):
        for again in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one), copy.copy(one)):
            assert again.name == one.name and (again.position == one.position).all()
    both = pickle.loads(pickle.dumps({"scene": scene, "object": late}))
    assert both["object"].scene is both["scene"] and both["object"] in both["scene"]
    gone = scene["b"]
    gone.remove()
    scene.add("b", box())
    for again in (pickle.loads(pickle.dumps(gone)), copy.copy(gone)):
        with pytest.raises(trivet.NoSuchObject, match="b"):
            again.state


ENDLESS = {
    "list in itself": "x = []; x.append(x)",
    "dict in itself": "x = {}; x['friction'] = x",
    "deep list": "x = []\nfor _ in range(200000): x = [x]",
}
USES = {
    "module": "scene._scene.perform_all([{'op': 'put', 'object': 'cup', 'position': x}], 0.0)",
    "perform": "scene.perform([{'op': 'put', 'object': 'cup', 'position': x}])",
    "arrange": "scene.arrange({'relations': x})",
    "material": "scene.add('b', box(), material={'friction': x})",
    "settle_left": "scene.perform([{'op': 'put', 'object': 'cup', 'position': [0, 0, 1], 'settle_left': x}])",
}


@pytest.mark.parametrize("use", USES)
@pytest.mark.parametrize("value", ENDLESS)
def test_values_without_end(value, use):
    text = ENDLESS[value] + "\ntry:\n    " + USES[use] + "\nexcept trivet.BadInputError as error:\n    print('64' in str(error))"
    assert run_soundly("\n" + "\n".join(" " * 8 + line for line in text.split("\n"))) == ["True"]


def test_values_of_64_levels_are_read():
    scene = table_with_cup()
    for depth, says in ((62, "position"), (63, "position"), (64, "up to 64")):
        value = 1.0
        for _ in range(depth):
            value = [value]
        with pytest.raises(trivet.BadInputError, match=says) as caught:
            scene.perform([{"op": "put", "object": "cup", "position": value}])
        assert ("up to 64" in str(caught.value)) == (depth == 64)


def test_classes_of_the_module_make_no_empty_values():
    kinds = [name for name, kind in vars(trivet._trivet).items() if isinstance(kind, type)]
    assert {"Scene", "Shape", "Drag", "Film", "Snapshot", "Transaction", "Camera", "SettleOptions"} <= set(kinds)
    for name in kinds:
        assert run_soundly(f"""
        kind = trivet._trivet.{name}
        def use(make):
            one = make()
            for key in dir(one):
                if not key.startswith("__"):
                    value = getattr(one, key)
                    if callable(value):
                        tell(value)
            print("used")
        base = kind.__mro__[1]
        class Derived(kind): pass
        for make in (lambda: kind.__new__(kind), kind, Derived, lambda: base.__new__(kind), lambda: object.__new__(kind)):
            tell(lambda: use(make))
        print(*told)
        """) == ["TypeError"], name


@pytest.mark.parametrize("size", [1.01e30, 1e160, 1e300, -1e300])
def test_shapes_whose_volume_would_overflow(size):
    vertices, faces = box_arrays(1, 1, 1)
    with pytest.raises(trivet.BadInputError, match=r"vertices: row \d.*e\+.*accepted.*1e30"):
        trivet.Shape(vertices * size, faces)


def test_the_largest_shapes_have_finite_masses():
    vertices, faces = box_arrays(1e30, 1e30, 1e30)
    shape = trivet.Shape(vertices, faces)
    assert shape.volume == pytest.approx(8e90) and shape.area == pytest.approx(24e60)
    assert np.abs(shape.center_mass).max() < 1e16


def to_module(scene, **values):
    """Past the checks of the Python half."""
    scene._scene.perform_all([{"op": "put", "object": "cup", **values}], 0.0)


BAD_VALUES = [
    (lambda s: s.perform([{"op": "put", "object": "cup", "on": {1, 2}}]), ["on", "{1, 2}"]),
    (lambda s: s.perform([{"op": "put", "object": "cup", "position": np.array([1j, 0, 1])}]), ["position", "1j"]),
    (lambda s: s.perform([{"op": "put", "object": "cup", "on": table_with_cup()["table"]}]), ["/on", "another scene"]),
    (lambda s: s.perform([{"op": "put", "object": 5, "position": [0, 0, 1]}]), ["object", "5"]),
    (lambda s: trivet.Scene.from_poses(["\ud800"], [box()], [np.eye(4)]), ["name", r"\ud800"]),
    (lambda s: to_module(s, on={1, 2}), ['put "cup": /on', "set", "{1, 2}"]),
    (lambda s: to_module(s, on="\ud800"), ["/on", r"\ud800", "UTF-8"]),
    (lambda s: to_module(s, object="\ud800"), ["object", r"\ud800", "UTF-8"]),
    (lambda s: to_module(s, at={1: 2}), ["/at: key", "1", "str"]),
    (lambda s: to_module(s, position=[float("nan"), 0, 1]), ["position", "nan", "finite"]),
    (lambda s: to_module(s, seed=2 ** 70), ["seed", str(2 ** 70), "2^63"]),
]


@pytest.mark.parametrize("number", range(len(BAD_VALUES)))
def test_values_that_are_not_accepted(number):
    call, says = BAD_VALUES[number]
    scene = table_with_cup()
    before = scene.fingerprint
    with pytest.raises(trivet.BadInputError) as caught:
        call(scene)
    for part in [*says, "accepted"]:
        assert part in str(caught.value), str(caught.value)
    assert "Python" not in str(caught.value) and scene.fingerprint == before


def test_names_that_are_no_text_are_of_no_object():
    scene = table_with_cup()
    assert "\ud800" not in scene
    with pytest.raises(trivet.NoSuchObject):
        scene["\ud800"]


def test_values_of_numpy_and_objects_in_operations():
    plain, numpy = table_with_cup(), table_with_cup()
    plain.perform([{"op": "put", "object": "cup", "on": "table", "at": [0.25, 0.125], "keep": 0.5, "seed": 3,
                    "settle_left": True},
                   {"op": "push", "object": "cup", "direction": [1, 0], "distance": 0.0625, "slide": False}])
    numpy.perform([{"op": "put", "object": numpy["cup"], "on": numpy["table"], "at": np.array([0.25, 0.125], np.float32),
                    "keep": np.float32(0.5), "seed": np.int64(3), "settle_left": np.bool_(True)},
                   {"op": "push", "object": numpy["cup"], "direction": np.array([1, 0], np.uint8),
                    "distance": np.longdouble(0.0625), "slide": np.bool_(False)}])
    assert numpy.fingerprint == plain.fingerprint and numpy.steps == plain.steps


def test_a_drag_may_outlive_its_thread():
    """The scene is free again when nothing refers to it."""
    scene = table_with_cup()
    kept = []
    thread = threading.Thread(target=lambda: kept.append(scene.drag("cup").__enter__()))
    thread.start()
    thread.join()
    with pytest.raises(trivet.SceneBusy, match="thread"):
        kept[0].follow([0.2, 0.2])
    kept.clear()
    assert scene["cup"].put([0.2, 0.2, 1.0])
