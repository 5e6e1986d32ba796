"""Scenes, answers and refusals of the Python package; standard library alone, NumPy where it is there."""
import copy
import gc
import inspect
import json
import math
import os
import pickle
import random
import threading
import time
import unittest
import xml.etree.ElementTree
from concurrent.futures import ThreadPoolExecutor

import stonepack
import ties
import towers
from stonepack import scenes

try:
    import numpy
except ImportError:
    numpy = None

TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])


def overhang(by, mu=0.6):
    """A block of 2 m that hangs over by so much."""
    s = stonepack.Scene(mu=mu)
    s.box((2, 1, 0.4), (1, 0.5, -0.2), name="table", fixed=True)
    s.box((2, 1, 0.8), (1 + by, 0.5, 0.4), name="stone")
    return s


class Misuse(unittest.TestCase):
    """What makes no sense is a SceneError, and no crash."""

    def test_a_change_while_another_thread_asks_is_refused(self):
        s, stop, wrong, refused = scenes.wall(courses=8, bricks=8), threading.Event(), [], 0

        def ask():
            while not stop.is_set():
                try:
                    s.check()
                except stonepack.SceneError:
                    pass
                except Exception as other:
                    wrong.append(other)
        threads = [threading.Thread(target=ask) for _ in range(3)]
        for t in threads:
            t.start()
        for k in range(100):
            try:
                s.box((0.1, 0.1, 0.1), (50 + k, 0, 0))
            except stonepack.SceneError:
                refused += 1
        stop.set()
        for t in threads:
            t.join()
        self.assertEqual(wrong, [])
        self.assertEqual(len(s), len(scenes.wall(courses=8, bricks=8)) + 100 - refused)
        s.box((0.1, 0.1, 0.1), (99, 9, 0), name="after")        # nothing is left under way

    def test_a_question_under_way_keeps_changes_out(self):
        s = overhang(0.5)
        s.check()
        self.assertTrue(s._turns.ask(s._is_ready))
        for change in (lambda: s.box((1, 1, 1)), lambda: s.load("stone", (0, 0, -1)), lambda: setattr(s, "gravity", (0, 0, -1)),
                       lambda: s.friction(0.1), lambda: s.find_contacts()):
            self.assertRaisesRegex(stonepack.SceneError, "being asked", change)
        s._turns.asked()
        s.load("stone", (0, 0, -1))
        self.assertTrue(s.check().stable)

    def test_forces_outlive_their_result(self):
        result = scenes.wall(courses=6, bricks=6).check()
        f, kept = result.f, result.forces
        del result
        gc.collect()
        other = [scenes.wall(courses=6, bricks=6, mu=0.9).check() for _ in range(20)]
        self.assertEqual([tuple(row) for row in f.tolist()], kept)
        self.assertEqual(len(other), 20)

    def test_no_number_is_cut_off_or_taken_for_another(self):
        s = overhang(0.5)
        for call in (lambda: s.box((1, 1, 1), fixed=2 ** 40), lambda: s.box((1, 1, 1), fixed=-1),
                     lambda: s.box((1, 1, 1), fixed=3.5),
                     lambda: s.pressure("stone", 2 ** 32, 1), lambda: s.pressure("stone", 0, "1"),
                     lambda: s.check(iterations=2 ** 32), lambda: s.check(budget="x"), lambda: s.check(tol="x"),
                     lambda: s.check(cone=8), lambda: s.check(cone="\u00b2i"), lambda: s.number(0.7), lambda: s.number(None),
                     lambda: s.body("1", (0, 0, 0)), lambda: s.limit("x"), lambda: s.joint(0, 1, [(0, 0, 0)] * 3, mu="x"),
                     lambda: stonepack.Scene(density="x").box((1, 1, 1)), lambda: s.box((1, 1, 1j)),
                     lambda: s.box((1, 1, 1), name="a\0b"), lambda: s.box((1, 1, 1), name="\udc80")):
            self.assertRaises(stonepack.SceneError, call)
        self.assertEqual(len(s), 2)

    def test_an_answer_is_told_as_the_program_tells_it(self):
        for load in (0.2, 1.5):
            s = overhang(load)
            result = s.check(tol=1e-7, cone="8i")
            told = json.loads(result.json(scene="two.obj"))
            self.assertEqual((told["scene"], told["verdict"], told["verified"], told["tol"], told["tol_by"], told["asked"]["cone"]),
                             ("two.obj", result.verdict, True, 1e-7, "asked", "8i"))
            self.assertEqual([tuple(f) for f in told["forces"]], list(result.forces))
            self.assertEqual([m["block"] for m in told["mechanism"]], result.moving)
        with self.assertRaises(stonepack.FileError):
            result.json("/nonexistent/answer.json")

    def test_a_cube_slides_at_its_friction_and_tips_at_its_breadth(self):
        for mu in (0.1, 0.5, 0.9, 1.1, 3):
            s = stonepack.Scene(mu=mu)
            s.box((9, 1, 1), (0, 0, -0.5), fixed=True)
            s.box((1, 1, 1), (0, 0, 0.5), name="cube")
            found = s.sliding((1, 0, 0), starts=1)
            self.assertEqual((found.kind, found.verified, list(found.motion)), ("state", True, ["cube"]))
            self.assertAlmostEqual(found.upper, min(mu, 1), 7)
            for lower in (found.lower, found.lower_strong):                 # by even friction, which proves it up to the limit
                self.assertAlmostEqual(lower, found.upper, 6)

    def test_what_pressure_alone_carries_is_for_safety(self):
        s = stonepack.Scene()
        s.box((1, 1, 1), (0.5, 0.5, -0.5), fixed=True)
        s.box((1, 1, 1), (0.8, 0.5, 0.5), name="cube")
        weight = s.blocks[1].mass * 9.80665
        s.load("cube", (0, 0, -weight), (1.3, 0.5, 0.5), live=True)         # .3 m beyond the edge, the cube .2 m before it
        found, limit = s.sliding(starts=1), s.limit()
        for each in (found.upper, found.associative, found.lower, found.lower_strong, limit.multiplier):
            self.assertAlmostEqual(each, 2 / 3, 7)

    def test_what_is_not_planar_is_not_asked_how_it_slides(self):
        s = overhang(0.5)
        found = s.sliding((1, 0.3, 0))
        self.assertEqual((found.kind, found.reason, found.verified), ("associative", "not asked", False))
        self.assertEqual(found.upper, s.limit((1, 0.3, 0)).upper)
        for words, call in (("starts=99", lambda: s.sliding((1, 0, 0), starts=99)), ("starts: a whole", lambda: s.sliding(starts=-1)),
                            ("tol=0", lambda: s.sliding((1, 0, 0), tol=0)), ("called wind", lambda: s.sliding(wind=3))):
            with self.assertRaisesRegex(stonepack.SceneError, words):
                call()

    def test_an_answer_is_neither_true_nor_false(self):
        falls = overhang(1.5)
        self.assertTrue(falls.check().unstable)
        for answer, ask in ((falls.check(), ".stable"), (falls.limit((1, 0, 0)), ".multiplier"), (falls.sequence()[0], ".stable"),
                            (falls.strong(), ".kind"), (falls.check().verify(), ".verdict")):
            with self.assertRaisesRegex(stonepack.StonepackError, "neither true nor false: ask its \\" + ask):
                assert answer
        with self.assertRaises(stonepack.StonepackError):
            all(falls.sequence())

    def test_a_scene_has_no_other_fields(self):
        s = overhang(0.5)
        with self.assertRaises(AttributeError):
            s.gravty = (1, 0, -9.8)

    def test_a_setting_outside_its_range_is_named(self):
        s = overhang(0.5)
        for words, call in (("tol=0", lambda: s.check(tol=0)), ("tol=2", lambda: s.limit((1, 0, 0), tol=2)),
                            ("tol=-1", lambda: s.plan(tol=-1)), ("tol=0", lambda: s.sequence(tol=0)), ("tol=0", lambda: s.strong(tol=0)),
                            ("force_bound=-2", lambda: s.check(force_bound=-2)), ("cone='2i'", lambda: s.check(cone="2i")),
                            ("eps", lambda: s.check(coupled=True, eps=-5)), ("mu is 0 or more", lambda: stonepack.Scene(mu=-1)),
                            ("mu is 0 or more", lambda: stonepack.Scene(mu=float("nan"))),
                            ("density more", lambda: stonepack.Scene(density=0))):
            with self.assertRaisesRegex(stonepack.SceneError, words):
                call()

    def test_help_tells_types_as_they_are(self):
        self.assertNotIn("ForwardRef", str(inspect.signature(stonepack.Joint)) + str(inspect.signature(stonepack.Step)))

    def test_wrong_types_are_refused_in_our_words(self):
        s, text = overhang(0.5), overhang(0.5).to_obj()
        result, limit = s.check(), s.limit((1, 0, 0))
        for words, call in (
                ("scenes are wanted, not 1", lambda: stonepack.check_many([1])), ("a list", lambda: stonepack.check_many(None)),
                ("threads", lambda: stonepack.check_many([s, s], threads=-3)), ("called wind", lambda: stonepack.check_many([s], wind=1)),
                ("called wind", lambda: s.limit(wind=1)), ("called wind", lambda: s.building(wind=1)),
                ("a list", lambda: s.sequence(5)), ("a list", lambda: s.part(5)), ("without", lambda: s.check(without=5)),
                ("not \\(5, 6\\)", lambda: s.check(cone=(5, 6))), ("tol", lambda: s.check(tol=10 ** 400)),
                ("mu: a number", lambda: stonepack.Scene(mu="a")), ("n x 3", lambda: s.add([(0, 0, 10 ** 400)], [(0, 1, 2)])),
                ("box", lambda: s.box((10 ** 400, 1, 1))), ("an answer of check", lambda: s.verify(limit)),
                ("of another scene", lambda: scenes.wall(courses=2, bricks=2).verify(result)),
                ("gravity", lambda: stonepack.parse(text, gravity="xyz")), ("gravity", lambda: stonepack.parse(text, gravity=(1,))),
                ("fixed: a list", lambda: stonepack.parse(text, fixed=5)), ("title", lambda: limit.svg(title=5))):
            self.assertRaisesRegex(stonepack.SceneError, words, call)
        for words, call in (
                ("a path", lambda: stonepack.read(None)), ("a path", lambda: stonepack.read("a\0b")), ("a path", lambda: s.write(5)),
                ("a path", lambda: s.write("a\0b")), ("a path", lambda: result.svg([5])), ("no text", lambda: stonepack.parse(None)),
                ("mu", lambda: stonepack.parse(text, mu=[])), ("up", lambda: stonepack.parse(text, up="\ud800"))):
            self.assertRaisesRegex(stonepack.FileError, words, call)
        self.assertFalse(os.path.exists("a"))           # a name is not cut off either
        self.assertEqual(overhang(0.5).verify(result).verdict, result.verdict)
        self.assertTrue(s.check(without="friction", budget=1).undecided)

    def test_the_error_of_a_number_names_its_block(self):
        with self.assertRaisesRegex(stonepack.SceneError, "block 'key': density"):
            stonepack.Scene().box((1, 1, 1), name="key", density="x")

    def test_pickling_says_what_to_send(self):
        s = overhang(0.5)
        result, order = s.check(), s.building()
        for thing, word in ((s, "to_obj"), (result, "verdict"), (order, "not pickled")):
            self.assertRaisesRegex(stonepack.StonepackError, word, pickle.dumps, thing)
        self.assertEqual(copy.deepcopy(result).forces, result.forces)
        self.assertEqual(copy.copy(s).check().forces, result.forces)
        self.assertEqual(stonepack.parse(s.to_obj().encode()).check().verdict, "stable")

    def test_no_blocks_are_told(self):
        s = stonepack.Scene()
        for ask in (s.check, s.limit, s.plan, s.strong, lambda: s.sequence([])):
            self.assertRaisesRegex(stonepack.SceneError, "the scene has no block", ask)
        self.assertEqual((s.joints, s.blocks, stonepack.check_many([])), ([], [], []))

    @unittest.skipUnless(numpy, "NumPy")
    def test_arrays_of_any_layout_are_the_same_block(self):
        v, f = (numpy.array(x) for x in TETRAHEDRON)
        still = v.astype("d")
        still.flags.writeable = False
        for vertices, faces in ((v.astype("d"), f), (v.astype("f4"), f.astype("u1")), (v.astype(">f8"), f.astype(">i8")),
                                (numpy.asfortranarray(v), numpy.asfortranarray(f)), (numpy.repeat(v, 2, 0)[::2], f), (still, f)):
            s = stonepack.Scene(density=6)
            s.add(vertices, faces)
            self.assertAlmostEqual(s.blocks[0].mass, 1)
        for vertices, faces in ((v.ravel(), f), (v[None], f), (v, f.ravel()), (v, f[None]), (v, f + 0.5), (v.astype(complex), f),
                                (v * numpy.nan, f), (v[:0], f), (v, f[:0]), (v, f.astype("u8") + 2 ** 40), (numpy.array(1.0), f)):
            self.assertRaises(stonepack.SceneError, stonepack.Scene().add, vertices, faces)


