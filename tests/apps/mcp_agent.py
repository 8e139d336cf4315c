"""An agent of `trivet mcp`, for tests."""
import base64
import json
import subprocess

from program import PROGRAM


class Agent:
    """A running `trivet mcp`."""

    def __init__(self, folder, *arguments):
        self.process = subprocess.Popen([PROGRAM, "mcp", *map(str, arguments)], cwd=folder, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.number = 0

    def send(self, line):
        self.process.stdin.write((line if isinstance(line, bytes) else json.dumps(line).encode()) + b"\n")
        self.process.stdin.flush()

    def receive(self):
        return json.loads(self.process.stdout.readline())

    def request(self, method, **params):
        self.number += 1
        self.send({"jsonrpc": "2.0", "id": self.number, "method": method, "params": params})
        answer = self.receive()
        assert answer["id"] == self.number, answer
        return answer

    def call(self, tool, **arguments):
        """@return whether it was done, the text, the data, the picture's bytes or None."""
        result = self.request("tools/call", name=tool, arguments=arguments)["result"]
        text, *pictures = result["content"]
        picture = base64.b64decode(pictures[0]["data"]) if pictures else None
        return not result["isError"], text["text"], result.get("structuredContent"), picture

    def end(self):
        self.process.stdin.close()
        status = self.process.wait(60)
        self.process.stdout.close()
        self.process.stderr.close()
        return status
