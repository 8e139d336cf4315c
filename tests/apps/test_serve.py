"""The server `trivet serve`: sessions over HTTP, limits, clients that misbehave, and its end."""
import contextlib
import http.client
import json
import os
import random
import resource
import signal
import socket
import statistics
import subprocess
import threading
import time

from program import PROGRAM, SKIPPED, SLAB, Case, main, put

EFFORT = float(os.environ.get("TRIVET_TEST_EFFORT", "1"))


class UnixConnection(http.client.HTTPConnection):
    def __init__(self, path):
        super().__init__("localhost")
        self.path = path

    def connect(self):
        self.sock = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.sock.connect(self.path)


class Server:
    """A running `trivet serve`."""

    def __init__(self, folder, *arguments, before=None):
        self.process = subprocess.Popen([PROGRAM, "serve", *map(str, arguments)], cwd=folder,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        preexec_fn=before)
        line = self.process.stdout.readline()
        if not line:
            raise RuntimeError(self.process.stderr.read())
        self.address = json.loads(line)["serving"]
        self.folder = folder

    def connect(self):
        if self.address.startswith("unix:"):
            return UnixConnection(os.path.join(self.folder, self.address[len("unix:"):]))
        return http.client.HTTPConnection(self.address[len("http://"):], timeout=60)

    def socket(self):
        host, port = self.address[len("http://"):].split(":")
        return socket.create_connection((host, int(port)))

    def ask(self, method, path, body=None, connection=None, **headers):
        """Returns the status and the body, JSON read."""
        own = connection or self.connect()
        own.request(method, path, None if body is None else
                    body if isinstance(body, (str, bytes)) else json.dumps(body), headers)
        response = own.getresponse()
        content = response.read()
        if not connection:
            own.close()
        if response.getheader("Content-Type") == "application/json":
            content = json.loads(content)
        return response.status, content

    def open(self, connection=None):
        status, session = self.ask("POST", "/sessions", connection=connection)
        assert status == 201, session
        return "/sessions/" + session["session"]

    def memory_mb(self):
        with open("/proc/%d/statm" % self.process.pid, encoding="utf-8") as file:
            return int(file.read().split()[1]) * 4096 / 1e6

    def end(self, number=signal.SIGTERM):
        self.process.send_signal(number)
        status = self.process.wait(60)
        self.process.stdout.close()
        self.process.stderr.close()
        return status


class Served(Case):
    def setUp(self):
        super().setUp()
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"},
                              {"name": "b", "model": "cube.obj"}], [put("a", 0, 0, 1)])
        self.start = layout

    @contextlib.contextmanager
    def server(self, *arguments, before=None):
        server = Server(self.folder, self.start, *arguments, before=before)
        try:
            yield server
        finally:
            if server.process.poll() is None:
                self.assertEqual(server.end(), 0)


