"""Sets of layouts for campaign.py: each a generator of (name, layout, how to put again what was refused)."""
import math
import os
import random
import sys
import types


def read_models(shared, out):
    sys.path.insert(0, os.path.join(shared, "tools", "referee"))
    sys.dont_write_bytecode = True
    import layouts
    args = types.SimpleNamespace(
        models=os.path.join(shared, "data", "models"),
        csv=os.path.join(shared, "data", "models.csv"), out=out, absolute=True, kinds=None,
        min_size=0, max_size=float("inf"), max_triangles=sys.maxsize, drop=0.1)
    return layouts, layouts.read_models(args), args


def floor_layouts(layouts, models):
    for i, model in enumerate(models):
        for k in range(5):
            rng = random.Random(f"floor {i} {k}")
            layout = layouts.Layout()
            layout.put("object", model, layouts.random_rotation(rng), 0, 0, layouts.CLEAR + 0.1)
            yield f"floor_{i:02d}_{k}", layout.json, None


def pair_layouts(layouts, models):
    supports = random.Random(7).sample(models, 10)
    for i, model in enumerate(models):
        for k in range(5):
            rng = random.Random(f"pair {i} {k}")
            support = rng.choice([s for s in supports if s is not model])
            lower, upper = support.box()
            half = [(b - a) / 2 for a, b in zip(lower, upper)]
            layout = layouts.Layout()
            layout.add("support", support, fixed=True,
                       position=support.position(layouts.IDENTITY, 0, 0, layouts.CLEAR),
                       rotation=list(layouts.IDENTITY))
            x, y = (0.7 * h * rng.uniform(-1, 1) for h in half[:2])
            layout.put("load", model, layouts.random_rotation(rng), x, y,
                       2 * half[2] + 2 * layouts.CLEAR + 0.1)
            yield f"pair_{i:02d}_{k}", layout.json, None


def pile_layouts(layouts, models, args, heaps):
    count, args.objects = map(int, heaps.split("x"))
    args.radius = None
    for k in range(count):
        layout = layouts.make_pile(models, random.Random(f"pile {k}"), args)
        yield f"pile_{k}", layout.json, turned_about_centre(f"again {k}")


def write_bin(layouts, out):
    """An open box with walls of 1 cm, as a model."""
    outer, inner, height = (0.3, 0.2), (0.29, 0.19), 0.25
    rings = [(outer, 0), (outer, height), (inner, height), (inner, 0.01)]
    path = os.path.join(out, "bin.obj")
    with open(path, "w") as file:
        for (x, y), z in rings:
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                file.write(f"v {a * x} {b * y} {z}\n")
        for ring in range(3):
            for k in range(4):
                a, b = 4 * ring + k + 1, 4 * ring + (k + 1) % 4 + 1
                file.write(f"f {a} {b} {b + 4}\nf {a} {b + 4} {a + 4}\n")
        file.write("f 3 2 1\nf 4 3 1\nf 13 14 15\nf 13 15 16\n")
    return layouts.Model({"file": "bin.obj", "kind": "bin", "up_axis": "z", "scale_to_m": 1,
                          "size_m": "0.6 0.4 0.25", "bbox_min": "-0.3 -0.2 0",
                          "bbox_max": "0.3 0.2 0.25"}, path)


def place_in_bin(rng):
    return rng.uniform(-0.15, 0.15), rng.uniform(-0.08, 0.08)


def bin_layouts(layouts, models, out, bins):
    count, num_objects = map(int, bins.split("x"))
    box, small = write_bin(layouts, out), [m for m in models if m.size <= 0.3]
    for k in range(count):
        rng = random.Random(f"bin {k}")
        layout, top, centres = layouts.Layout(), 0.35, {}
        layout.add("bin", box, fixed=True, position=[0, 0, layouts.CLEAR],
                   rotation=list(layouts.IDENTITY))
        for i in range(num_objects):
            model = rng.choice(small)
            name, rotation = f"object_{i + 1:02d}", layouts.random_rotation(rng)
            centres[name] = place_in_bin(rng)
            layout.put(name, model, rotation, *centres[name], top)
            top += model.diagonal()
        yield f"bin_{k:02d}", layout.json, shifted_in_bin(f"again {k}", centres)