class Verdicts(unittest.TestCase):
    def test_a_block_stands_until_its_middle_is_over_the_edge(self):
        self.assertTrue(overhang(0.999).check().stable)
        falls = overhang(1.001).check()
        self.assertTrue(falls.unstable and falls.verified and falls.final)
        self.assertEqual(falls.moving, ["stone"])

    def test_its_limit_is_friction_or_width_over_height(self):
        self.assertAlmostEqual(overhang(0).limit((1, 0, 0)).multiplier, 0.6, places=7)
        self.assertAlmostEqual(overhang(0, mu=3).limit((1, 0, 0)).multiplier, 2 / 0.8, places=6)
        self.assertEqual(overhang(0).limit((0, 0, -1)).kind, "unbounded")
        self.assertEqual(overhang(0).limit((0, 0, -1)).multiplier, math.inf)
        self.assertIsNone(overhang(1.1).limit((1, 0, 0)).multiplier)

    def test_a_check_below_a_limit_stands_and_above_it_falls(self):
        for name in ("arch", "wall", "trilithon"):
            s = stonepack.read("tests/scenes/%s.obj" % name)
            limit = s.limit((1, 0, 0))
            for share, verdict in ((1 - 1e-6, "stable"), (1 + 1e-6, "unstable")):
                s.live_acceleration = (9.80665, 0, 0)
                s.live = share * limit.multiplier
                self.assertEqual(s.check().verdict, verdict, (name, share))

    def test_a_thousand_tol_from_a_limit_every_answer_is_right(self):
        distances = (1e-2, 1e-6)
        counts = {d: [0, 0, 0, 0] for d in distances}
        rng = random.Random(5)
        asked = sum(ties.ask(s, distances, 1e-9, counts) for s in rng.sample(list(ties.families(rng)), 30))
        self.assertGreater(asked, 20)
        self.assertEqual(counts, {d: [2 * asked, 0, 0, 0] for d in distances})

    def test_numbers_that_take_more_memory_are_answered_as_from_the_start(self):
        s = scenes.stack([(1, 1, 1)] * 6, [(0, 0)] * 6)
        first = s.check()
        s.gravity = (1, 0.5, -9)
        s.load("s3", (10, 20, -30), at=(0.1, 0.2, 2.9), couple=(1, 2, 3))
        self.assertEqual(s.check().forces, s.copy().check().forces)
        self.assertTrue(first.stable)

    def test_a_limit_tells_the_hinge(self):
        limit = overhang(0, mu=3).limit((1, 0, 0))
        self.assertTrue(limit.verified and limit.lower <= limit.multiplier <= limit.upper)
        (hinge,) = limit.hinges
        self.assertEqual((hinge.a, hinge.b, hinge.kind), ("table", "stone", "hinge"))
        self.assertAlmostEqual(hinge.line[0][0], 2)
        self.assertEqual(list(limit.motion), ["stone"])

    def test_forces_and_reactions_carry_the_weight(self):
        s = overhang(0.3)
        r, weight = s.check(), s.blocks[1].mass * 9.80665
        self.assertAlmostEqual(sum(fn for fn, _, _ in r.forces), weight, places=6)
        force, _ = r.reactions["table"]
        self.assertAlmostEqual(force[2], -weight, places=6)
        (joint,) = r.joints
        self.assertEqual((joint.a, joint.b), ("table", "stone"))
        self.assertAlmostEqual(joint.force[2], weight, places=6)
        self.assertAlmostEqual(joint.point[0], 1.3)

    def test_random_towers_answer_as_the_closed_form(self):
        for make, count in ((towers.Tower.bare, 3000), (towers.Tower.scene, 500)):
            wrong, open_, stable, _ = towers.ask(count, 7, make)
            self.assertEqual(wrong, [])
            self.assertLess(max(open_, default=0), 1e-6)
            self.assertTrue(count / 4 < stable < 3 * count / 4)

    def test_verify_computes_the_same_verdict_anew(self):
        for by in (0.5, 1.5):
            r = overhang(by).check()
            self.assertEqual(r.verify().verdict, r.verdict)

    def test_verify_does_not_believe_forces_that_were_tampered_with(self):
        r = overhang(0.5).check()
        r._c.f[0] += 1
        self.assertEqual(r.verify().verdict, "undecided")

    def test_a_build_order_tells_what_falls_and_what_to_hold(self):
        s = overhang(0.7)
        s.box((2, 1, 0.8), (2.4, 0.5, 1.2), name="top")
        steps = s.sequence(hold=True)
        self.assertEqual([(x.block, x.verdict, x.hold) for x in steps],
                         [("stone", "stable", []), ("top", "unstable", ["stone"])])
        order = s.building()
        self.assertTrue(order.add("stone").stable)
        self.assertTrue(order.hold("top").stable)
        self.assertEqual(order.remove("top").verdict, "stable")
        self.assertIsNone(order.suggest())

    def test_a_beam_between_posts_is_held_by_its_history_alone(self):
        s = stonepack.read("tests/scenes/h-model.obj")
        strong = s.strong()
        self.assertEqual((strong.kind, strong.verified), ("ambiguous", True))
        self.assertTrue(strong.moving)
        self.assertTrue(s.check().stable)
        self.assertTrue(s.check(coupled=True).unstable)
        self.assertEqual(overhang(0).strong().kind, "strong")
        self.assertEqual(s.strong(corners=True).kind, "ambiguous")

    def test_a_plan_says_what_is_left_out(self):
        plan = overhang(0.2).plan()
        self.assertFalse(plan.effects["depth"].on)
        self.assertLess(plan.flops, plan.full_flops)

    def test_settings_reach_the_check(self):
        s = overhang(0.2)
        self.assertEqual(s.check(tol=1e-3).tol, 1e-3)
        self.assertEqual(s.check(coupled=True).level, "coupled")
        self.assertTrue(s.check(budget=1).undecided)
        self.assertTrue(s.check(cone="8i").stable)
        with self.assertRaisesRegex(stonepack.SceneError, "cone"):
            s.check(cone="round")
        with self.assertRaisesRegex(stonepack.SceneError, "tolerance"):
            s.check(tolerance=1)


