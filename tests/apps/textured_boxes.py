"""Boxes with an image on each side."""
import struct
import zlib

from program import box_obj


def png(width, height, pixel):
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + \
        chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def textured_box_obj(x, y, z):
    """With an image over each side."""
    lines = box_obj(x, y, z).splitlines()
    corners = [line for line in lines if line[0] == "v"]
    faces = [line.split()[1:] for line in lines if line[0] == "f"]
    turns = (("1", "2", "3"), ("1", "3", "4"))
    return "mtllib carton.mtl\n" + "\n".join(corners) + "\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl paper\n" + "".join(
        "f %s/%s %s/%s %s/%s\n" % tuple(w for v, t in zip(face, turns[i // 6]) for w in (v, t))
        for i, face in enumerate(faces))
