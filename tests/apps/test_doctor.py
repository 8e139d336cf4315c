"""`trivet doctor`: what a machine lacks for batches."""
import json
import os
import resource
import subprocess

from program import PROGRAM, Case, main


class Doctor(Case):
    def examine(self, *arguments, status=0, **more):
        result = subprocess.run([PROGRAM, "doctor", "--json", *map(str, arguments)],
                                cwd=self.folder, capture_output=True, text=True, check=False, **more)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        found = json.loads(result.stdout)
        self.assertEqual(found["ok"], status == 0)
        return {c["check"]: (c["verdict"], c["text"]) for c in found["checks"]}

    def test_a_folder_that_will_do(self):
        before = self.files()
        found = self.examine("--out", ".", "--memory-mb", 1, "--disk-mb", 1)
        for check in ("importer", "memory", "files", "clock", "disk"):
            self.assertEqual(found[check][0], "ok", found)
        self.assertIn(found["writing"][0], ("ok", "note"))
        self.assertEqual(self.files(), before)
        out, _ = self.trivet("doctor", "--memory-mb", 1)
        self.assertIn("ok       memory", out)

    def test_what_is_lacking_is_named(self):
        for arguments, check, says in (
                (("--memory-mb", 1e9), "memory", "1000000000 MB needed"),
                (("--out", ".", "--disk-mb", 1e9), "disk", "1000000000 MB needed"),
                (("--out", "none"), "folder", "none is no folder"),
                (("--out", "cube.obj"), "folder", "cube.obj is no folder"),
                (("--out", "/proc"), "writing", "/proc")):
            verdict, text = self.examine(*arguments, status=3)[check]
            self.assertEqual(verdict, "lacking", arguments)
            self.assertIn(says, text)

    def test_a_missing_importer(self):
        environment = {**os.environ, "TRIVET_IMPORTER": self.path("none")}
        found = self.examine(status=3, env=environment)
        self.assertEqual(found["importer"][0], "lacking")

    def test_what_confines_the_importer(self):
        verdict, text = self.examine()["sandbox"]
        self.assertIn("privileges", text)
        self.assertEqual(verdict, "ok" if "landlock, seccomp" in text.split(";")[0] else "note")
        for script, says in (("true", "does not say"), ("printf 'TRIVET-IMPORTER-1\\n\\000' >&3", "only; not here: landlock"),
                             ("printf 'TRIVET-IMPORTER-1\\n\\003' >&3", "landlock, seccomp; not here: network")):
            verdict, text = self.examine(env={**os.environ, **self.importer(script)})["sandbox"]
            self.assertEqual(verdict, "ok" if "003" in script else "note")
            self.assertIn(says, text)

    def test_few_files(self):
        found = self.examine(status=3, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_NOFILE, (40, 40)))
        self.assertEqual(found["files"], ("lacking", "40 may be open, 64 needed (ulimit -n)"))

    def test_graphics_are_needed_when_asked_for(self):
        verdict, _ = self.examine()["graphics"]
        self.examine("--gpu", status=0 if verdict == "ok" else 3)


if __name__ == "__main__":
    main()
