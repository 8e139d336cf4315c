"""Cases of the field: objects that are to be set down, as layouts with start poses in the air.

Models are those of Trivet's demos, and a bin made here. Metres, z up; a pose takes the model's origin, upright, to its
place. Every case follows from its name alone.
"""
import glob
import json
import math
import os
import random
import subprocess

DEMOS = ("breakfast", "office1", "workshop", "market")
KINDS = ("single", "pair", "bin", "heap", "table", "start")
CLEAR = 0.005  # metres between objects at the start
ERROR = 0.003  # metres by which start states are wrong
UPRIGHT = [1.0, 0.0, 0.0, 0.0]
# Objects that stay; a load falls on each of them.
SUPPORTS = ("bowl", "plate", "saucer", "chair", "desk", "monitor", "waste_basket", "toolbox")
LOADS = ("apple", "banana", "cup", "spoon", "mug", "telephone", "hammer", "book_red")
SINGLES = LOADS + SUPPORTS + ("egg", "glass", "jug", "lamp", "nut", "pencil", "teapot", "toast")
SMALL = ("apple", "banana", "bolt", "cup", "egg", "hammer", "mug", "nut", "screwdriver", "spoon", "tin", "can_red")
BIN = ((0.2, 0.15, 0.25), 0.01)  # half width, half depth, height; thickness


class Model:
    def __init__(self, file, size):
        self.file, self.name = file, os.path.splitext(os.path.basename(file))[0]
        self.lower, self.upper = size

    def radius(self):
        """Radius of a ball about the origin that holds the model."""
        return math.hypot(*(max(abs(a), abs(b)) for a, b in zip(self.lower, self.upper)))


def upright_box(info):
    """Box of a model whose up axis became z."""
    lower, upper = info["box"]["lower"], info["box"]["upper"]
    if info["up"] == "y":  # x, y, z -> x, -z, y
        lower, upper = [lower[0], -upper[2], lower[1]], [upper[0], -lower[2], upper[1]]
    unit = info["metres_per_unit"] or 1
    return [v * unit for v in lower], [v * unit for v in upper]


