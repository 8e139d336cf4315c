"""The add-on in a real window, driven by simulated events: panel, pie menu, ghost, progress, Ctrl+Z; a picture of each step.

blender --factory-startup --enable-event-simulate -p 0 0 1280 800 -P test_window.py -- ZIP MODULE_FOLDER TRIVET PICTURES
"""
import os
import sys
import time
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
from mathutils import Vector

import scenes
import support

ZIP, MODULE, PROGRAM, PICTURES = support.arguments()[:4]
bpy.context.preferences.view.show_splash = False
support.enable(ZIP, MODULE, PROGRAM)
import trivet
from trivet_addon import memory

PATIENCE = 90.0  # seconds for a state; redrawing in software under load takes seconds


def view():
    """Window, area, and region of the 3D view."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    return window, area, next(region for region in area.regions if region.type == "WINDOW")


def send(kind, value="PRESS", at=None, **modifiers):
    window, area, _ = view()
    x, y = at or middle()
    window.event_simulate(type=kind, value=value, x=int(x), y=int(y), **modifiers)


def middle():
    _, area, _ = view()
    return area.x + area.width // 2 - 100, area.y + area.height // 2


def point(at):
    send("MOUSEMOVE", "NOTHING", at)


def press(kind, at=None, **modifiers):
    send(kind, "PRESS", at, **modifiers)
    send(kind, "RELEASE", at, **modifiers)


def click(at):
    point(at)
    press("LEFTMOUSE", at)


def screen(location):
    """Window coordinates of a point in the world."""
    from bpy_extras.view3d_utils import location_3d_to_region_2d

    _, area, region = view()
    at = location_3d_to_region_2d(region, area.spaces.active.region_3d, location)
    return region.x + at.x, region.y + at.y


def picture(name):
    window, _, _ = view()
    path = os.path.join(PICTURES, name + ".png")
    with bpy.context.temp_override(window=window):
        bpy.ops.screen.screenshot(filepath=path)
    assert os.path.getsize(path) > 10_000, path


def override():
    window, area, region = view()
    return bpy.context.temp_override(window=window, area=area, region=region)


def until(what, condition):
    """A step that waits for a state."""
    start = time.time()
    while not condition():
        if time.time() - start > PATIENCE:
            raise AssertionError(f"not within {PATIENCE} s: {what}")
        yield
    print(f"{what}: {time.time() - start:.1f} s", flush=True)


def frames(number=3):
    for _ in range(number):
        yield


def steps():
    _, area, _ = view()
    space = area.spaces.active
    space.show_region_ui = True
    space.shading.type, space.shading.color_type = "SOLID", "RANDOM"
    space.region_3d.view_location, space.region_3d.view_distance = (0, 0.1, 0.9), 2.4
    space.overlay.show_relationship_lines = False
    ten = scenes.awkward_ten()
    for one in bpy.data.objects:
        if one.type == "EMPTY":
            one.empty_display_size = 0.05
    yield from frames()
    yield from opens_the_panel(area)
    yield from puts_by_the_pie_menu_and_undoes(ten)
    yield from puts_one_here_with_a_ghost()
    yield from goes_on_with_copies()
    yield from goes_on_with_the_next()
    yield from puts_two_as_one()
    yield from paints_strokes()
    yield from pushes_by_mouse()
    yield from shows_where_things_cross()
    yield from shows_preferences()
    yield from stops_long_work()


def opens_the_panel(area):
    point(middle())
    yield from frames()
    click((area.x + area.width - 12, area.y + area.height - 216))  # its tab
    yield from frames(5)
    picture("panel")


def puts_by_the_pie_menu_and_undoes(ten):
    with override():
        bpy.ops.ed.undo_push(message="built")
    before = support.matrices()
    point(middle())
    yield from frames()
    send("D", "PRESS", shift=True, alt=True)
    yield from frames(5)
    picture("pie")
    x, y = middle()
    for down in (20, 60, 100):
        point((x, y - down))
        yield from frames()
    send("D", "RELEASE", (x, y - 100))
    yield from until("put by the pie menu", lambda: memory.last.title == "Put" and not memory.running)
    assert len(memory.last.done) == 9, memory.last
    yield from frames(5)
    picture("put")
    after = support.matrices()
    assert after != before
    press("Z", ctrl=True)
    yield from until("undone by Ctrl+Z", lambda: support.matrices() == before)
    press("Z", ctrl=True, shift=True)
    yield from until("done again by Ctrl+Shift+Z", lambda: support.matrices() == after)


def puts_one_here_with_a_ghost():
    monkey = bpy.data.objects["monkey (subdivided)"]
    support.select([monkey])
    before = support.matrices()
    window, area, _ = view()
    sidebar = next(region for region in area.regions if region.type == "UI")
    with bpy.context.temp_override(window=window, area=area, region=sidebar):
        bpy.ops.trivet.put_here("INVOKE_DEFAULT", True)  # as its button does
    assert memory.running == "TRIVET_OT_put_here", memory.running
    point(screen((-0.1, -0.42, 0.73)))
    yield from until("ghost", lambda: memory.ghost[0] and "rest" in memory.ghost[1])
    point(screen((-0.12, -0.4, 0.73)))
    yield from frames(6)
    send("WHEELUPMOUSE", at=screen((-0.12, -0.4, 0.73)))
    yield from frames(6)
    assert support.matrices() == before, "the ghost moves nothing"
    picture("ghost")
    press("ESC")
    yield from until("left by Esc", lambda: not memory.running)
    assert support.matrices() == before
    with override():
        bpy.ops.trivet.put_here("INVOKE_DEFAULT", True)
    point(screen((-0.12, -0.4, 0.73)))
    yield from until("ghost again", lambda: memory.ghost[0] and "rest" in memory.ghost[1])
    press("LEFTMOUSE", screen((-0.12, -0.4, 0.73)))
    yield from until("put by a click", lambda: memory.last.title == "Put Here" and not memory.running)
    assert memory.last.done == [monkey.name], memory.last
    assert (monkey.matrix_world.translation.xy - Vector((-0.12, -0.4))).length < 0.2
    yield from frames(5)
    picture("put_here")
    clicked = support.matrices()
    made = bpy.context.window_manager.operators[-1]
    assert made.bl_idname == "TRIVET_OT_put_here", made.bl_idname
    at, turn = tuple(made.point), made.turn
    assert (Vector(at) - Vector((-0.12, -0.4, 0.73))).length < 0.02, at
    press("Z", ctrl=True)
    yield from until("undone", lambda: support.matrices() == before)
    with override():
        bpy.ops.trivet.put_here("EXEC_DEFAULT", True, point=at, turn=turn)
    assert support.matrices() == clicked, "the click does what the redo panel does"


def here(objects):
    """Put Here of these by mouse, as its button does."""
    support.select(objects)
    with override():
        bpy.ops.trivet.put_here("INVOKE_DEFAULT", True)


def put_here_at(at, name):
    """A click, where its ghost rests."""
    point(screen(at))
    yield from until("ghost of " + name, lambda: memory.ghost[0] and "rest" in memory.ghost[1])
    memory.last.done = []
    press("LEFTMOUSE", screen(at))
    yield from until("put " + name, lambda: memory.last.done)


def goes_on_with_copies():
    """C makes copies until Esc; each is a step for Undo, and the last one goes."""
    mug = bpy.data.objects["mug"]
    before, names = support.matrices(), set(bpy.data.objects.keys())
    here([mug])
    press("C")
    press("L")
    for x in (0.1, 0.25):
        yield from until("pointing", lambda: memory.running == "TRIVET_OT_put_here")
        yield from put_here_at((x, -0.42, 0.73), "a mug")
    yield from until("the next copy", lambda: memory.running == "TRIVET_OT_put_here")
    picture("copies")
    press("ESC")
    yield from until("left", lambda: not memory.running)
    new = set(bpy.data.objects.keys()) - names
    assert new == {"mug.001", "mug handle.001"}, new
    for _ in range(2):
        press("Z", ctrl=True)
        yield from frames(3)
    yield from until("undone", lambda: support.matrices() == before)


def goes_on_with_the_next():
    """All that is selected, one click each."""
    mug, monkey = bpy.data.objects["mug"], bpy.data.objects["monkey (subdivided)"]
    here([mug, monkey])
    yield from put_here_at((-0.2, -0.42, 0.73), "the mug")
    yield from until("the monkey", lambda: memory.running == "TRIVET_OT_put_here")
    assert bpy.context.view_layer.objects.active == monkey
    yield from put_here_at((0.1, -0.42, 0.73), "the monkey")
    yield from frames(5)
    assert not memory.running, memory.running


def puts_two_as_one():
    """By the panel's box; one click for both."""
    mug, monkey = bpy.data.objects["mug"], bpy.data.objects["monkey (subdivided)"]
    before = support.matrices()
    apart = monkey.matrix_world.inverted() @ mug.matrix_world
    bpy.context.scene.trivet.as_one = True
    here([monkey, mug])
    yield from put_here_at((-0.1, -0.42, 0.73), "both")
    yield from frames(5)
    assert memory.last.done == [monkey.name] and not memory.running, memory.last
    assert ((monkey.matrix_world.inverted() @ mug.matrix_world).translation - apart.translation).length < 1e-5
    picture("as_one")
    bpy.context.scene.trivet.as_one = False
    press("Z", ctrl=True)
    yield from until("undone", lambda: support.matrices() == before)