class Routes(Served):
    def test_sessions_are_apart_and_end_in_a_scene(self):
        with self.server() as server:
            one, two = server.open(), server.open()
            status, answer = server.ask("POST", one, put("b", 0.01, 0.02, 1))
            self.assertEqual((status, answer["status"], answer["done"]), (200, "ok", 1))
            self.assertEqual([p["object"] for p in answer["poses"]], ["b"])
            status, other = server.ask("POST", two, {"query": "b"})
            self.assertEqual((status, other["state"]), (200, "unplaced"))
            status, scene = server.ask("GET", one + "/scene.glb")
            self.assertEqual(status, 200)
            self.write("s.glb", scene)
            self.trivet("check", "s.glb")
            self.assertEqual(server.ask("DELETE", one)[0], 200)
            self.assertEqual(server.ask("POST", one, {"undo": True})[0], 404)

    def test_the_same_bytes_as_session(self):
        lines = [put("b", 0.01, 0.02, 1), {"op": "push", "object": "b", "direction": [1, 0],
                                           "distance": 0.1}]
        process = subprocess.run(
            [PROGRAM, "session", self.start], cwd=self.folder, text=True, capture_output=True,
            input="".join(json.dumps(line) + "\n" for line in lines), check=True)
        expected = [json.loads(line) for line in process.stdout.splitlines()]
        with self.server() as server:
            session = server.open()
            answers = [server.ask("POST", session, line)[1] for line in lines]
        self.assertEqual(answers, expected[1:])

    def test_wrong_requests_are_named(self):
        with self.server() as server:
            session = server.open()
            for method, path, body, status, says in (
                    ("POST", session, "{", 400, "request"),
                    ("POST", session, {"nonsense": 1}, 400, "accepted"),
                    ("POST", session, {"save": "x.glb"}, 400, "writes no files"),
                    ("POST", session, {"op": "append", "object": "c", "model": "/etc/passwd"}, 400,
                     "in the folder of the start"),
                    ("POST", session, {"op": "append", "object": "c", "model": "../cube.obj"}, 400,
                     "in the folder of the start"),
                    ("PUT", session, {}, 405, "accepted: POST, DELETE"),
                    ("GET", "/sessions", None, 405, "accepted: POST"),
                    ("POST", "/sessions", {"start": "other.json"}, 400, "a start of this server"),
                    ("POST", "/sessions", {"begin": 1}, 400, "begin"),
                    ("GET", "/session", None, 404, "accepted: /"),
                    ("POST", "/sessions/0123", {}, 404, "never opened"),
                    ("POST", "/metrics", "", 405, "accepted: GET")):
                got, answer = server.ask(method, path, body)
                self.assertEqual(got, status, (method, path, answer))
                self.assertIn(says, answer["reason"])
            status, answer = server.ask("POST", session, put("a", 0, 0, 1), Origin="http://x.org")
            self.assertEqual(status, 403)
            status, answer = server.ask(
                "POST", session, {"op": "append", "object": "c", "model": "cube.obj"})
            self.assertEqual(answer["status"], "ok", answer)
        self.assertNotIn("x.glb", self.files())

    def test_metrics_count(self):
        with self.server() as server:
            session = server.open()
            server.ask("POST", session, put("b", 0.01, 0.02, 1))
            server.ask("POST", session, put("b", 0, 0, -1))
            status, text = server.ask("GET", "/metrics")
            self.assertEqual(status, 200)
            lines = dict(line.rsplit(" ", 1) for line in text.decode().splitlines()
                         if not line.startswith("#"))
            count = {key: float(value) for key, value in lines.items()}
            self.assertEqual(count["trivet_sessions"], 1)
            for result in ("ok", "refused"):
                self.assertEqual(count['trivet_requests_total{result="%s",route="/sessions/ID"}'
                                       % result], 1)
            self.assertGreater(count["process_resident_memory_bytes"], 1e6)
            self.assertEqual(server.ask("GET", "/healthz"), (200, b"ok\n"))
            self.assertEqual(server.ask("GET", "/")[1]["starts"], [self.start])

    def test_a_unix_socket_is_its_owners_alone(self):
        with self.server("--socket", "s.sock") as server:
            self.assertEqual(os.stat(self.path("s.sock")).st_mode & 0o777, 0o600)
            server.open()
            _, err = self.trivet("serve", self.start, "--socket", "s.sock", status=3)
            self.assertIn("s.sock: cannot be listened to", err)
            server.open()
            server.process.kill()
            server.process.wait()
            server.process.stdout.close()
            server.process.stderr.close()
        with self.server("--socket", "s.sock") as server:  # the file was left behind
            server.open()
        self.assertNotIn("s.sock", self.files())
        self.refused("serve", self.start, "--socket", "cube.obj", says="cannot be listened to",
                     status=3)


