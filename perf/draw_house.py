"""Two source trees as houses: a row for each layer, a room for each folder as wide as its lines are many, and the installed headers.

draw_house.py BEFORE AFTER OUT.svg. For an earlier state: git archive REVISION | tar x -C BEFORE.
"""
import html
import pathlib
import re
import sys

LAYERS = (("apps", "#eef3fb", "#7d93b8"), ("ops", "#eef8f0", "#7daa88"), ("gpu", "#fdf4e7", "#c39a5b"), ("raster", "#fdf4e7", "#c39a5b"),
          ("core", "#f6eefb", "#9b7db8"))
WIDTH, HIGH, GAP = 1100, 40, 6
ENDINGS = {".h", ".cpp", ".py", ".js", ".mjs"}


def lines(folder):
    return sum(p.read_bytes().count(b"\n") for p in folder.rglob("*") if p.suffix in ENDINGS and p.is_file())


def rooms(root, layer):
    found = [(p.name, lines(p)) for p in sorted((root / layer).iterdir()) if p.is_dir()]
    return sorted([room for room in found if room[1]], key=lambda room: -room[1])


def installed(root):
    """Headers for other programs: those of include, or all of the libraries that no list in CMake calls private."""
    own = list((root / "include").rglob("*.h"))
    if own:
        return len(own)
    libraries = ("core", "raster", "ops")
    private = {name for layer in libraries for name in re.findall(r"\w+\.h", (root / layer / "CMakeLists.txt").read_text())}
    return 1 + sum(p.name not in private for layer in libraries for p in (root / layer).rglob("*.h"))


def text(x, y, size, value, anchor="start", fill="#1d2733"):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" fill="{fill}">{html.escape(value)}</text>'


def row(root, layer, fill, stroke, y, scale):
    out = [text(20, y + 25, 15, layer)]
    x = 80.0
    for name, count in rooms(root, layer):
        wide = max(4.0, count * scale)
        out.append(f'<rect x="{x:.1f}" y="{y}" width="{wide:.1f}" height="{HIGH}" rx="4" fill="{fill}" stroke="{stroke}"/>')
        if wide > 7 * len(name) + 4:
            out.append(text(x + wide / 2, y + 18, 12, name, "middle"))
            out.append(text(x + wide / 2, y + 33, 10, f"{count:,}", "middle", "#4b5866"))
        x += wide + 3
    return out


def house(root, title, headers, y, scale):
    total = sum(count for layer, _, _ in LAYERS for _, count in rooms(root, layer))
    out = [text(20, y + 18, 16, f"{title}: {total:,} lines behind {headers} installed headers")]
    y += 30
    for layer, fill, stroke in LAYERS:
        out += row(root, layer, fill, stroke, y, scale)
        y += HIGH + GAP
    return out, y


def main():
    before, after, picture = map(pathlib.Path, sys.argv[1:])
    widest = max(sum(count for _, count in rooms(root, layer)) for root in (before, after) for layer, _, _ in LAYERS)
    scale = (WIDTH - 190) / widest
    first, y = house(before, "Before", installed(before), 10, scale)
    second, y = house(after, "After", installed(after), y + 24, scale)
    picture.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {y + 10}" width="{WIDTH}" height="{y + 10}" '
                       'font-family="DejaVu Sans, Arial, sans-serif">\n<rect width="100%" height="100%" fill="#ffffff"/>\n'
                       + "\n".join(first + second) + "\n</svg>\n")


main()