def prism(layouts, out, name, polygon, depth):
    """A convex polygon in xz, counter-clockwise, drawn out along y, as a model."""
    n, path = len(polygon), os.path.join(out, name + ".obj")
    rings = [list(range(1, n + 1)), list(range(2 * n, n, -1))]
    rings += [[i + 1, n + i + 1, n + (i + 1) % n + 1, (i + 1) % n + 1] for i in range(n)]
    with open(path, "w") as file:
        for y in (-depth / 2, depth / 2):
            for x, z in polygon:
                file.write(f"v {x:.9g} {y:.9g} {z:.9g}\n")
        for ring in rings:
            for k in range(1, len(ring) - 1):
                file.write(f"f {ring[0]} {ring[k]} {ring[k + 1]}\n")
    low, high = ([f(p[k] for p in polygon) for k in (0, 1)] for f in (min, max))
    box = [(low[0], -depth / 2, low[1]), (high[0], depth / 2, high[1])]
    text = [" ".join(map(str, corner)) for corner in box]
    size = " ".join(str(b - a) for a, b in zip(*box))
    return layouts.Model({"file": name + ".obj", "kind": "solid", "up_axis": "z", "scale_to_m": 1,
                          "size_m": size, "bbox_min": text[0], "bbox_max": text[1]}, path)


def solid_models(layouts, out):
    def rectangle(a, b):
        return [(-a / 2, -b / 2), (a / 2, -b / 2), (a / 2, b / 2), (-a / 2, b / 2)]

    def regular(radius, n):
        return [(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n))
                for k in range(n)]
    wedge = [(-0.1, -0.04), (0.1, -0.04), (-0.1, 0.06)]
    return [prism(layouts, out, *solid) for solid in (
        ("brick", rectangle(0.2, 0.06), 0.1), ("cube", rectangle(0.1, 0.1), 0.1),
        ("slab", rectangle(0.25, 0.02), 0.2), ("hexagon", regular(0.06, 6), 0.12),
        ("wedge", wedge, 0.1), ("bar", rectangle(0.3, 0.03), 0.03),
        ("octagon", regular(0.07, 8), 0.04))]


def solid_layouts(layouts, out, solids):
    count, num_objects = map(int, solids.split("x"))
    models = solid_models(layouts, out)
    for k in range(count):
        rng, layout = random.Random(f"solid {k}"), layouts.Layout()
        for i in range(num_objects):
            layout.put(f"object_{i + 1:02d}", rng.choice(models), layouts.random_rotation(rng),
                       rng.uniform(-0.12, 0.12), rng.uniform(-0.12, 0.12), 0.3 * (i + 1))
        yield f"solid_{k:02d}", layout.json, None


def turned_about_centre(seed):
    """Puts an object of a heap again, with its start turned about the heap's axis."""
    rng = random.Random(seed)

    def again(put):
        half = math.pi * rng.random()
        c, s = math.cos(half), math.sin(half)
        x, y, z = put["position"]
        w, i, j, k = put["rotation"]
        cos, sin = c * c - s * s, 2 * c * s
        return {**put, "position": [cos * x - sin * y, sin * x + cos * y, z],
                "rotation": [c * w - s * k, c * i - s * j, c * j + s * i, c * k + s * w]}
    return again


def shifted_in_bin(seed, centres):
    """Puts an object of a bin again, elsewhere above the bin."""
    rng = random.Random(seed)

    def again(put):
        x, y, z = put["position"]
        old = centres[put["object"]]
        centres[put["object"]] = new = place_in_bin(rng)
        return {**put, "position": [x + new[0] - old[0], y + new[1] - old[1], z]}
    return again


def sets_of(options):
    """Titles and layouts by name; made as they are asked for."""
    layouts, models, args = read_models(options.shared, options.out)
    return {"floor": ("80 models x 5 on the floor", floor_layouts(layouts, models)),
            "pair": ("80 models x 5 on another model", pair_layouts(layouts, models)),
            "pile": (f"heaps, {options.heaps} objects", pile_layouts(layouts, models, args, options.heaps)),
            "bin": (f"bins, {options.bins} objects", bin_layouts(layouts, models, options.out, options.bins)),
            "solid": (f"solids, {options.solids} objects", solid_layouts(layouts, options.out, options.solids))}