def run(trivet, *arguments):
    done = subprocess.run([trivet, *arguments, "--quiet"], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{trivet} {' '.join(arguments)}: status {done.returncode}: {done.stderr}")
    return done.stdout


def write_bin(path):
    (width, depth, height), t = BIN
    boxes = [((-width - t, -depth - t, 0), (width + t, depth + t, t)),
             ((-width - t, -depth - t, t), (-width, depth + t, height)), ((width, -depth - t, t), (width + t, depth + t, height)),
             ((-width, -depth - t, t), (width, -depth, height)), ((-width, depth, t), (width, depth + t, height))]
    faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
    with open(path, "w") as file:
        for number, box in enumerate(boxes):
            for corner in range(8):
                x, y, z = (box[corner >> (2 - k) & 1][k] for k in range(3))
                file.write(f"v {x:.9g} {y:.9g} {z:.9g}\n")
            for face in faces:
                file.write("f " + " ".join(str(8 * number + v) for v in face) + "\n")


def make_models(trivet, folder):
    """Models by name; written to `folder`."""
    for demo in DEMOS:
        run(trivet, "demo", demo, "-o", os.path.join(folder, demo, "scene.glb"), "--export", os.path.join(folder, demo))
    write_bin(os.path.join(folder, "bin.obj"))
    files = {}
    for path in sorted(glob.glob(os.path.join(folder, "*", "*.glb"))) + [os.path.join(folder, "bin.obj")]:
        files.setdefault(os.path.splitext(os.path.basename(path))[0], path)
    del files["scene"]
    return {name: Model(path, upright_box(json.loads(run(trivet, "info", path, "--json")))) for name, path in files.items()}


def poses_of(trivet, scene):
    """Poses of a scene that Trivet wrote, {name: {position, rotation}}, without those that are fixed or not placed."""
    table = scene[:-4] + ".jsonl"
    run(trivet, "export", scene, "-o", table, "--table", "poses")
    with open(table) as file:
        rows = [json.loads(line) for line in file]
    return {r["name"]: {"position": [r["x"], r["y"], r["z"]], "rotation": [r["qw"], r["qx"], r["qy"], r["qz"]]}
            for r in rows if not r["fixed"] and r["x"] is not None}


def raised(position, height):
    return [position[0], position[1], position[2] + height]


def random_rotation(chance):
    """Uniform over all rotations, w x y z [Shoemake 1992]."""
    u, a, b = chance.random(), 2 * math.pi * chance.random(), 2 * math.pi * chance.random()
    p, q = math.sqrt(1 - u), math.sqrt(u)
    return [q * math.cos(b), p * math.sin(a), p * math.cos(a), q * math.sin(b)]


class Case:
    """A start. Where objects stand in each other there, `free` has positions at which they do not, {name: position}, and
    `lift` is the height in metres from which an object falls to those that are at rest already."""

    def __init__(self, kind, number):
        self.kind, self.name, self.objects, self.free, self.lift = kind, f"{kind}-{number:02d}", [], {}, 0
        self.chance = random.Random(self.name)

    def add(self, model, position, rotation, fixed=False):
        entry = {"name": f"{model.name}_{len(self.objects)}", "model": model.file, "position": position, "rotation": rotation}
        self.objects.append(dict(entry, fixed=True) if fixed else entry)

    def stand(self, model):
        """Sets a fixed model on the floor, upright, and returns its height."""
        self.add(model, [0, 0, 1e-5 - model.lower[2]], UPRIGHT, fixed=True)
        return model.upper[2] - model.lower[2] + 1e-5

    def drop(self, model, x, y, bottom):
        """Hangs a model, turned at random, with all of it above `bottom`; returns the height of all of it."""
        radius = model.radius()
        self.add(model, [x, y, bottom + radius + CLEAR], random_rotation(self.chance))
        return bottom + 2 * (radius + CLEAR)

    def layout(self):
        return {"trivet": 1, "floor": True, "objects": self.objects}

    def free_layout(self):
        return dict(self.layout(), objects=[dict(o, position=self.free.get(o["name"], o["position"])) for o in self.objects])

    def layout_with(self, poses):
        """The layout with objects at other poses, {name: {position, rotation}}; those without one are left out."""
        return dict(self.layout(), objects=[dict(o, **poses[o["name"]]) if o["name"] in poses else o
                                            for o in self.objects if o.get("fixed") or o["name"] in poses])


def singles(models):
    for number, name in enumerate(SINGLES):
        case = Case("single", number)
        case.drop(models[name], 0, 0, 0)
        yield case


def pairs(models):
    for number, (support, load) in enumerate(zip(SUPPORTS, LOADS)):
        case = Case("pair", number)
        case.drop(models[load], 0, 0, case.stand(models[support]))
        yield case


def pile(case, models, count, spread, bottom):
    """Layers of four objects, one above the other."""
    for number in range(count):
        if number % 4 == 0:
            top = bottom
        x, y = (spread * (number >> k & 1) - spread / 2 for k in range(2))
        bottom = max(bottom, case.drop(models[case.chance.choice(SMALL)], x, y, top))


def bins(models):
    for number in range(3):
        case = Case("bin", number)
        pile(case, models, 12, 0.15, case.stand(models["bin"]))
        yield case


def heaps(models):
    for number in range(2):
        case = Case("heap", number)
        pile(case, models, 24, 0.3, 0)
        yield case


def laid_table(trivet, folder):
    """BREAKFAST as Trivet lays it: (entry, level) of each object, the table first; the level counts what is below it."""
    folder = os.path.join(folder, "breakfast")
    scene, report = (os.path.join(folder, name) for name in ("scene.glb", "report.json"))
    run(trivet, "demo", "breakfast", "-o", scene, "--report", report)
    poses = poses_of(trivet, scene)
    with open(report) as file:
        objects = json.load(file)["objects"]
    carriers = {o["name"]: o["supported_by"] for o in objects}

    def level(name):
        return 1 + max((level(c) for c in carriers[name] if c in poses), default=0) if name in poses else 0

    for o in sorted(objects, key=lambda o: (level(o["name"]), o["name"])):
        still = {"position": [0, 0, 1e-5], "rotation": UPRIGHT, "fixed": True}
        yield dict({"name": o["name"], "model": os.path.join(folder, o["model"])}, **poses.get(o["name"], still)), level(o["name"])


def table(laid, case):
    """BREAKFAST: 23 objects over their places on a table, each 5 mm over where it lies and over what carries it."""
    case.objects = [dict(entry, position=raised(entry["position"], CLEAR * level)) for entry, level in laid]
    return case


def start_state(laid, case):
    """BREAKFAST with errors such as start states of benchmarks have: each object up to 3 mm too high or too low."""
    case.free = {o["name"]: o["position"] for o in table(laid, case).objects}
    case.objects = [dict(entry, position=raised(entry["position"], case.chance.uniform(-ERROR, ERROR) if level else 0))
                    for entry, level in laid]
    case.lift = 2 * ERROR
    return case


def all_cases(trivet, folder, kinds):
    """The cases of these kinds, in order; all kinds are in KINDS."""
    models = make_models(trivet, folder)
    for kind, made in (("single", singles), ("pair", pairs), ("bin", bins), ("heap", heaps)):
        if kind in kinds:
            yield from made(models)
    if "table" in kinds or "start" in kinds:
        laid = list(laid_table(trivet, folder))
        if "table" in kinds:
            yield table(laid, Case("table", 0))
        if "start" in kinds:
            yield from (start_state(laid, Case("start", number)) for number in range(3))