def paints_strokes():
    """Each drag is a step for Undo, until Esc."""
    before, names = support.matrices(), set(bpy.data.objects.keys())
    support.select([bpy.data.objects["mug"]])
    with override():
        bpy.ops.trivet.paint("INVOKE_DEFAULT", True, spacing=0.12)
    assert memory.running == "TRIVET_OT_paint", memory.running
    point(screen((-0.2, -0.42, 0.73)))
    yield from frames()
    send("LEFTMOUSE", "PRESS", screen((-0.2, -0.42, 0.73)))
    for k in range(1, 9):
        point(screen((-0.2 + 0.05 * k, -0.42, 0.73)))
        yield from frames(1)
    yield from until("ghosts of the stroke", lambda: len(memory.ghost[0]) >= 3)
    yield from frames()
    number = len(memory.ghost[0])
    assert set(bpy.data.objects.keys()) == names, "ghosts are no objects"
    picture("paint")
    memory.last.done = []
    send("LEFTMOUSE", "RELEASE", screen((0.2, -0.42, 0.73)))
    yield from until("painted", lambda: memory.last.done)
    yield from until("the next stroke", lambda: memory.running == "TRIVET_OT_paint")
    assert len(memory.last.done) == number, "as the ghosts"
    assert len(set(bpy.data.objects.keys()) - names) == 2 * number, "mugs, each with its handle"
    press("ESC")
    yield from until("ended", lambda: not memory.running)
    picture("painted")
    press("Z", ctrl=True)
    yield from until("undone in one step", lambda: support.matrices() == before)