class WasWrong(unittest.TestCase):
    """Named after what was wrong."""

    def refused(self, call):
        with self.assertRaises(stonepack.SceneError):
            call()

    def test_a_refused_search_of_contacts_took_the_joints_that_were_there(self):
        s = overhang(0.5)
        before, forces = s.joints, list(s.check().forces)
        for wrong in (dict(distance=-1), dict(angle=math.nan), dict(mu=-1)):
            self.refused(lambda: s.find_contacts(**wrong))
            self.assertEqual((s.joints, list(s.check().forces)), (before, forces))
        s.joint("table", "stone", [(0.5, 0, 0), (1, 0, 0), (1, 1, 0), (0.5, 1, 0)])
        self.refused(lambda: s.find_contacts(distance=-1))
        self.assertEqual(s.joints[0].area, 0.5)
        self.assertTrue(s.check().unstable)

    def test_a_refused_joint_wrote_over_those_that_were_found(self):
        s = overhang(0.5)
        before, forces = s.joints, list(s.check().forces)
        for corners in ([(0, 0, 0), (1, 0, 0), (1, 1, .5), (0, 1, 0)], [(0, 0, 0), (1, 0, math.nan), (1, 1, 0)], [(0, 0, 0)] * 4):
            self.refused(lambda: s.joint("table", "stone", corners))
            self.assertEqual((s.joints, list(s.check().forces)), (before, forces))
        self.refused(lambda: s.points("table", "stone", (0, 0, 0), [(0, 0, 0)]))
        self.assertEqual(s.joints, before)

    def test_a_part_forgot_the_live_acceleration(self):
        s = overhang(0.5)
        s.live_acceleration = 8, 0, 0
        self.assertTrue(s.check().unstable)
        self.assertTrue(s.part(s.names).check().unstable)

    def test_a_file_lost_how_often_live_loads_count(self):
        s = overhang(0)
        s.load("stone", (2e5, 0, 0), live=True)
        s.to_obj()
        s.live = 0.0
        with self.assertRaisesRegex(stonepack.StonepackError, "no word for live loads that count 0 times"):
            s.to_obj()
        s = overhang(0)
        s.live_acceleration = 8, 0, 0
        with self.assertRaisesRegex(stonepack.StonepackError, "live acceleration"):
            s.to_obj()

    def test_two_threads_in_one_build_order(self):
        s = scenes.wall(6, 6)
        order, wrong = s.building(), []

        def work(names):
            for name in names * 5:
                try:
                    order.add(name)
                    order.must_hold()
                    order.suggest()
                    order.remove(name)
                except stonepack.SceneError:
                    pass
                except Exception as other:
                    wrong.append(other)
        names = s.names[1:]
        threads = [threading.Thread(target=work, args=(names[k::3],)) for k in range(3)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertEqual(wrong, [])

    def test_a_build_order_began_while_the_scene_changed(self):
        s, stop = scenes.wall(12, 12), time.time() + 1

        def repeat(call):
            while time.time() < stop:
                try:
                    call()
                except stonepack.SceneError:
                    pass
        calls = [s.building, s.building, lambda: s.load("c1b1", (0, 0, -1))]
        threads = [threading.Thread(target=repeat, args=(call,)) for call in calls]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertTrue(s.check().stable)

    def test_lists_of_different_length_lost_stones(self):
        for make in (lambda: scenes.stack([(1, 1, 1)] * 3, [(0, 0)]), lambda: scenes.stack([], []),
                     lambda: scenes.stack([(1, 1, 1)] * 2, [(0, 0)] * 2, densities=[1]), lambda: scenes.rubble([[], []], [0.2])):
            self.refused(make)

    def test_eps_without_coupled_was_ignored(self):
        self.refused(lambda: overhang(0).check(eps=1e-4))
        self.refused(lambda: overhang(0).check(eta=5))
        self.assertEqual(overhang(0).check(coupled=True, eps=1e-4).level, "coupled")

    def test_friction_set_after_joints_were_found_changed_none(self):
        s = overhang(0)
        s.gravity = 3, 0, -9.8
        self.assertTrue(s.check().stable)
        s.mu = 0.05
        self.assertEqual((s.joints[0].mu, s.check().verdict), (0.05, "unstable"))
        with self.assertRaises(stonepack.SceneError):
            s.mu = -1
        s.find_contacts(mu=0.3)                         # of their own
        s.mu = 0.7
        self.assertEqual(s.joints[0].mu, 0.3)

    def test_contacts_sought_otherwise_are_no_longer_the_recipe(self):
        s = scenes.stack([(1, 1, 1)], [(0.1, 0)])
        self.assertIn("stack(", repr(s))
        s.find_contacts(mu=0.01)
        self.assertNotIn("stack(", repr(s))

    def test_more_than_64_supports_were_not_understood(self):
        text = "".join(stonepack.parse(overhang(0).to_obj()).to_obj().split("#@ interface")[0])
        s = stonepack.Scene()
        for k in range(70):
            s.box((0.5, 0.5, 0.5), (k, 0, 0), name="p%d" % k)
        t = stonepack.parse(s.to_obj(), fixed=["p%d" % k for k in range(70)])
        self.assertTrue(all(b.fixed for b in t.blocks))
        self.assertTrue(stonepack.parse(text, fixed="table").check().stable)

    def test_names_that_no_file_gives_back(self):
        for name in ('#1', '"q', "a\\"):
            self.refused(lambda: stonepack.Scene().box((1, 1, 1), name=name))

    def test_words_where_yes_or_no_was_meant(self):
        s = overhang(0)
        s.load("stone", (1e6, 0, 0), live=0.5)          # it is live
        s.live = 0.0
        self.assertTrue(s.check().stable)
        for call in (lambda: s.add([], TETRAHEDRON[1]), lambda: s.add(TETRAHEDRON[0][:0], TETRAHEDRON[1])):
            self.refused(call)
        if numpy:
            self.refused(lambda: s.add(numpy.zeros((0, 3)), TETRAHEDRON[1]))

    def test_the_density_of_a_file_was_forgotten(self):
        s = stonepack.parse(overhang(0).to_obj().replace("#@ density 2400", "#@ density 1000"))
        self.assertEqual(s.density, 1000)
        s.box((1, 1, 1), (0, 0, 9), name="late")
        self.assertEqual(s.blocks[2].mass, 1000)


class Building(unittest.TestCase):
    def test_whatever_has_vertices_and_faces_is_a_block(self):
        class Attributes:
            vertices, faces = TETRAHEDRON

        class Compas:
            def to_vertices_and_faces(self):
                return [list(v) for v in TETRAHEDRON[0]], TETRAHEDRON[1]

            def vertices(self):                         # of COMPAS: a generator of keys
                return iter(range(4))

            faces = vertices

        for thing in (Attributes, Attributes(), Compas(), TETRAHEDRON):
            s = stonepack.Scene(density=6)
            s.add(thing)
            self.assertAlmostEqual(s.blocks[0].mass, 1)
            self.assertEqual(len(s.mesh(0)[0]), 4)
        with self.assertRaisesRegex(stonepack.SceneError, "neither"):
            stonepack.Scene().add(object())

    @unittest.skipUnless(numpy, "no NumPy")
    def test_arrays_of_numpy_give_the_same_bits_as_lists(self):
        outline = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)]
        answers = []
        for array in (list, numpy.array, lambda v: numpy.array(v, dtype=numpy.float32), lambda v: numpy.array(v)[::1][:, ::1],
                      lambda v: numpy.asfortranarray(numpy.array(v, dtype=float))):
            s = stonepack.Scene()
            vertices, faces = stonepack.meshes.box((2, 1, 0.5), (1, 0.5, 0.25))
            s.body(0, (0, 0, 0), fixed=True)
            s.add(array(vertices), numpy.array(faces) if array is not list else faces)
            s.joint(0, 1, array(outline))
            answers.append((s.blocks[1], s.check().forces))
        for answer in answers[1:]:
            self.assertEqual(answer, answers[0])

    @unittest.skipUnless(numpy, "no NumPy")
    def test_forces_are_an_array_without_a_copy(self):
        r = overhang(0.3).check()
        f = numpy.asarray(r.f)
        self.assertEqual(f.shape, (4, 3))
        self.assertEqual([tuple(row) for row in f.tolist()], r.forces)

    def test_a_scene_grows(self):
        s = stonepack.Scene()
        s.box((1, 1, 0.5), (0, 0, -0.25), fixed=True)
        for k in range(150):
            s.box((1, 1, 0.5), (0, 0, 0.5 * k + 0.25))
        self.assertEqual(len(s.joints), 150)
        self.assertTrue(s.check().stable)
        self.assertEqual(s.blocks[77].centroid[2], 0.5 * 76 + 0.25)

    def test_joints_that_are_given_are_not_sought(self):
        s = overhang(0.3)
        self.assertEqual(s.joint("table", "stone", [(0.5, 0, 0), (1.5, 0, 0), (1.5, 1, 0)]), 0)
        self.assertEqual([len(j.points) for j in s.joints], [3])

    def test_contacts_across_a_gap_need_a_distance(self):
        s = stonepack.Scene()
        s.box((1, 1, 1), (0, 0, -0.5), fixed=True)
        s.box((1, 1, 1), (0, 0, 0.501))
        self.assertEqual(s.check().reason, "no contact")
        self.assertEqual(s.find_contacts(distance=0.002), [])
        self.assertTrue(s.check().stable)
        s.box((1, 1, 1), (0, 0, 1.502))                 # later blocks are found the same way
        self.assertTrue(s.check().stable)

    def test_overlaps_are_told(self):
        s = overhang(0)
        s.box((2, 1, 0.8), (1, 0.5, 1.1), name="top")
        ((a, b, depth),) = s.overlaps
        self.assertEqual((a, b), ("stone", "top"))
        self.assertAlmostEqual(depth, 0.1)

    def test_loads_and_friction_change_the_answer(self):
        s = overhang(0.5)
        self.assertTrue(s.check().stable)
        s.load("stone", (0, 0, -1e6), at=(2.4, 0.5, 0.8))
        self.assertTrue(s.check().unstable)
        s = overhang(0.5)
        s.load("stone", (0.5 * s.blocks[1].mass * 9.80665, 0, 0), at=(1.5, 0.5, 0.01), live=True)
        self.assertTrue(s.check().stable)
        self.assertAlmostEqual(s.limit().multiplier, 1.2, places=6)
        s.friction(0.45)
        self.assertTrue(s.check().unstable)
        s.live = 0.8
        self.assertTrue(s.check().stable)
        s.gravity = (4, 0, -8)
        self.assertTrue(s.check().unstable)

    def test_pressure_on_a_face_lifts_a_block(self):
        s = overhang(0)
        weight = s.blocks[1].mass * 9.80665
        s.pressure("stone", 0, 0.99 * weight / 2)       # its face 0 looks down, 2 m^2
        self.assertTrue(s.check().stable)
        s.pressure("stone", 0, 0.02 * weight / 2)
        self.assertTrue(s.check().unstable)

    def test_a_block_held_in_some_directions_only(self):
        s = stonepack.Scene()
        s.box((1, 1, 1), fixed="x y z rx ry")
        self.assertTrue(s.check().stable)
        s = stonepack.Scene()
        s.box((1, 1, 1), fixed=("x", "y"))
        self.assertTrue(s.check().unstable)

    def test_a_copy_is_a_scene_of_its_own(self):
        s = overhang(0.5)
        before = s.check().forces
        t = copy.deepcopy(s)
        t.friction(0.1)
        t.box((1, 1, 1), (2, 0.5, 1.3), name="more")
        self.assertEqual((len(s), len(t)), (2, 3))
        self.assertEqual(s.check().forces, before)
        self.assertEqual(t.joints[0].mu, 0.1)