class Scenes(Served):
    def setUp(self):
        super().setUp()
        self.write("recipe.json", json.dumps({
            "trivet_recipe": 1, "objects": [SLAB],
            "groups": [{"name": "box", "models": [{"model": "cube.obj"}], "count": [2, 4],
                        "scale_range": [0.5, 1.5], "on": ["slab"], "keep": 0.01}]}))

    def test_scenes_are_those_of_a_batch(self):
        only, _ = self.trivet("batch", "recipe.json", "--count", 100, "--seed", 5, "--only", "0,7,99")
        with self.server("--recipe", "recipe.json", "--seed", 5) as server:
            scenes = [server.ask("GET", "/scenes/%d" % k)[1] for k in (0, 7, 99)]
            self.assertEqual(scenes, [json.loads(line) for line in only.splitlines()])
            self.write("7.glb", server.ask("GET", "/scenes/7/scene.glb")[1])
            self.trivet("check", "7.glb")
            status, session = server.ask("POST", "/sessions", {"scene": 7})
            self.assertEqual(status, 201, session)
            path = "/sessions/" + session["session"]
            status, objects = server.ask("POST", path, {"query": "objects"})
            self.assertEqual([(o["object"], o["position"]) for o in objects["objects"]],
                             [(o["name"], o["position"]) for o in scenes[1]["objects"]])
            status, answer = server.ask("POST", path, {"op": "delete", "object": "box_0"})
            self.assertEqual(answer["status"], "ok", answer)
            self.assertIn("recipe", server.ask("GET", "/")[1])

    def test_wrong_scenes_are_named(self):
        with self.server("--recipe", "recipe.json") as server:
            for method, path, body, status, says in (
                    ("GET", "/scenes/x", None, 404, "numbers of scenes"),
                    ("GET", "/scenes/-1", None, 404, "numbers of scenes"),
                    ("GET", "/scenes/99999999999999999999", None, 404, "numbers of scenes"),
                    ("POST", "/scenes/1", {}, 405, "accepted: GET"),
                    ("POST", "/sessions", {"scene": -1}, 400, "0 and up"),
                    ("POST", "/sessions", {"scene": 1.5}, 400, "0 and up")):
                got, answer = server.ask(method, path, body)
                self.assertEqual(got, status, (path, answer))
                self.assertIn(says, answer["reason"])
        with self.server() as server:
            self.assertEqual(server.ask("GET", "/scenes/1")[0], 404)
            self.assertIn("no recipe", server.ask("POST", "/sessions", {"scene": 1})[1]["reason"])
        self.refused("serve", says="missing START")
        self.refused("serve", "--recipe", "none.json", says="none.json")


class Limits(Served):
    def test_too_many_sessions_wait_until_one_is_idle(self):
        with self.server("--max-sessions", 2, "--idle-seconds", 2) as server:
            first, _ = server.open(), server.open()
            self.assertEqual(server.ask("POST", "/sessions")[0], 503)
            time.sleep(2.1)
            server.open()
            self.assertEqual(server.ask("POST", first, {"undo": True})[0], 404)

    def test_a_slow_client_is_closed_and_keeps_nobody_waiting(self):
        with self.server("--request-seconds", 1, "--max-connections", 3) as server:
            slow = [server.socket() for _ in range(3)]
            for client in slow:
                client.sendall(b"POST /sessions HTTP/1.1\r\nHost: x\r\n")
            start = time.monotonic()
            server.open()  # accepted when the slow ones are closed
            self.assertLess(time.monotonic() - start, 10)
            for client in slow:
                client.settimeout(10)
                self.assertEqual(client.recv(100), b"")
                client.close()

    def test_huge_and_garbage_requests_are_refused(self):
        with self.server("--max-request-kb", 64) as server:
            session = server.open()
            status, answer = server.ask("POST", session, b" " * (65 << 10))
            self.assertEqual((status, answer["reason"]), (413, "the request is too large"))
            generator = random.Random(7)
            for _ in range(20):
                with server.socket() as client:
                    client.settimeout(10)
                    client.sendall(generator.randbytes(2000) + b"\r\n\r\n")
                    with contextlib.suppress(ConnectionResetError):
                        self.assertIn(b" 400 ", client.recv(1000))
            self.assertEqual(server.ask("POST", session, {"undo": True})[0], 200)

    def test_few_file_descriptors_are_enough(self):
        with self.server(before=lambda: resource.setrlimit(resource.RLIMIT_NOFILE,
                                                           (64, 64))) as server:
            clients = []
            for _ in range(100):
                client = server.socket()
                clients.append(client)
            for client in clients:
                client.close()
            server.open()


