"""Offscreen pictures. Their content is tested in tests/gpu."""
import subprocess

from program import PROGRAM, Case, main


class Pictures(Case):
    def setUp(self):
        super().setUp()
        # Skipped with a note without EGL.
        result = subprocess.run([PROGRAM, "render", "cube.obj", "-o", "try.png", "--samples", "1",
                                 "--width", "8", "--height", "8"], cwd=self.folder,
                                capture_output=True)
        if result.returncode == 3:
            self.skipTest(result.stderr.decode())

    def size_of(self, name):
        data = self.read(name)
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        return int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")

    def test_render_a_scene_and_a_model(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb")
        for name, more in (("s.glb", ()), ("cube.obj", ()),
                           ("s.glb", ("--camera", 1, -1, 1, 0, 0, 0, "--fov", 40))):
            self.trivet("render", name, "-o", "p.png", "--width", 160, "--height", 90,
                        "--samples", 2, *more)
            self.assertEqual(self.size_of("p.png"), (160, 90))
            self.assertGreater(len(self.read("p.png")), 1000)

    def test_demo_has_its_own_camera(self):
        self.trivet("demo", "spoon-saucer", "-o", "d.glb", "--picture", "d.png")
        self.assertEqual(self.size_of("d.png"), (1280, 720))
        self.trivet("render", "d.glb", "-o", "p.png", "--fov", 29,
                    "--camera", 0.10, -0.27, 0.25, 0.012, 0, 0.008)
        self.assertEqual(self.read("d.png"), self.read("p.png"))

    def test_a_bad_camera(self):
        self.refused("render", "cube.obj", "-o", "p.png", "--camera", 0, 0, 0, 0, 0, 0, says="camera")


if __name__ == "__main__":
    main()