class Help(unittest.TestCase):
    def test_every_field_and_call_is_told(self):
        for kind in (getattr(stonepack, name) for name in stonepack.__all__ if isinstance(getattr(stonepack, name), type)):
            for field in getattr(kind, "_fields", ()):
                self.assertRegex(kind.__doc__, r"\b%s\b" % field, kind)
            for name in dir(kind):
                if name[0] != "_" and name not in ("args", "count", "index"):       # those are Python's
                    self.assertTrue(inspect.getdoc(getattr(kind, name)), "%s.%s" % (kind.__name__, name))


class Refusals(unittest.TestCase):
    def refused(self, block, words, call, *args, **more):
        with self.assertRaisesRegex(stonepack.SceneError, words) as told:
            call(*args, **more)
        self.assertEqual(told.exception.block, block)
        return told.exception

    def test_an_exception_names_the_block(self):
        s = overhang(0)
        error = self.refused("open", "'open'.*open", s.add, TETRAHEDRON[0], TETRAHEDRON[1][:3], name="open")
        self.assertEqual(error.status, -7)
        self.refused("in", "'in'.*inward", s.add, TETRAHEDRON[0], [f[::-1] for f in TETRAHEDRON[1]], name="in")
        self.refused("stone", "one of this name", s.box, (1, 1, 1), name="stone")
        self.refused("b2", "'b2'.*range", s.box, (1, 1, 1), density=-1)
        self.refused("keystone", "keystone", s.load, "keystone", (0, 0, 1))
        self.refused("stone", "'table' 'stone'", s.joint, "table", "stone", [(0, 0, 0), (1, 0, 0), (2, 0, 0)])
        self.refused("stone", "'stone'", s.load, "stone", (0, 0, float("nan")))
        self.assertEqual(s.names, ["table", "stone"])   # what was refused is not there
        self.assertTrue(s.check().stable)

    def test_shapes_that_are_none(self):
        s = stonepack.Scene()
        self.refused(None, "n x 3", s.add, [(0, 0), (1, 1)], [(0, 1, 2)])
        self.refused(None, "n x 3", s.add, [(0, 0, "x")], [(0, 1, 2)])
        self.refused(None, "vertex numbers", s.add, TETRAHEDRON[0], [(0, 1.5, 2)])
        self.refused("b0", "missing", s.add, TETRAHEDRON[0], [(0, 2, 9)] + TETRAHEDRON[1][1:])
        self.refused(None, "three numbers", s.box, (1, 1))
        self.refused(None, "three numbers", stonepack.Scene, gravity=(0, 0))
        self.refused(None, "", s.check)                 # no block at all

    def test_answers_of_a_scene_that_changed_say_so(self):
        s = overhang(0.2)
        r, limit, order = s.check(), s.limit((1, 0, 0)), s.building()
        self.assertEqual(len(r.joints), 1)
        s.box((1, 1, 1), (0.5, 0.5, 1.3), name="more")
        for ask in (lambda: r.joints, lambda: r.forces, lambda: r.f, r.verify, lambda: limit.hinges,
                    lambda: order.add("stone")):
            with self.assertRaisesRegex(stonepack.StonepackError, "changed"):
                ask()
        self.assertEqual((r.verdict, r.moving), ("stable", []))             # its own numbers stay


