"""Agents over HTTP: POST /mcp of `trivet serve`."""
import json
import os
from concurrent.futures import ThreadPoolExecutor

from program import box_obj
from serving import Served, main_if_built

BEGIN = {"jsonrpc": "2.0", "id": 0, "method": "initialize",
         "params": {"protocolVersion": "2025-11-25", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}}


class HttpAgent:
    def __init__(self, server):
        self.server, self.number = server, 0
        self.status, self.greeting, self.session = self.post(BEGIN)

    def post(self, message, **headers):
        """@return status, the body's JSON or None, the id of the session that the answer names."""
        connection = self.server.connect()
        body = message if isinstance(message, (str, bytes)) else json.dumps(message)
        connection.request("POST", "/mcp", body, {"Content-Type": "application/json", **headers})
        response = connection.getresponse()
        content = response.read()
        connection.close()
        return response.status, json.loads(content) if content else None, response.getheader("Mcp-Session-Id")

    def ask(self, message, **headers):
        return self.post(message, **{"Mcp-Session-Id": self.session, "MCP-Protocol-Version": "2025-11-25", **headers})

    def request(self, method, **params):
        self.number += 1
        status, answer, _ = self.ask({"jsonrpc": "2.0", "id": self.number, "method": method, "params": params})
        assert status == 200 and answer["id"] == self.number, answer
        return answer

    def call(self, tool, **arguments):
        result = self.request("tools/call", name=tool, arguments=arguments)["result"]
        return not result["isError"], result["content"][0]["text"]


class Agents(Served):
    def test_an_agent_works_on_a_scene_of_its_own(self):
        with self.server() as server:
            one, two = HttpAgent(server), HttpAgent(server)
            self.assertEqual((one.status, one.greeting["result"]["protocolVersion"]), (200, "2025-11-25"))
            self.assertRegex(one.session, "^[0-9a-f]{32}$")
            self.assertNotEqual(one.session, two.session)
            self.assertEqual(one.ask({"jsonrpc": "2.0", "method": "notifications/initialized"})[:2], (202, None))
            tools = {tool["name"] for tool in one.request("tools/list")["result"]["tools"]}
            self.assertLessEqual({"open", "put", "check", "look"}, tools)
            self.assertNotIn("save", tools)
            self.assertTrue(one.call("open", file=self.start)[0])
            self.assertTrue(one.call("put", object="b", position=[0.01, 0.02, 1])[0])
            self.assertTrue(two.call("open")[0])
            self.assertIn("0 objects", two.call("list")[1])
            status, scene = server.ask("GET", "/mcp/scene.glb", **{"Mcp-Session-Id": one.session})
            self.assertEqual(status, 200)
            self.write("s.glb", scene)
            self.trivet("check", "s.glb")
            self.assertEqual(server.ask("GET", "/")[1]["sessions"], 2)
            self.assertEqual(server.ask("DELETE", "/mcp", **{"Mcp-Session-Id": one.session})[0], 200)
            self.assertEqual(one.ask({"jsonrpc": "2.0", "id": 1, "method": "ping"})[0], 404)

    def test_wrong_requests_are_named(self):
        ping = {"jsonrpc": "2.0", "id": 1, "method": "ping"}
        with self.server() as server:
            agent = HttpAgent(server)
            for message, headers, status, says in (
                    (ping, {"Mcp-Session-Id": ""}, 400, "initialize"),
                    (ping, {"Mcp-Session-Id": "0" * 32}, 404, "initialize again"),
                    (ping, {"MCP-Protocol-Version": "1999-01-01"}, 400, "MCP-Protocol-Version"),
                    (ping, {"Origin": "http://x.org"}, 403, "pages"),
                    (ping, {"Host": "x.org"}, 421, "another name"),
                    ("{", {}, 400, "message"), ("[]", {}, 400, "one JSON object"), (b"\xff", {}, 400, "message"),
                    ("[" * 1000, {}, 400, "message"), (" " * 2_000_000, {}, 413, "too large")):
                got, answer, _ = agent.ask(message, **headers)
                self.assertEqual(got, status, (message, headers, answer))
                self.assertIn(says, json.dumps(answer))
            for method in ("GET", "PUT"):
                status, answer = server.ask(method, "/mcp", **{"Mcp-Session-Id": agent.session})
                self.assertEqual((status, "POST, DELETE" in answer["reason"]), (405, True))
            self.assertEqual(server.ask("GET", "/mcp/scene.glb")[0], 404)
            self.assertEqual(server.ask("GET", "/mcp/scene.glb", **{"Mcp-Session-Id": agent.session})[0], 400)
            self.assertEqual(agent.ask(ping)[:2], (200, {"jsonrpc": "2.0", "id": 1, "result": {}}))
            self.assertEqual(agent.ask({"jsonrpc": "2.0", "id": 1, "method": "nothing"})[1]["error"]["code"], -32601)

    def test_only_the_folder_of_the_start_is_read_and_nothing_is_written(self):
        self.write("secret.obj", box_obj(1, 1, 1))
        os.mkdir(self.path("in"))
        for name in (self.start, "cube.obj", "slab.obj"):
            os.rename(self.path(name), self.path("in/" + name))
        self.start = "in/" + self.start
        before = self.files()
        with self.server() as server:
            agent = HttpAgent(server)
            self.assertTrue(agent.call("open")[0])
            for name in ("../secret.obj", self.path("secret.obj")):
                for tool, arguments in (("append", {"object": "x", "model": name}), ("open", {"file": name})):
                    done, text = agent.call(tool, **arguments)
                    self.assertFalse(done)
                    self.assertIn("accepted: a file in the folder", text)
            answer = agent.request("tools/call", name="save", arguments={"file": "out.glb"})
            self.assertEqual(answer["error"]["code"], -32602)
            self.assertFalse(agent.call("put", object="x", save="out.glb")[0])
            self.assertTrue(agent.call("append", object="x", model="cube.obj")[0])
        self.assertEqual(self.files(), before)

    def test_sessions_are_limited_and_objects_too(self):
        with self.server("--max-sessions", "2", "--max-objects", "1") as server:
            agents = [HttpAgent(server) for _ in range(2)]
            self.assertEqual(HttpAgent(server).status, 503)
            self.assertTrue(agents[0].call("open")[0])
            self.assertTrue(agents[0].call("append", object="x", model="cube.obj")[0])
            self.assertFalse(agents[0].call("append", object="y", model="cube.obj")[0])

    def test_calls_at_once_are_answered(self):
        with self.server("--threads", "4") as server:
            agent = HttpAgent(server)
            agent.call("open")
            agent.call("append", object="a", model="cube.obj")

            def look(number):
                call = {"name": "look", "arguments": {"width": 160, "height": 120}}
                status, answer, _ = agent.ask({"jsonrpc": "2.0", "id": number, "method": "tools/call", "params": call})
                self.assertEqual((status, answer["id"]), (200, number))
                return answer["result"]["content"][0]["text"]

            agent.call("put", object="a", position=[0, 0, 1])
            with ThreadPoolExecutor(4) as pool:
                texts = list(pool.map(look, range(100, 108)))
            self.assertTrue(any(text.startswith("a picture") for text in texts), texts)
            for text in texts:
                self.assertRegex(text, r"a picture|another call of this session is under way\nNext: .+\.$")
            cancel = {"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 1}}
            self.assertEqual(agent.ask(cancel)[:2], (202, None))


if __name__ == "__main__":
    main_if_built()
