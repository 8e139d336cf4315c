"""The server `trivet serve` under load: clients that misbehave, signals, a full queue."""
import contextlib
import os
import random
import signal
import statistics
import threading
import time

from program import SLAB, put
from serving import Served, main_if_built

EFFORT = float(os.environ.get("TRIVET_TEST_EFFORT", "1"))


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

        with self.server("--request-seconds", 30) as server:
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

    def many_puts(self, count=300):
        """A start, and a line of many operations on it."""
        names = ["c%d" % i for i in range(count)]
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
        """What is computed, and what waits behind it."""
        line, answers = self.many_puts(1000), []
        with self.server("--threads", 1) as server:
            threads = [threading.Thread(
                target=lambda s=session: answers.append(server.ask("POST", s, line)))
                for session in [server.open() for _ in range(3)]]
            for thread in threads:
                thread.start()
            while self.load(server) != (2, 1):
                self.assertEqual(answers, [])
            server.process.send_signal(signal.SIGTERM)
            with self.assertRaises(ConnectionRefusedError):  # once it has been taken: two at a time are one
                while True:
                    with server.socket():
                        self.assertEqual(answers, [])
            self.assertEqual(server.end(), 0)
            for thread in threads:
                thread.join()
        self.assertEqual([answer["status"] for _, answer in answers], ["cancelled"] * 3)

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


if __name__ == "__main__":
    main_if_built()
