"""Readers of labelled images, with Python's own library only."""
import struct
import zlib


def read_png(data):
    """(width, height, channels, values by row) of an 8- or 16-bit PNG without palette."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        at += 12 + size
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    step, stride = channels * bits // 8, width * channels * bits // 8
    raw, previous, rows = zlib.decompress(packed), bytearray(stride), bytearray()
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, above = line[i - step] if i >= step else 0, previous[i]
            corner = previous[i - step] if i >= step else 0
            if kind == 4:
                guess = left + above - corner
                near = sorted((abs(guess - v), k) for k, v in enumerate((left, above, corner)))
                add = (left, above, corner)[near[0][1]]
            else:
                add = (0, left, above, (left + above) // 2)[kind]
            line[i] = (line[i] + add) & 255
        rows += line
        previous = line
    count = width * height * channels
    return width, height, channels, struct.unpack(">%d%s" % (count, "H" if bits == 16 else "B"), rows)


def read_exr(data):
    """{channel: float values by row} of a scan line OpenEXR of float32 that ZIP compressed."""
    assert struct.unpack("<I", data[:4])[0] == 20000630
    at, header = 8, {}
    while data[at]:
        name, kind, rest = data[at:].split(b"\0", 2)
        size, = struct.unpack("<I", rest[:4])
        at += len(name) + len(kind) + 6
        header[name.decode()] = data[at:at + size]
        at += size
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height, names, text = x1 - x0 + 1, y1 - y0 + 1, [], header["channels"]
    while text[0]:
        name, text = text.split(b"\0", 1)
        names.append(name.decode())
        text = text[16:]
    rows = {name: [None] * height for name in names}
    first = at + 1
    for block in range((height + 15) // 16):
        place, = struct.unpack("<Q", data[first + 8 * block:first + 8 * block + 8])
        y, size = struct.unpack("<iI", data[place:place + 8])
        lines, body = min(16, height - y), data[place + 8:place + 8 + size]
        whole = 4 * width * len(names) * lines
        if size < whole:
            body = bytearray(zlib.decompress(body))
            for i in range(1, whole):
                body[i] = (body[i - 1] + body[i] - 128) & 255
            half, mixed = (whole + 1) // 2, bytearray(whole)
            mixed[0::2], mixed[1::2] = body[:half], body[half:]
            body = bytes(mixed)
        values = struct.unpack("<%df" % (whole // 4), body)
        for line in range(lines):
            for c, name in enumerate(names):
                start = (line * len(names) + c) * width
                rows[name][y + line] = values[start:start + width]
    return {name: [v for row in all_rows for v in row] for name, all_rows in rows.items()}


def decoded_mask(segmentation):
    """Row by row, of compressed run lengths, as pycocotools' rleFrString() and rleDecode() do."""
    counts, text, at = [], segmentation["counts"].encode(), 0
    while at < len(text):
        value, shift, more = 0, 0, True
        while more:
            piece = text[at] - 48
            value |= (piece & 31) << shift
            more = bool(piece & 32)
            at, shift = at + 1, shift + 5
            if not more and piece & 16:
                value |= -1 << shift
        counts.append(value + (counts[-2] if len(counts) > 2 else 0))
    height, width = segmentation["size"]
    columns = [i & 1 for i, count in enumerate(counts) for _ in range(count)]
    assert len(columns) == width * height
    return [columns[x * height + y] for y in range(height) for x in range(width)]
