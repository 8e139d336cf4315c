"""Pushing blocks to a goal, as environments of reinforcement learning are made: reset() to a seed, then step()."""
import numpy as np

import trivet

VERTICES = [[i & 1, i >> 1 & 1, i >> 2] for i in range(8)]
FACES = [[s[0], s[k], s[k + 1]] for s in ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
         for k in (1, 2)]


class PushBlocks:
    """Blocks of 6 cm lie on the floor; the first one is to be within 5 cm of the origin.

    Has the methods of a ``gymnasium.Env``, and needs no package beside trivet. An action is (block, angle, metres); an
    observation is the blocks' (n, 3) positions. A push that is refused changes nothing.
    """

    def __init__(self, num_blocks=3, max_steps=20):
        self.num_blocks, self.max_steps = num_blocks, max_steps
        self.shape = trivet.Shape(VERTICES, FACES)

    def reset(self, *, seed=None, options=None):
        """Another scene for every seed, the same one for the same seed on any machine."""
        rng = np.random.default_rng(seed)
        self.scene, self.blocks, self.num_steps = trivet.Scene(), [], 0
        for i in range(self.num_blocks):
            block = self.scene.add(f"block{i}", self.shape, scale=0.06)
            while not block.try_put([*rng.uniform(-0.3, 0.3, 2), 0.5]):
                pass
            self.blocks.append(block)
        return self.observation(), {}

    def step(self, action):
        block, angle, metres = action
        pushed = self.blocks[int(block)].try_push([np.cos(angle), np.sin(angle)], float(metres))
        self.num_steps += 1
        distance = self.distance()
        return self.observation(), -distance, distance < 0.05, self.num_steps >= self.max_steps, {"refused": not pushed}

    def observation(self):
        return np.array([block.position for block in self.blocks])

    def distance(self):
        centre = self.blocks[0].position + 0.03
        return float(np.hypot(centre[0], centre[1]))


def push_home(env):
    """A policy: push the first block towards the origin."""
    centre = env.blocks[0].position + 0.03
    return 0, np.arctan2(-centre[1], -centre[0]), min(env.distance(), 0.1)


if __name__ == "__main__":
    env = PushBlocks()
    for seed in range(3):
        env.reset(seed=seed)
        done = cut = False
        while not (done or cut):
            _, reward, done, cut, info = env.step(push_home(env))
        print(f"seed {seed}: {env.num_steps} pushes, {'home' if done else 'not home'}")