class Files(unittest.TestCase):
    def test_a_scene_file_reads_back_as_the_same_scene(self):
        for name in ("arch-falling", "wall", "rubble", "trilithon"):
            s = stonepack.read("tests/scenes/%s.obj" % name)
            t = stonepack.parse(s.to_obj())
            self.assertEqual(s.names, t.names)
            self.assertEqual(s.joints, t.joints)
            self.assertEqual(s.check().forces, t.check().forces)

    def test_blocks_added_to_a_file_are_found_with_its_own(self):
        s = stonepack.parse(overhang(0).to_obj().split("#@ interface")[0])
        self.assertEqual(len(s.joints), 1)
        s.box((2, 1, 0.8), (1, 0.5, 1.15), name="top")
        self.assertEqual(len(s.joints), 1)              # 5 cm inside is no touch
        self.assertEqual([(o.a, o.b) for o in s.overlaps], [("stone", "top")])
        t = stonepack.parse(s.to_obj().split("#@ interface")[0])
        self.assertEqual(t.overlaps, s.overlaps)
        t = stonepack.parse(overhang(0).to_obj())       # its own joint is given: no others are sought
        t.box((2, 1, 0.8), (1, 0.5, 1.2), name="top")
        self.assertEqual((len(t.joints), t.check().moving), (1, ["top"]))

    def test_a_found_scene_keeps_its_distance(self):
        text = overhang(0).to_obj().split("#@ interface")[0]
        s = stonepack.parse(text, contact_distance=0.01, mu=0.3)
        s.box((2, 1, 0.8), (1, 0.5, 1.205), name="top")
        self.assertEqual([(j.a, j.b, j.mu) for j in s.joints], [("table", "stone", 0.3), ("stone", "top", 0.3)])

    def test_names_are_those_of_files(self):
        s = stonepack.Scene()
        self.assertEqual(s.box((1, 1, 1), name="key stone", fixed=True), "key_stone")
        self.assertEqual(stonepack.parse(s.to_obj()).names, ["key_stone"])
        with self.assertRaises(stonepack.SceneError):
            s.box((1, 1, 1), name=" ")
        with self.assertRaises(stonepack.SceneError):
            s.box((1, 1, 1), name="key_stone")

    def test_json_of_compas_is_read(self):
        with open("tests/examples/doorway.json") as file:
            text = file.read()
        s = stonepack.read("tests/examples/doorway.json", fixed="ground")
        self.assertEqual(s.check().forces, stonepack.parse(text, "doorway.json", fixed=["ground"]).check().forces)
        self.assertTrue(s.check().stable)

    def test_options_of_the_program(self):
        text = stonepack.parse("o a\n" + overhang(0).to_obj().split("o table")[1].split("#@ interface")[0], "y")
        self.assertEqual(len(text), 2)
        s = stonepack.parse(overhang(0).to_obj(), unit="mm", up="y", mu=0.2, fixed=("stone",))
        self.assertAlmostEqual(s.blocks[1].volume, 1.6e-9)
        self.assertTrue(s.blocks[1].fixed)
        self.assertAlmostEqual(s.gravity[1], -9.80665)
        s = stonepack.read("tests/scenes/arch.obj", mu=0.2)
        self.assertEqual(s.mu, 0.2)
        with self.assertRaisesRegex(stonepack.FileError, "unit"):
            stonepack.read("tests/scenes/arch.obj", unit="miles")

    def test_bad_files_are_one_line(self):
        for text, words in (("o a\nv 1 2\n", "bad:2: "), ("{", "bad"), ("", "bad")):
            with self.assertRaisesRegex(stonepack.FileError, words) as told:
                stonepack.parse(text, "bad")
            self.assertNotIn("\n", str(told.exception))
        with self.assertRaisesRegex(stonepack.FileError, "can't open"):
            stonepack.read("nowhere.obj")
        s = stonepack.Scene()
        s.body(1, (0, 0, 0), name="ball")
        with self.assertRaisesRegex(stonepack.FileError, "no mesh"):
            s.to_obj()

    def test_pictures_are_svg(self):
        for r in (overhang(0.5).check(), overhang(1.5).check(), overhang(0.5).limit((1, 0, 0))):
            root = xml.etree.ElementTree.fromstring(r.svg(names=True))
            self.assertTrue(root.tag.endswith("svg"))
        self.assertIn("stone", overhang(1.5).check().svg())


