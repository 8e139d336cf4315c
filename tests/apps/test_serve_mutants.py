"""A client of `trivet serve` that changes requests at random, for as long as it is asked to: no crash, and memory that stays.

TRIVET_TEST_MUTANTS=1000000 test_serve_mutants.py      so many requests; default: 10,000 times TRIVET_TEST_EFFORT
"""
import contextlib
import http.client
import json
import os
import random
import threading
import time

from program import SLAB, put
from serving import Served, main_if_built

EFFORT = float(os.environ.get("TRIVET_TEST_EFFORT", "1"))
REQUESTS = int(os.environ.get("TRIVET_TEST_MUTANTS", max(500, 10_000 * EFFORT)))
CLIENTS = 4
GROWTH_MB = 12  # from a quarter of the requests to the end
STATUSES = {200, 201, 400, 403, 404, 405, 409, 413, 421, 431, 501, 503, 504}


class Client:
    """One connection and one session, which it opens again where it loses them."""

    def __init__(self, server, seed):
        self.server, self.chance = server, random.Random(seed)
        self.connection = self.session = None
        self.counts = {}
        self.names = ["a", "b"]

    def operation(self):
        chance = self.chance
        name = chance.choice(self.names)
        kind = chance.randrange(10)
        if kind < 4:
            return put(name, chance.uniform(-.3, .3), chance.uniform(-.3, .3), 1)
        if kind == 4:
            return {"op": "push", "object": name, "direction": [chance.uniform(-1, 1), 1], "distance": 0.02}
        if kind == 5:
            self.names.append("n%d" % chance.randrange(1_000_000))
            self.names = ["a", "b"] + self.names[-20:]
            return {"op": chance.choice(("append", "duplicate")), "object": name, "as": self.names[-1], "model": "cube.obj"}
        if kind == 6:
            return {"op": "delete", "object": name}
        if kind == 7:
            return {"op": "rename", "object": name, "to": "r%d" % chance.randrange(100)}
        if kind == 8:
            return {"op": "group", "object": name, "group": "g" * chance.choice((1, 100, 10_000))}
        return {"op": "unplace", "object": name}

    def line(self):
        kind = self.chance.randrange(12)
        if kind == 0:
            return {"undo": True}
        if kind == 1:
            return {"redo": True}
        if kind == 2:
            return {"query": self.chance.choice(["objects", *self.names])}
        if kind == 3:
            return {"do": [self.operation() for _ in range(self.chance.randrange(6))]}
        return self.operation()

    def mutated(self, text):
        chance, text = self.chance, bytearray(text)
        for _ in range(chance.randrange(4)):
            at = chance.randrange(len(text) + 1)
            kind = chance.randrange(7)
            if kind == 0 and at < len(text):
                text[at] ^= 1 << chance.randrange(8)
            elif kind == 1:
                del text[at:at + chance.randrange(20)]
            elif kind == 2:
                text[at:at] = text[at:at + chance.randrange(20)] * chance.randrange(5)
            elif kind == 3:
                text[at:at] = chance.choice((b"1e308", b"-0", b"null", b"{", b"]", b"\\u0000", b"\xff", b'"', b"NaN"))
            elif kind == 4:
                text[at:at] = b"9" * chance.choice((1, 30, 400))
            elif kind == 5 and chance.random() < 0.02:
                text[at:at] = b"[" * 200_000
            elif kind == 6 and chance.random() < 0.02:
                text[at:at] = b"x" * 100_000
        return bytes(text)

    def request(self):
        chance = self.chance
        method, path = "POST", self.session
        body = json.dumps(self.line()).encode()
        if chance.random() < 0.4:
            body = self.mutated(body)
        headers = {}
        kind = chance.random()
        if kind < 0.03:
            method = chance.choice(("GET", "HEAD", "PUT", "OPTIONS", "TRACE"))
        elif kind < 0.06:
            path = chance.choice(("/", "/metrics", "/healthz", "/sessions/x", self.session + "/scene.glb", "/scenes/1", "/%00", "/..//"))
            method, body = "GET", None
        elif kind < 0.08:
            headers = chance.choice(({"Host": "evil.test"}, {"Origin": "x"}, {"Sec-Fetch-Site": "cross-site"}, {"Expect": "100-continue"},
                                     {"X": "y" * 9000}, {"Content-Length": "7"}, {"Transfer-Encoding": "gzip"}))
        elif kind < 0.082:
            method, body = "DELETE", None
        return method, path, body, headers

    def one(self):
        if not self.connection:
            self.connection = self.server.connect()
        method = ""
        try:
            if not self.session:
                self.session = self.server.open(self.connection)
                self.names = ["a", "b"]
            method, path, body, headers = self.request()
            self.connection.request(method, path, body, headers)
            answer = self.connection.getresponse()
            answer.read()
            status = answer.status
        except (http.client.HTTPException, OSError):
            status = "closed"
            self.connection.close()
            self.connection = None
        self.counts[status] = self.counts.get(status, 0) + 1
        if method == "DELETE":
            self.session = None

    def work(self, count, problems):
        try:
            for _ in range(count):
                self.one()
            with contextlib.suppress(OSError):
                if self.session:
                    self.server.ask("DELETE", self.session)
        except Exception as e:  # else the thread ends unseen
            problems.append(repr(e))


class Mutants(Served):
    def test_no_crash_and_memory_that_stays(self):
        self.start = self.layout([SLAB, {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}])
        problems, memory, counts = [], [], {}
        begin = time.monotonic()
        with self.server("--max-states", 2000, "--max-objects", 200, "--request-seconds", 60) as server:
            clients = [Client(server, seed) for seed in range(CLIENTS)]
            for quarter in range(4):
                threads = [threading.Thread(target=c.work, args=(REQUESTS // CLIENTS // 4, problems)) for c in clients]
                for thread in threads:
                    thread.start()
                for thread in threads:
                    thread.join()
                for client in clients:
                    client.session = None
                memory.append(server.memory_mb())
            self.assertIsNone(server.process.poll())
        for client in clients:
            for status, count in client.counts.items():
                counts[status] = counts.get(status, 0) + count
            if client.connection:
                client.connection.close()
        print("%d requests in %.0f s: %s; memory after each quarter: %s MB" % (
            sum(counts.values()), time.monotonic() - begin,
            ", ".join("%s %d" % one for one in sorted(counts.items(), key=str)), ", ".join("%.1f" % m for m in memory)))
        self.assertEqual(problems, [])
        self.assertEqual(set(counts) - STATUSES - {"closed"}, set())
        self.assertGreater(counts[200], 0.3 * sum(counts.values()))
        if not os.environ.get("TRIVET_SANITIZE"):  # which keep what is freed
            self.assertLess(memory[-1] - memory[0], GROWTH_MB)


if __name__ == "__main__":
    main_if_built()
