"""Agents over the Model Context Protocol: the protocol, its tools, hostile lines, and a table that an agent lays."""
import json
import math
import os
import random
import re
import unittest
from pathlib import Path

from mcp_agent import Agent
from program import SOURCE_DIR, Case, box_obj, main

CASES = Path(SOURCE_DIR) / "tests" / "core" / "io" / "foreign" / "cases"
SUNK = """<mujoco><worldbody><geom type="plane" size="2 2 .1"/>
<body name="table" pos="0 0 .2"><geom type="box" size=".5 .5 .2"/></body>
<body name="a" pos="0 0 .447"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
</worldbody></mujoco>
"""


class McpCase(Case):
    def agent(self, *arguments):
        agent = Agent(self.folder, *arguments)
        self.addCleanup(lambda: agent.process.poll() is None and agent.end())
        return agent

    def done(self, agent, tool, **arguments):
        done, text, data, _ = agent.call(tool, **arguments)
        self.assertTrue(done, text)
        return text, data

    def not_done(self, agent, tool, says, **arguments):
        """Expects a refusal with these words and a next step."""
        done, text, data, _ = agent.call(tool, **arguments)
        self.assertFalse(done, text)
        self.assertIn(says, text)
        self.assertRegex(text, r"\nNext: .+\.$")
        return data


