"""A running `trivet session`, for tests."""
import json
import subprocess

from program import PROGRAM, SLAB, Case, put


class Live:
    """A running `trivet session`."""

    def __init__(self, folder, *arguments):
        self.process = subprocess.Popen([PROGRAM, "session", *map(str, arguments)], cwd=folder,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.start = json.loads(self.process.stdout.readline())

    def ask(self, **line):
        self.process.stdin.write(json.dumps(line) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def end(self):
        self.process.stdin.close()
        status = self.process.wait()
        self.process.stdout.close()
        self.process.stderr.close()
        return status


class SessionCase(Case):
    def start_layout(self):
        return self.layout([SLAB, {"name": "a", "model": "cube.obj"},
                            {"name": "b", "model": "cube.obj"}], [put("a", 0, 0, 1)])
