"""Pictures of compare.sh in a sheet, a column per model: rays, OpenGL, Blender; and their differences on the model.

Usage: beside.py FOLDER
"""
import pathlib
import sys

import numpy
from PIL import Image

ROWS = ("path", "opengl", "blender")


def read(file):
    return numpy.asarray(Image.open(file).convert("RGB"), float)


def filmed(picture):
    """As Trivet's film() bends what is bright, of a picture that clips it."""
    x = picture / 255
    x = numpy.where(x <= .04045, x / 12.92, ((x + .055) / 1.055) ** 2.4)
    x = numpy.where(x <= .6, x, 1 - .4 * numpy.exp(-(x - .6) / .4))
    return 255 * numpy.where(x <= .0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - .055)


def main():
    folder = pathlib.Path(sys.argv[1])
    names = sorted(file.stem for file in (folder / "path").glob("*.png"))
    columns = [[read(folder / row / (name + ".png")) for row in ROWS] for name in names]
    for column in columns:
        column[-1] = filmed(column[-1])
    sheet = numpy.concatenate([numpy.concatenate(column) for column in columns], axis=1)
    Image.fromarray(sheet.astype("uint8")).save(folder / "beside.png")
    print("| model | rays, mean | Blender, mean | difference of the means | RMSE |\n|---|--:|--:|--:|--:|")
    for name, (ours, _, theirs) in zip(names, columns):
        height, width, _ = ours.shape
        part = (slice(int(.25 * height), int(.75 * height)), slice(int(.3 * width), int(.7 * width)))
        a, b = ours[part], theirs[part]
        means = [" ".join("%.0f" % c for c in each.mean((0, 1))) for each in (a, b)]
        apart = numpy.abs(a.mean((0, 1)) - b.mean((0, 1))).max()
        print("| %s | %s | %s | %.0f | %.0f |" % (name, *means, apart, numpy.sqrt(((a - b) ** 2).mean())))


if __name__ == "__main__":
    main()
