"""A running `trivet serve`, for tests."""
import contextlib
import http.client
import json
import os
import signal
import socket
import subprocess

from program import PROGRAM, SKIPPED, SLAB, Case, main, put


class UnixConnection(http.client.HTTPConnection):
    def __init__(self, path):
        super().__init__("localhost")
        self.path = path

    def connect(self):
        self.sock = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.sock.connect(self.path)


class Server:
    """A running `trivet serve`."""

    def __init__(self, folder, *arguments, before=None, env=None):
        self.process = subprocess.Popen([PROGRAM, "serve", *map(str, arguments)], cwd=folder,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        preexec_fn=before, env=env and {**os.environ, **env})
        self.errors = ""  # standard error, once it has ended
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
        self.errors = self.process.stderr.read()
        self.process.stderr.close()
        return status


class Served(Case):
    def setUp(self):
        super().setUp()
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"},
                              {"name": "b", "model": "cube.obj"}], [put("a", 0, 0, 1)])
        self.start = layout

    @contextlib.contextmanager
    def server(self, *arguments, before=None, env=None):
        server = Server(self.folder, self.start, *arguments, before=before, env=env)
        try:
            yield server
        finally:
            if server.process.poll() is None:
                self.assertEqual(server.end(), 0)


def built():
    out = subprocess.run([PROGRAM, "serve", os.devnull], capture_output=True, text=True, check=False)
    return "was built without" not in out.stderr


def main_if_built():
    if not built():
        print("skipped: trivet was built without `serve`")
        raise SystemExit(SKIPPED)
    main()