class Settling(unittest.TestCase):
    def setUp(self):
        try:
            stonepack._library.settling()
        except stonepack.StonepackError as missing:
            self.skipTest(str(missing))

    def shelf(self, x):
        scene = stonepack.Scene(mu=0.6)
        scene.box((2, 1, 0.4), at=(0, 0, -0.2), fixed=True, name="shelf")
        scene.box((2, 1, 0.8), at=(x, 0, 0.4), name="stone")
        return scene

    def test_what_stands_keeps_still_and_what_hangs_over_does_not(self):
        for x, stands in (0.6, True), (1.2, False):
            scene = self.shelf(x)
            settled = scene.settle(confirm=True)
            self.assertEqual(settled.held, stands)
            self.assertEqual(scene.check().stable, stands)
        self.assertLess(settled.poses["stone"].t[2], 0.4)
        self.assertEqual(settled.poses["shelf"].moved, 0)

    def test_a_stone_that_falls_comes_to_rest_below(self):
        scene = stonepack.Scene(mu=0.6)
        scene.box((2, 1, 0.4), at=(0, 0, -0.2), fixed=True, name="floor")
        scene.box((0.5, 0.5, 0.5), at=(0, 0, 1.25), name="stone")
        settled = scene.settle(tamps=0)
        self.assertAlmostEqual(settled.poses["stone"].moved, 1, 2)
        below = settled.scene
        below.find_contacts(distance=0.005)
        self.assertEqual((len(below.joints), below.check().verdict), (1, "stable"))

    def test_settings_that_are_none_are_named(self):
        with self.assertRaisesRegex(stonepack.SceneError, "no setting 'wind'"):
            self.shelf(0).settle(wind=1)
        for name, value in ("steps", 2 ** 32), ("steps", 2.5), ("container", 5), ("dt", "x"):
            with self.assertRaisesRegex(stonepack.SceneError, name):
                self.shelf(0).settle(**{name: value})

    def test_a_scene_with_loads_is_refused(self):
        scene = self.shelf(0)
        scene.load("stone", (1, 0, 0))
        with self.assertRaisesRegex(stonepack.SceneError, "loads"):
            scene.settle()


