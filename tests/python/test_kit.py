"""The testing kit: assertions that name the stone; strategies, their shrinking, the planted mistake where Hypothesis and pytest
are installed."""
import os
import random
import subprocess
import sys
import tempfile
import unittest

import stonepack
from stonepack import scenes
from stonepack.testing import Fails, Undecided, assert_build_order, assert_falls, assert_stands

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLES = os.path.join(HERE, "..", "..", "port", "python", "examples")
sys.path.insert(0, EXAMPLES)
try:
    import hypothesis
    import pytest
    from hypothesis import strategies as st

    import packer
    from stonepack import strategies as stones
except ImportError:
    hypothesis = None


class Assertions(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        os.environ["STONEPACK_FAILURES"] = self.folder.name
        self.addCleanup(os.environ.pop, "STONEPACK_FAILURES")

    def fails(self, words, call, *args, kind=Fails, **more):
        with self.assertRaises(kind) as told:
            call(*args, **more)
        self.assertEqual(os.listdir(self.folder.name), [])          # nothing is drawn before someone reads it
        text = str(told.exception)
        for word in words:
            self.assertIn(word, text)
        self.assertEqual(sorted(name[-4:] for name in os.listdir(self.folder.name)), [".obj", ".svg"])
        left = stonepack.read(os.path.join(self.folder.name, [n for n in os.listdir(self.folder.name) if ".obj" in n][0]))
        self.assertEqual(left.check().verdict, told.exception.result.verdict)
        return told.exception

    def test_a_scene_that_falls_names_the_stone(self):
        tower = scenes.stack([(1, 1, 1)] * 3, [(0, 0), (0.4, 0), (0.4, 0)])
        self.fails(["'s3' falls", "s3, s2", "'s1' - 's2'", "verified, final", "scenes.stack(", ".svg"], assert_stands, tower)
        self.assertTrue(assert_falls(tower, margin=1e-3).final)

    def test_a_scene_that_stands_does_not_fall(self):
        self.fails(["the scene stands"], assert_falls, scenes.wall(3, 3))

    def test_a_scene_that_barely_stands_has_no_margin(self):
        barely = scenes.stack([(1, 1, 1)] * 2, [(0, 0), (0.49, 0)])
        self.assertTrue(assert_stands(barely).stable)
        self.fails(["leans by 0.05", "'s2' falls"], assert_stands, barely, margin=0.05)
        self.assertTrue(assert_stands(scenes.wall(4, 4), margin=0.05).stable)

    def test_a_scene_that_barely_falls_has_no_margin(self):
        self.fails(["but by", "not 0.1"], assert_falls, scenes.stack([(1, 1, 1)] * 2, [(0, 0), (0.501, 0)]), margin=0.1)

    def test_a_tie_is_neither(self):
        s = scenes.stack([(1, 1, 1)] * 2, [(0, 0), (0, 0)])
        with self.assertRaises(Undecided):
            assert_stands(s, budget=1)
        with self.assertRaises(Undecided):
            assert_falls(s, budget=1)

    def test_a_mistake_in_a_test_is_no_failure_of_what_it_tests(self):
        wall = scenes.wall(2, 2)
        light = wall.copy()
        light.gravity = (0, 0, 0)
        for words, call in (("a scene is wanted, not None", lambda: assert_stands(None)),
                            ("a scene is wanted, not <stable>", lambda: assert_falls(wall.check())),
                            ("a scene is wanted", lambda: assert_build_order([wall])),
                            ("margin: a share from 0", lambda: assert_stands(wall, margin=-0.1)),
                            ("margin: a share from 0", lambda: assert_falls(wall, margin=float("nan"))),
                            ("gravity is 0", lambda: assert_stands(light, margin=0.01)),
                            ("no block is called 'prop'", lambda: assert_build_order(wall, held="prop"))):
            with self.assertRaisesRegex(stonepack.SceneError, words):
                call()
        self.assertTrue(assert_stands(light).stable)

    def test_strategies_without_hypothesis_say_what_they_need(self):
        code = "import sys; sys.modules['hypothesis'] = None; import stonepack.testing, stonepack.strategies"
        told = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True,
                              env=dict(os.environ, PYTHONPATH=os.path.dirname(os.path.dirname(stonepack.__file__))))
        self.assertIn("needs Hypothesis, pip install hypothesis", told.stderr)

    def test_a_build_order_names_step_stone_and_prop(self):
        arch = stonepack.read("tests/scenes/arch.obj")
        self.fails(["step 3 of 15, laying 'b3'", "order     b1, b2, b3", "to hold   b2"], assert_build_order, arch)
        wall = scenes.wall(3, 3)
        self.assertEqual(len(assert_build_order(wall)), len(wall) - 1)
        for order, words in ((["c1b1"], "missing"), (["c1b1"] + wall.names[1:], "too often c1b1")):
            with self.assertRaisesRegex(AssertionError, words):
                assert_build_order(wall, order)

    def test_what_is_held_does_not_fall(self):
        arch = stonepack.read("tests/scenes/arch.obj")
        props = [b.name for b in arch.blocks if not b.fixed]
        self.assertEqual(len(assert_build_order(arch, held=props)), 15)

    def test_a_scene_that_was_changed_is_made_by_no_recipe(self):
        wall = scenes.wall(2, 2)
        wall.check()
        self.assertEqual(repr(wall), repr(wall.copy()))
        self.assertTrue(repr(wall).startswith("stonepack.scenes.wall("))
        other = wall.copy()
        other.gravity = (1, 0, -9)
        wall.box((1, 1, 1), (5, 5, 5))
        self.assertEqual((wall.recipe, other.recipe), (None, None))

    def test_a_part_is_the_scene_without_the_rest(self):
        wall = scenes.wall(3, 3)
        wall.load("c2b1", (0, 0, -500), live=True)
        part = wall.part(["ground", "c1b1", "c1b2", "c2b1"])
        self.assertEqual(part.names, ["ground", "c1b1", "c1b2", "c2b1"])
        self.assertEqual(len(part.joints), 5)
        self.assertTrue(part.check().stable)
        self.assertTrue(wall.part(["ground", "c2b1"]).check().unstable)


    def test_what_is_held_let_go_in_what_the_failure_told(self):
        s = stonepack.Scene(mu=0.6)
        s.box((2, 2, 0.2), (0, 0, -0.1), name="ground", fixed=True)
        s.box((0.4, 0.4, 0.4), (1.1, 0, 0.2), name="prop")          # falls unless it is held
        s.box((0.4, 0.4, 0.4), (-0.5, 0, 0.2), name="a")
        s.box((0.4, 0.4, 0.4), (-0.25, 0, 0.6), name="b")
        with self.assertRaises(AssertionError) as told:
            assert_build_order(s, ["prop", "a", "b"], held=["prop"])
        self.assertNotIn("'prop' first", str(told.exception))
        self.assertIn("'b' falls", str(told.exception))