class Load(Served):
    def test_many_clients_and_one_that_is_malicious(self):
        clients, requests = 16, max(4, int(1000 * EFFORT) // 16)
        problems, seconds, halt = [], [], threading.Event()

        def client(server, number):
            connection = server.connect()
            session = server.open(connection)
            for i in range(requests):
                begin = time.monotonic()
                status, answer = server.ask(
                    "POST", session, put("b", 0.01 * (number % 8), 0.001 * i, 1), connection)
                seconds.append(time.monotonic() - begin)
                if (status, answer.get("status")) != (200, "ok"):
                    problems.append((status, answer))
            server.ask("DELETE", session, connection=connection)
            connection.close()

        def malice(server):
            generator = random.Random(3)
            while not halt.is_set():
                with contextlib.suppress(OSError), server.socket() as bad:
                    kind = generator.randrange(3)
                    if kind == 0:
                        bad.sendall(generator.randbytes(5000))
                    elif kind == 1:
                        bad.sendall(b"POST /sessions HTTP/1.1\r\nContent-Length: 999999999\r\n\r\n")
                    else:
                        bad.sendall(b"GET / HT")
                        time.sleep(0.05)

        with self.server("--request-seconds", 2) as server:
            before = server.memory_mb()
            threads = [threading.Thread(target=client, args=(server, k)) for k in range(clients)]
            bad = threading.Thread(target=malice, args=(server,))
            for thread in [bad] + threads:
                thread.start()
            for thread in threads:
                thread.join()
            halt.set()
            bad.join()
            self.assertEqual(problems, [])
            self.assertEqual(len(seconds), clients * requests)
            self.assertLess(server.memory_mb() - before, 100)
        ordered = sorted(seconds)
        print("%d requests: median %.1f ms, 99 %% %.1f ms" % (
            len(ordered), 1e3 * statistics.median(ordered),
            1e3 * ordered[int(0.99 * (len(ordered) - 1))]))

    def many_puts(self):
        """A start, and a line of many operations on it."""
        names = ["c%d" % i for i in range(60)]
        self.start = self.layout([SLAB] + [{"name": n, "model": "cube.obj"} for n in names])
        return {"do": [put(n, 0, 0, 1 + 0.2 * i) for i, n in enumerate(names)]}

    def load(self, server):
        """Requests that wait, and requests that are computed."""
        text = server.ask("GET", "/metrics")[1].decode()
        gauges = dict(line.rsplit(" ", 1) for line in text.splitlines() if line[:1] != "#")
        return tuple(int(gauges["trivet_requests_" + kind]) for kind in ("waiting", "computing"))

    def test_the_end_answers_what_is_under_way(self):
        line, answers = self.many_puts(), []
        with self.server("--threads", 1) as server:
            sessions = [server.open() for _ in range(3)]
            threads = [threading.Thread(
                target=lambda s=session: answers.append(server.ask("POST", s, line)))
                for session in sessions]
            idle = server.connect()
            server.ask("GET", "/healthz", connection=idle)  # kept open
            for thread in threads:
                thread.start()
            while sum(self.load(server)) < 3:
                self.assertEqual(answers, [])
            self.assertEqual(server.end(), 0)
            for thread in threads:
                thread.join()
            idle.close()
        self.assertEqual([(status, answer["status"]) for status, answer in answers],
                         [(200, "ok")] * 3)

    def test_the_second_signal_cancels(self):
        line, answers = self.many_puts(), []
        with self.server("--threads", 1) as server:
            session = server.open()
            asking = threading.Thread(
                target=lambda: answers.append(server.ask("POST", session, line)))
            asking.start()
            while sum(self.load(server)) < 1:
                pass
            server.process.send_signal(signal.SIGTERM)
            time.sleep(0.01)
            self.assertEqual(server.end(), 0)
            asking.join()
        self.assertEqual(answers[0][1]["status"], "cancelled")

    def test_requests_beyond_the_queue_are_told_to_come_again(self):
        line, answers = self.many_puts(), []
        with self.server("--threads", 1, "--max-waiting", 1) as server:
            sessions = [server.open() for _ in range(3)]
            threads = [threading.Thread(
                target=lambda s=session: answers.append(server.ask("POST", s, line)))
                for session in sessions[:2]]
            # One by one: a request waits, too, until the thread takes it up.
            for thread, load in zip(threads, ((0, 1), (1, 1))):
                thread.start()
                while self.load(server) != load:
                    self.assertEqual(answers, [])
            self.assertEqual(server.ask("POST", sessions[2], line)[0], 503)
            for thread in threads:
                thread.join()
        self.assertEqual([status for status, _ in answers], [200, 200])

    def test_cancel_stops_what_is_under_way(self):
        line, answers = self.many_puts(), []
        with self.server() as server:
            session = server.open()
            asking = threading.Thread(
                target=lambda: answers.append(server.ask("POST", session, line)))
            asking.start()
            while asking.is_alive():
                server.ask("POST", session, {"cancel": True})
            asking.join()
            status, answer = answers[0]
            self.assertEqual((status, answer["status"]), (200, "cancelled"))
            self.assertEqual(server.ask("POST", session, {"query": "c0"})[1]["state"],
                             "unplaced")


def built():
    out = subprocess.run([PROGRAM, "serve", os.devnull], capture_output=True, text=True, check=False)
    return "was built without" not in out.stderr


if __name__ == "__main__":
    if not built():
        print("skipped: trivet was built without `serve`")
        raise SystemExit(SKIPPED)
    main()