class Protocol(McpCase):
    def test_a_client_gets_its_version_or_the_latest(self):
        agent = self.agent()
        for asked, given in (("2024-11-05", "2024-11-05"), ("2025-03-26", "2025-03-26"), ("2025-06-18", "2025-06-18"), ("1999-01-01", "2025-11-25")):
            answer = agent.request("initialize", protocolVersion=asked, capabilities={},
                                   clientInfo={"name": "test", "version": "1"})["result"]
            self.assertEqual(answer["protocolVersion"], given)
            self.assertEqual(answer["capabilities"], {"tools": {}})
            self.assertEqual(answer["serverInfo"]["name"], "trivet")
        agent.send({"jsonrpc": "2.0", "method": "notifications/initialized"})
        self.assertEqual(agent.request("ping")["result"], {})
        self.assertEqual(agent.end(), 0)

    def test_tools_say_what_they_take(self):
        agent = self.agent()
        tools = {tool["name"]: tool for tool in agent.request("tools/list")["result"]["tools"]}
        self.assertLessEqual({"open", "list", "look", "check", "append", "put", "arrange", "move_joint", "mend", "undo",
                              "save"}, set(tools))
        for tool in tools.values():
            self.assertEqual(tool["inputSchema"]["type"], "object")
            self.assertNotIn("$ref", json.dumps(tool))
            self.assertTrue(tool["description"].endswith("."), tool["description"])
        put = tools["put"]["inputSchema"]
        self.assertEqual(put["required"], ["object"])
        self.assertLessEqual({"object", "position", "rotation", "on", "at", "keep"}, set(put["properties"]))
        self.assertEqual(put["properties"]["position"]["maxItems"], 3)
        relations = tools["arrange"]["inputSchema"]["properties"]["relations"]["items"]["properties"]["is"]["enum"]
        self.assertLessEqual({"on", "in", "left_of", "row"}, set(relations))
        self.assertTrue(tools["look"]["annotations"]["readOnlyHint"])
        self.assertLess(len(json.dumps(list(tools.values()))), 32_000)

    def test_every_key_of_a_schema_is_accepted_by_its_operation(self):
        schema = json.loads(self.trivet("schema", "layout")[0])
        known = {}
        for operation in schema["properties"]["operations"]["items"]["oneOf"]:
            if "properties" in operation:
                known.setdefault(operation["properties"]["op"]["const"], set()).update(operation["properties"])
        for tool in self.agent().request("tools/list")["result"]["tools"]:
            if tool["name"] == "move_joint":  # of scenes of others, too, whose joints have names of their own
                self.assertEqual(set(tool["inputSchema"]["properties"]), {"joint", "to", "by"})
            elif tool["name"] in known:
                own = {"seconds"} if tool["name"] in ("mend", "settle") else set()  # no step of a layout depends on time
                keys = set(tool["inputSchema"]["properties"])
                self.assertEqual(keys - own | {"op"}, known[tool["name"]], tool["name"])
                self.assertLessEqual(own, keys)

    def test_reasons_name_keys_that_tools_have(self):
        agent = self.agent()
        self.done(agent, "open")
        for arguments, says in (({}, "required: object"), ({"object": "a", "onto": "b"}, "accepted: object, ")):
            reason = self.not_done(agent, "push", says, **arguments)["reason"]
            self.assertNotIn("op, ", reason)

    def test_lines_that_are_no_requests(self):
        agent = self.agent()
        for line, code in ((b"{", -32700), (b"[]", -32600), (b"1", -32600), (b'{"id": 1}', -32600),
                           (b'{"jsonrpc": "2.0", "id": [], "method": "ping"}', -32600),
                           (b'{"jsonrpc": "2.0", "id": 1, "method": "nothing"}', -32601),
                           (b'{"jsonrpc": "2.0", "id": 1, "method": "ping", "params": []}', -32602),
                           (b'{"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": {"name": "rm"}}', -32602),
                           (b"\xff\xfe\x00", -32700), (b"[" * 1000, -32700),
                           (b'{"a": 1, "a": 2}', -32700), (b" " * 2_000_000, -32600)):
            agent.send(line)
            answer = agent.receive()
            self.assertEqual(answer["error"]["code"], code, line[:80])
        agent.send(b"")
        agent.send({"jsonrpc": "2.0", "id": 7, "result": {}})  # an answer to nothing
        agent.send({"jsonrpc": "2.0", "method": "notifications/unknown"})
        self.assertEqual(agent.request("ping")["result"], {})
        self.assertEqual(agent.end(), 0)

    def test_changed_bytes_never_crash(self):
        agent = self.agent()
        self.done(agent, "open")
        self.done(agent, "append", object="a", model="cube.obj")
        calls = [{"name": "put", "arguments": {"object": "a", "position": [0, 0, 1], "rotation": [1, 0, 0, 0]}},
                 {"name": "put", "arguments": {"object": "a", "on": "floor", "at": [0.5, 0.5], "keep": 0.1}},
                 {"name": "look", "arguments": {"eye": [1, 1, 1], "target": [0, 0, 0], "width": 16, "height": 16}},
                 {"name": "list", "arguments": {"what": "files", "first": 3}},
                 {"name": "mend", "arguments": {"tolerance": 0.01, "only": ["a"]}},
                 {"name": "arrange", "arguments": {"relations": [{"is": "on", "a": "a", "b": "floor"}]}}]
        generator = random.Random(5)
        for n in range(400):
            line = bytearray(json.dumps({"jsonrpc": "2.0", "id": n, "method": "tools/call",
                                         "params": calls[n % len(calls)]}).encode())
            for _ in range(generator.randrange(1, 4)):
                at = generator.randrange(len(line))
                line[at:at + generator.randrange(3)] = bytes([generator.choice(b'0123456789eE-[]{}",:ax \x00\xc3')])
            agent.send(bytes(line).replace(b"\n", b" "))
            agent.send({"jsonrpc": "2.0", "id": "after", "method": "ping"})
            while agent.receive().get("id") != "after":
                pass
        self.assertEqual(agent.end(), 0)

    def test_a_request_that_is_cancelled_has_no_answer(self):
        agent = self.agent()
        self.done(agent, "open")
        self.done(agent, "append", object="a", model="cube.obj")
        call = {"name": "put", "arguments": {"object": "a", "position": [0, 0, 1]}}
        lines = [{"jsonrpc": "2.0", "id": n, "method": "tools/call", "params": call} for n in range(100, 400)]
        lines += [{"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 399}},
                  {"jsonrpc": "2.0", "id": "last", "method": "ping"}]
        agent.send("\n".join(map(json.dumps, lines)).encode())
        answered = []
        while not answered or answered[-1] != "last":
            answered.append(agent.receive()["id"])
        self.assertEqual(answered, [*range(100, 399), "last"])

    def test_a_missing_folder(self):
        self.refused("mcp", "nowhere", says=("nowhere", "accepted: a folder"))


class Files(McpCase):
    def test_only_the_folder_is_read_and_written(self):
        self.write("secret.obj", box_obj(1, 1, 1))
        os.mkdir(self.path("in"))
        os.rename(self.path("cube.obj"), self.path("in/cube.obj"))
        os.symlink(self.path("secret.obj"), self.path("in/link.obj"))
        agent = self.agent("in")
        self.done(agent, "open")
        for name in ("../secret.obj", self.path("secret.obj"), "link.obj", "nothing.obj", "."):
            self.not_done(agent, "append", "accepted: a file in the folder", object="x", model=name)
            self.not_done(agent, "open", "accepted: a file in the folder", file=name)
        self.done(agent, "append", object="a", model="cube.obj")
        self.done(agent, "put", object="a", position=[0, 0, 1])
        self.not_done(agent, "save", "accepted: a file in the folder", file="../out.glb")
        self.not_done(agent, "save", "nothing is overwritten", file="cube.obj")
        self.not_done(agent, "save", "accepted: a file name ending in .glb", file="out.txt")
        self.done(agent, "save", file="out.glb")
        self.done(agent, "save", file="out.glb")
        self.assertEqual(self.files(), ["in/cube.obj", "in/link.obj", "in/out.glb", "secret.obj", "slab.obj"])
        self.trivet("check", "in/out.glb")
        again = self.agent("in")
        self.not_done(again, "save", "no scene is open", file="new.glb")
        self.done(again, "open", file="out.glb")
        self.not_done(again, "save", "nothing is overwritten", file="out.glb")

    def test_files_are_listed(self):
        self.write("more/a.glb", b"")
        self.write("more/notes.txt", "no model")
        text, data = self.done(self.agent(), "list", what="files")
        self.assertEqual(data, {"files": ["cube.obj", "more/a.glb", "slab.obj"], "more": False})


class OthersScenes(McpCase):
    def test_a_drawer_is_opened_filled_closed_and_written_in_place(self):
        self.write("drawer.xml", (CASES / "drawer.xml").read_bytes())
        agent = self.agent()
        self.done(agent, "open", file="drawer.xml")
        text, verdict = self.done(agent, "check")
        self.assertFalse(verdict["ok"])
        self.assertIn("2 mm deep", text)
        self.assertIn("Next: `mend`", text)
        text, mended = self.done(agent, "mend")
        self.assertEqual(len(mended["moved"]), 2)
        self.assertTrue(self.done(agent, "check")[1]["ok"])
        joints = {joint["joint"]: joint for joint in self.done(agent, "list", what="joints")[1]["joints"]}
        self.assertEqual(set(joints), {"slide", "lid"})
        first = joints["slide"]["value"]
        _, move = self.done(agent, "move_joint", joint="slide", to="lower")
        self.assertEqual((move["end"], move["carried"]), ("reached", ["in the drawer"]))
        self.assertEqual(self.done(agent, "list", what="joints")[1]["joints"][0]["value"], move["value"])
        self.assertTrue(self.done(agent, "check")[1]["ok"])
        self.done(agent, "undo")
        self.assertEqual(self.done(agent, "list", what="joints")[1]["joints"][0]["value"], first)
        self.done(agent, "redo")
        self.assertEqual(self.done(agent, "list", what="joints")[1]["joints"][0]["value"], move["value"])
        self.not_done(agent, "move_joint", '"slide", "lid"', joint="door", to=1)
        self.not_done(agent, "append", "keeps its objects", object="x", model="cube.obj")
        self.not_done(agent, "save", "ending in .xml", file="closed.glb")
        self.done(agent, "save", file="closed.xml")
        self.assertIn("at %.6g m" % move["value"], self.trivet("joint", "closed.xml")[0])
        self.trivet("check", "closed.xml")

    def test_a_sunk_box_is_mended_put_elsewhere_and_only_its_place_changes(self):
        self.write("sunk.xml", SUNK)
        agent = self.agent()
        self.done(agent, "open", file="sunk.xml")
        self.done(agent, "mend")
        self.done(agent, "put", object="a", position=[0.3, 0.2, 0.8])
        self.done(agent, "save", file="out.xml")
        before, after = SUNK.splitlines(), self.read("out.xml").decode().splitlines()
        self.assertEqual([i for i, (a, b) in enumerate(zip(before, after)) if a != b], [2])
        self.trivet("check", "out.xml")

    def test_undo_takes_a_mended_scene_back_to_its_bits(self):
        self.write("sunk.xml", SUNK)
        agent = self.agent()
        self.done(agent, "open", file="sunk.xml")
        self.done(agent, "mend")
        self.done(agent, "undo")
        self.done(agent, "save", file="same.xml")
        self.assertEqual(self.read("same.xml"), self.read("sunk.xml"))


def around(count, radius_x, radius_y):
    """Places at a table, and the way each looks."""
    for i in range(count):
        angle = 2 * math.pi * i / count
        yield radius_x * math.cos(angle), radius_y * math.sin(angle)


class LayingTheTable(McpCase):
    """A script that plays an agent: it knows nothing but the answers, and after a refusal does what they say."""

    def setUp(self):
        super().setUp()
        self.trivet("demo", "breakfast", "-o", "demo.glb", "--export", "models", "--quiet")
        self.refusals = 0

    def put_somewhere(self, agent, name, x, y):
        """As told after each refusal: another place by itself, at last anywhere."""
        tries = ({"position": [x, y, 0.5]}, {"on": "table", "at": [x, y], "keep": 0.005},
                 {"on": "table", "at": "anywhere", "keep": 0.005})
        for arguments in tries:
            done, text, data, _ = agent.call("put", object=name, **arguments)
            if done and re.search(re.escape('"%s": stable on "table"' % name), text):
                return
            if done:
                self.done(agent, "undo")
            else:
                self.assertRegex(text, r"\nNext: .+\.$")
            self.refusals += 1
        self.fail(text)

    def test_from_an_empty_room_to_a_laid_table(self):
        agent = self.agent("models")
        self.done(agent, "open")
        files = self.done(agent, "list", what="files")[1]["files"]
        self.assertIn("table.glb", files)
        self.not_done(agent, "put", 'no object "table"', object="table", position=[0, 0, 1])
        self.refusals += 1
        self.done(agent, "append", object="table", model="table.glb")
        self.done(agent, "put", object="table", position=[0, 0, 0.2])
        self.done(agent, "fix", object="table")
        top = self.done(agent, "list")[1]["objects"][0]["upper"]
        self.done(agent, "append", object="jug", model="jug.glb")
        self.not_done(agent, "arrange", "none of the things", relations=[{"is": "on", "a": "table", "b": "floor"}])
        self.refusals += 1
        self.done(agent, "arrange", relations=[{"is": "on", "a": "jug", "b": "table"}])
        for guest, (x, y) in enumerate(around(4, 0.75 * top[0], 0.6 * top[1])):
            names = {kind: "%s %d" % (kind, guest + 1) for kind in ("plate", "cup", "spoon")}
            for kind, name in names.items():
                self.done(agent, "append", object=name, model=kind + ".glb")
            self.put_somewhere(agent, names["plate"], x, y)
            self.put_somewhere(agent, names["cup"], 0.6 * x, 0.6 * y)
            self.put_somewhere(agent, names["spoon"], x, y)
        self.done(agent, "append", object="apple", model="apple.glb")
        self.done(agent, "put", object="apple", on="plate 1", at="anywhere")
        text, verdict = self.done(agent, "check")
        self.assertTrue(verdict["ok"], text)
        self.assertEqual(verdict["objects"], 15)
        self.assertGreater(self.refusals, 3)
        _, _, _, picture = agent.call("look", view="corner", width=64, height=48)
        self.assertTrue(picture.startswith(b"\x89PNG"))
        self.done(agent, "save", file="laid.glb")
        self.assertEqual(agent.end(), 0)
        self.trivet("check", "models/laid.glb")

    def test_views_differ_and_frame_what_is_asked_for(self):
        agent = self.agent("models")
        self.done(agent, "open")
        self.done(agent, "append", object="cup", model="cup.glb")
        self.not_done(agent, "look", "not in the scene", object="cup")
        self.done(agent, "put", object="cup", position=[0, 0, 1])
        pictures = {agent.call("look", view=view, width=32, height=24)[3]
                    for view in ("corner", "above", "front", "back", "left", "right")}
        pictures.add(agent.call("look", object="cup", width=32, height=24)[3])
        pictures.add(agent.call("look", eye=[1, 1, 1], target=[0, 0, 0], width=32, height=24)[3])
        self.assertEqual(len(pictures), 8)
        self.not_done(agent, "look", "a whole number of pixels", width=0.5)
        self.not_done(agent, "look", "accepted", width=100_000)
        self.not_done(agent, "look", '"corner"', view="beyond")


if __name__ == "__main__":
    main()
