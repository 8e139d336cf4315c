"""trivet batch status, verify and merge: what is missing, changed, or of another batch."""
import glob
import hashlib
import json
import os
import random
import re

from batches import EFFORT, BatchCase
from program import main


class Audit(BatchCase):
    def test_verify_finds_one_flipped_bit(self):
        self.batch("out", count=20)
        good = self.trivet("batch", "verify", "out", "--sample", 0.3)[0]
        self.assertIn("0 findings", good)
        kinds = [[n for n in self.files() if n.startswith("out/") and n.endswith(end)]
                 for end in (".tar", ".obj", "run.json")]
        self.assertEqual([len(names) for names in kinds], [4, 2, 1])
        generator = random.Random(3)
        for i in range(int(60 * EFFORT) or 3):
            name = generator.choice(kinds[i % 3])
            content = self.read(name)
            at = generator.randrange(len(content))
            self.write(name, content[:at] + bytes([content[at] ^ 1 << generator.randrange(8)]) + content[at + 1:])
            self.assertRegex(self.trivet("batch", "verify", "out", "--sample", 0, status=1)[0], r"\b1 finding\b", (name, at))
            self.write(name, content)
        self.assertEqual(self.trivet("batch", "verify", "out", "--sample", 0.3)[0], good)

    def test_a_changed_run_is_not_continued(self):
        self.batch("out", "--shard", "0/2", count=10)
        good = self.read("out/run.json").decode()
        for was, becomes in (('"count": 10', '"count": 11'), ('"version": "0', '"version": "1'),
                             ('"seed": 0', '"seed": 1'), ('"per_unit": 5', '"per_unit": 4')):
            self.assertIn(was, good)
            self.write("out/run.json", good.replace(was, becomes))
            out = self.trivet("batch", "verify", "out", status=1)[0]
            self.assertIn("run.json: was changed after it was written", out)
            for arguments in (("status", "out"), ("merge", "out", "-o", "all.csv")):
                self.refused("batch", *arguments, says="was changed after it was written")
            self.assertIn("was changed", self.batch("out", count=10, status=2)[1])
        self.write("out/run.json", good)
        self.batch("out", count=10)

    def test_units_of_other_batches_and_places_are_found(self):
        """They are whole, and true to themselves."""
        for out_format in ("tar", "poses", "dir"):
            one, two = "one_" + out_format, "two_" + out_format
            self.batch(one, "--format", out_format, count=20)
            self.batch(two, "--format", out_format, "--seed", 1, count=20)
            units = sorted(glob.glob(self.path(one + "/0000/scenes-*")))
            kept = self.path("kept_" + out_format)
            os.rename(units[1], kept)
            os.rename(units[1].replace(one, two), units[1])
            self.assert_found(one, "is a unit of another batch than run.json says", "--format", out_format)
            os.rename(units[1], kept + ".other")
            os.rename(units[2], units[1])
            os.rename(kept, units[2])
            self.assert_found(one, "is another unit of the batch", "--format", out_format)

    def assert_found(self, out, says, *more):
        self.assertIn(says, self.trivet("batch", "verify", out, "--sample", 0, status=1)[0])
        self.assertIn(says, self.trivet("batch", "status", out, status=2)[1])
        self.assertIn(says, self.batch(out, *more, count=20, status=2)[1])

    def test_verify_finds_what_is_true_to_itself_but_made_otherwise(self):
        self.batch("out", "--format", "poses", count=5)
        name = "out/0000/scenes-000000.jsonl"
        rows = self.read(name).decode().splitlines(keepends=True)
        rows[0] = rows[0].replace('"attempt":0', '"attempt":1')
        end = json.loads(rows[-1])
        end["sha256"] = hashlib.sha256("".join(rows[:-1]).encode()).hexdigest()
        self.write(name, "".join(rows[:-1]) + json.dumps(end, separators=(",", ":")) + "\n")
        self.assertIn("0 findings", self.trivet("batch", "verify", "out", "--sample", 0)[0])
        self.assertIn("scene 0 made again has other poses",
                      self.trivet("batch", "verify", "out", "--sample", 1, status=1)[0])

    def test_damage_of_any_kind_is_told_as_damage(self):
        """Never a crash, and no words of libraries: status 0 to 2, and verify finds it."""
        for out_format in ("tar", "poses", "dir"):
            self.batch(out_format, "--format", out_format, count=10)
            units = sorted(name for name in self.files() if name.startswith(out_format + "/") and "/models/" not in name)
            generator = random.Random(5)
            for i in range(int(60 * EFFORT) or 6):
                name, kind = generator.choice(units), i % 6
                whole = self.read(name)
                self.write(name, self.damaged(bytearray(whole), kind, generator))
                for command in (("status", out_format), ("verify", out_format, "--sample", 0), ("merge", out_format, "-o", "m.jsonl"),
                                ("materialise", out_format, 3, "-o", "3.glb")):
                    out, err = self.trivet("batch", *command, status=(0, 1, 2))
                    for word in ("json.exception", "unexpected: ", "std::", "basic_"):
                        self.assertNotIn(word, out + err, (name, kind, command))
                    if command[0] == "verify" and self.read(name) != whole:
                        self.assertNotIn(" 0 findings", out, (name, kind))
                self.write(name, whole)

    def damaged(self, content, kind, generator):
        at = generator.randrange(len(content))
        if kind == 0:
            content[at] ^= 1 << generator.randrange(8)
        elif kind == 1:
            del content[at:]
        elif kind == 2:  # a value of another kind
            values = list(re.finditer(rb'"[a-z_]+": ?', bytes(content)))
            if values:
                at = generator.choice(values).end()
                content[at:at + 1] = generator.choice((b"null", b'"x"', b"{}", b"-1", b"1e400"))
        elif kind == 3:
            content[0:0] = b"[" * 200_000
        elif kind == 4:
            content[at:at] = b'{"a":' * 100_000
        else:
            del content[:]
        return bytes(content)

    def test_another_run_is_refused(self):
        self.batch("out", count=10)
        before = self.hashes("out")
        for more, says in (((("--seed", 1)), "seed is 0, here 1"), (("--format", "dir"), "format is")):
            self.assertIn("another batch is in this folder: " + says, self.batch("out", *more, count=10, status=2)[1])
        self.assertIn("count is 10, here 11", self.batch("out", count=11, status=2)[1])
        self.write_recipe(max_motions=10)
        self.assertIn("recipe", self.batch("out", count=10, status=2)[1])
        self.assertEqual(self.hashes("out"), before)

    def test_another_model_of_the_same_name_is_another_recipe(self):
        self.batch("out", count=10)
        self.write("cube.obj", self.read("cube.obj") + b"v 1 1 1\n")
        self.assertIn("another batch is in this folder", self.batch("out", count=10, status=2)[1])

    def test_status_and_merge(self):
        self.write_recipe(accept={"min_objects": 2})
        self.batch("out", "--shard", "0/2")
        out = self.trivet("batch", "status", "out", status=1)[0]
        self.assertIn("units: 4 of 8; scenes: 20 of 40", out)
        self.assertIn("\nmissing units: 1, 3, 5, 7\n", out)
        self.assertIn("refused: 1 objects; accepted: at least 2", out)
        status = json.loads(self.trivet("batch", "status", "out", "--json", status=1)[0])
        self.assertEqual(status["ok"] + status["refused"], 20)
        self.assertGreater(status["refused"], 0)
        self.assertEqual(status["first_missing"], [1, 3, 5, 7])
        self.batch("many", "--shard", "5/30", count=150)
        self.assertIn("\nmissing units: 0, 1, 2, 3, 4, 6, 7, 8, 9, 10 and 19 others\n",
                      self.trivet("batch", "status", "many", status=1)[0])
        self.batch("out")
        self.assertNotIn("missing", self.trivet("batch", "status", "out")[0])
        self.trivet("batch", "merge", "out", "-o", "all.jsonl")
        self.trivet("batch", "merge", "out", "-o", "all.csv")
        rows = [json.loads(line) for line in self.read("all.jsonl").splitlines()]
        self.assertEqual([row["k"] for row in rows], list(range(40)))
        for row in rows:
            self.assertEqual(row["status"], "ok" if row["objects"] >= 3 else "refused")  # with the slab
        lines = self.read("all.csv").decode().splitlines()
        self.assertEqual(len(lines), 41)
        self.assertTrue(lines[0].startswith("k,status,reason"))
        self.refused("batch", "merge", "out", "-o", "all.parquet", says="accepted: .jsonl, .csv")


if __name__ == "__main__":
    main()