@unittest.skipUnless(hypothesis, "no Hypothesis, no pytest")
class Strategies(unittest.TestCase):
    def test_a_stack_went_beyond_its_largest_offset(self):
        def inside(scene):
            for below, block in zip(scene.blocks, scene.blocks[1:]):
                shapes = [scene.mesh(b.name)[0] for b in (below, block)]
                for k in (0, 1):
                    least = min(max(p[k] for p in shape) - min(p[k] for p in shape) for shape in shapes)
                    self.assertLessEqual(abs(block.centroid[k] - below.centroid[k]), 0.5 * least + 1e-12)
        self.each(stones.stacks(max_offset=0.5), inside, 100)
        self.each(stones.lengths(0.0504, 0.06), lambda x: self.assertGreaterEqual(x, 0.0504), 20)

    def each(self, strategy, claim, examples=40):
        @hypothesis.settings(database=None, deadline=None, max_examples=examples, derandomize=True,
                             suppress_health_check=list(hypothesis.HealthCheck))
        @hypothesis.given(strategy)
        def ask(value):
            claim(value)
        ask()

    def test_every_strategy_makes_what_it_says(self):
        def closed(shape):
            s = stonepack.Scene()
            s.add(shape, name="block")
            self.assertGreater(s.blocks[0].mass, 0)

        def same_again(scene):
            self.assertEqual(eval(repr(scene)).check().verdict, scene.check().verdict)

        self.each(stones.blocks(), closed)
        for strategy in (stones.stacks(), stones.walls(), stones.rubble()):
            self.each(strategy, same_again, 25)
        self.each(stones.stacks(max_offset=0.3, standing=True), assert_stands, 25)
        self.each(stones.stacks(min_blocks=2, standing=False), assert_falls, 25)
        self.each(stones.walls(max_missing=6, standing=False), assert_falls, 10)
        wall = scenes.wall(2, 2)
        self.each(stones.orders(wall), lambda order: self.assertEqual(sorted(order), sorted(wall.names[1:])))

    def smallest(self, strategy, condition):
        how = hypothesis.settings(database=None, max_examples=2000, deadline=None)
        return hypothesis.find(strategy, condition, settings=how, random=random.Random(1))

    def test_stacks_shrink_to_the_fewest_stones(self):
        """No stone alone on its own size can fall, so two are the fewest; of three the top one is asked to stay."""
        found = self.smallest(stones.stacks(max_offset=0.6, mu=1.0), lambda s: s.check().unstable)
        self.assertEqual(len(found), 2)
        found = self.smallest(stones.stacks(max_offset=0.45, mu=1.0), lambda s: s.check().unstable)
        self.assertEqual(len(found), 3)

    def test_walls_shrink_to_one_missing_brick(self):
        found = self.smallest(stones.walls(mu=0.7), lambda s: s.check().unstable)
        self.assertEqual(found.recipe.count("), (") + found.recipe.count("[("), 1)

    def test_orders_shrink_to_one_stone_out_of_order(self):
        wall = scenes.wall(2, 3)
        found = self.smallest(stones.orders(wall), lambda order: not all(step.stable for step in wall.sequence(order)))
        self.assertEqual(len(found), 5)
        moved = [k for k, (a, b) in enumerate(zip(found, wall.names[1:])) if a != b]
        self.assertLessEqual(len(moved), 3)

    def test_the_planted_mistake_is_found_and_shrunk(self):
        boxes = st.lists(st.tuples(st.integers(100, 900), st.integers(100, 500)), min_size=1, max_size=8)
        found = self.smallest(boxes, lambda each: packer.scene_of(packer.pack(each)).check().unstable)
        self.assertLessEqual(len(found), 5)
        self.each(boxes, lambda each: assert_stands(packer.scene_of(packer.pack_safely(each))), 30)

    def test_pytest_tells_of_it(self):
        with tempfile.TemporaryDirectory() as folder:
            env = dict(os.environ, STONEPACK_FAILURES=folder, PYTHONPATH=os.pathsep.join(sys.path), PYTHONDONTWRITEBYTECODE="1")
            done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider",
                                   os.path.join(EXAMPLES, "test_packer.py")], cwd=folder, env=env, stdout=subprocess.PIPE,
                                  universal_newlines=True)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertIn("1 failed, 1 passed", done.stdout)
            self.assertRegex(done.stdout, "the scene does not stand: 'box[0-9]' falls")
            self.assertIn("test_packer.py.test_what_is_packed_stands.svg", os.listdir(folder))


if __name__ == "__main__":
    unittest.main()