class Threads(unittest.TestCase):
    def test_many_scenes_at_once_answer_as_one_by_one(self):
        scenes = [overhang(0.02 * k) for k in range(100)]
        alone = [s.copy().check().forces for s in scenes]
        together = stonepack.check_many(scenes * 3, threads=4)
        self.assertEqual([r.forces for r in together], alone * 3)
        self.assertEqual(stonepack.check_many([]), [])
        with self.assertRaises(stonepack.SceneError):
            stonepack.check_many([overhang(0), stonepack.Scene()])

    def test_files_and_pictures_from_many_threads_are_those_of_one(self):
        names = ["arch", "wall", "rubble", "trilithon"] * 6

        def work(name):
            s = stonepack.read("tests/scenes/%s.obj" % name)
            return s.check().svg(names=True), s.to_obj()

        alone = {name: work(name) for name in names[:4]}
        with ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(work, names)), [alone[name] for name in names])

    def test_others_run_while_a_call_is_under_way(self):
        """One call of a tenth of a second or more: a lock that it kept would let the other thread turn once or twice."""
        s = scenes.wall(16, 16)
        s.check()
        turns, done, took = 0, threading.Event(), []

        def work():
            start = time.perf_counter()
            s.limit((1, 0, 0))
            took.append(time.perf_counter() - start)
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.is_set():
            turns += 1
            time.sleep(0.0005)
        thread.join()
        self.assertGreater(took[0], 0.02)
        self.assertGreater(turns, 5)


if __name__ == "__main__":
    unittest.main()
