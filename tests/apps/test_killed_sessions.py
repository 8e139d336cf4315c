"""Sessions that are killed at random moments, and what their journals restore."""
import json
import os
import random
import signal
import time

from live_session import Live, SessionCase
from program import main, put

KILLS = max(4, int(200 * float(os.environ.get("TRIVET_TEST_EFFORT", "1"))))


class KilledSessions(SessionCase):
    def some_line(self, chance, names, step):
        kind = chance.random()
        if kind < 0.15:
            return {"undo": True}
        if kind < 0.25:
            return {"redo": True}
        if kind < 0.35:
            names.append("n%d" % step)
            return {"op": "append", "object": names[-1], "model": "cube.obj"}
        if kind < 0.4:
            return {"op": "lock", "object": chance.choice(names)}
        if kind < 0.45:
            return {"op": "unlock", "object": chance.choice(names)}
        if kind < 0.5:
            return {"op": "delete", "object": chance.choice(names)}
        if kind < 0.6:
            return {"save": "saved.glb"}
        return put(chance.choice(names), chance.uniform(-.2, .2), chance.uniform(-.2, .2), 1)

    def kill_one(self, seed, layout):
        """@return the states that it acknowledged."""
        chance = random.Random(seed)
        for name in ("j", "j.start", "saved.glb"):
            if os.path.exists(self.path(name)):
                os.remove(self.path(name))
        live = Live(self.folder, layout, "--journal", "j")
        acknowledged, names = [live.start["state"]], ["a", "b"]
        # Lines are sent ahead, so that the kill interrupts the work.
        lines = [self.some_line(chance, names, i) for i in range(60)]
        live.process.stdin.write("".join(json.dumps(line) + "\n" for line in lines))
        live.process.stdin.flush()
        answers = [live.process.stdout.readline() for _ in range(chance.randrange(16))]
        time.sleep(chance.uniform(0, 0.005))
        live.process.kill()
        self.assertEqual(live.process.wait(), -signal.SIGKILL)
        answers += live.process.stdout.readlines()
        for answer in answers:
            if not answer.endswith("\n"):
                break
            answer = json.loads(answer)
            if answer["status"] == "ok":
                acknowledged.append(answer["state"])
        live.process.stdout.close()
        live.process.stderr.close()
        try:
            live.process.stdin.close()
        except BrokenPipeError:
            pass
        return acknowledged

    def test_kill_at_any_moment(self):
        layout = self.start_layout()
        num_steps, num_one_more = 0, 0
        for seed in range(KILLS):
            acknowledged = self.kill_one(seed, layout)
            num_steps += len(acknowledged) - 1
            whole = self.read("j").count(b"\n")
            live = Live(self.folder, "--journal", "j")
            # Everything acknowledged, and at most one step that was on disk but not yet
            # acknowledged.
            self.assertIn(whole - len(acknowledged), (0, 1), "seed %d" % seed)
            if whole == len(acknowledged):
                self.assertEqual(live.start["state"], acknowledged[-1], "seed %d" % seed)
            num_one_more += whole > len(acknowledged)
            # The restored session works, and its saved file is complete.
            self.assertEqual(live.ask(op="unlock", object="slab")["status"], "ok", "seed %d" % seed)
            self.assertEqual(live.end(), 0)
            if os.path.exists(self.path("saved.glb")):
                self.trivet("info", "saved.glb")
        self.assertGreater(num_steps, KILLS)  # those whose answers were waited for, at least
        print("%d sessions killed, %d steps acknowledged, %d committed but not acknowledged"
              % (KILLS, num_steps, num_one_more))


if __name__ == "__main__":
    main()