def pushes_by_mouse():
    mug = bpy.data.objects["mug"]
    support.select([mug])
    before = mug.matrix_world.copy()
    start = before.translation
    point(screen(start))
    yield from frames()
    with override():
        bpy.ops.trivet.push("INVOKE_DEFAULT", True)
    assert memory.running == "TRIVET_OT_push", memory.running
    point(screen(start))
    yield from frames()
    for k in range(1, 6):
        point(screen(start + Vector((0.04 * k, 0.03 * k, 0))))
        yield from frames(1)
    yield from until("ghost of the push", lambda: "mug" in memory.ghost[0])
    assert mug.matrix_world == before
    picture("push")
    press("LEFTMOUSE", screen(start + Vector((0.2, 0.15, 0))))
    yield from until("pushed by a click", lambda: memory.last.title == "Push" and not memory.running)
    assert "mug" in memory.last.done, memory.last
    assert 0.02 < (mug.matrix_world.translation - start).length < 0.4


def shows_where_things_cross():
    monkey, bowl = bpy.data.objects["monkey (subdivided)"], bpy.data.objects["bowl"]
    monkey.location = bowl.location + Vector((0.15, -0.1, 0))
    monkey.modifiers["smooth"].render_levels = 3  # a note in the panel
    bpy.context.view_layer.update()
    support.select([monkey])
    with override():
        bpy.ops.trivet.check("EXEC_DEFAULT", True)
    yield from frames(5)
    assert memory.last.crossings and "renders have other levels" in " ".join(memory.last.notes), memory.last
    picture("check")


def shows_preferences():
    """As it is, and without module and program."""
    chosen = bpy.context.preferences.addons[support.ADDON].preferences
    _, area, _ = view()
    bpy.context.preferences.active_section = "ADDONS"
    bpy.context.window_manager.addon_search = "Trivet"
    bpy.context.window_manager.addon_support = {"OFFICIAL", "COMMUNITY", "TESTING"}
    area.type = "PREFERENCES"
    with bpy.context.temp_override(area=area):
        bpy.ops.preferences.addon_expand(module=support.ADDON)
    chosen.backend, chosen.program = "PROGRAM", "/nowhere/trivet"
    area.tag_redraw()
    yield from frames(5)
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        bpy.ops.screen.screenshot(filepath=os.path.join(PICTURES, "preferences_missing.png"))
    chosen.backend, chosen.program = "AUTO", PROGRAM
    area.tag_redraw()
    yield from frames(5)
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        bpy.ops.screen.screenshot(filepath=os.path.join(PICTURES, "preferences.png"))
    area.type = "VIEW_3D"
    yield from frames(3)


def stops_long_work():
    """Many fine rings, one on another."""
    support.clear()
    rings = []
    for k in range(60):
        bpy.ops.mesh.primitive_torus_add(location=(0, 0, 0.5 + 0.6 * k), rotation=(0.3, 0.1 * k, 0), major_segments=96, minor_segments=48)
        rings.append(bpy.context.object)
    support.select(rings)
    before = support.matrices()
    with override():
        bpy.ops.trivet.put("INVOKE_DEFAULT", True)
    assert memory.running == "TRIVET_OT_put", memory.running
    yield from frames(4)
    picture("progress")
    assert memory.running, "the work was to be long"
    press("ESC")
    start = time.time()
    yield from until("stopped by Esc", lambda: not memory.running)
    assert support.matrices() == before
    print(f"stopped within {time.time() - start:.2f} s")


def finish(passed):
    print("PASSED" if passed else "FAILED", flush=True)
    if not passed:
        picture("failed")
    sys.stdout.flush()
    os._exit(0 if passed else 1)  # Blender asks about unsaved work otherwise


def run():
    work = steps()

    def tick():
        try:
            next(work)
            return 0.1
        except StopIteration:
            passed = True
        except Exception:
            passed = False
            traceback.print_exc()
        finish(passed)

    bpy.app.timers.register(tick, first_interval=1.0, persistent=True)


run()
