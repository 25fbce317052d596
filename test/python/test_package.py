"""test_package.py SOURCE_DIR: the Python package ompl_mfa."""
import os
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import unittest

import numpy as np

import ompl_mfa

SOURCE = sys.argv.pop(1)
SCENE = os.path.join(SOURCE, "benchmarks", "configs", "paper_scene.cfg")
SQUARE = [(0, 1), (0, 1)]


def outside_disc(state):
    return np.hypot(state[0] - 0.5, state[1] - 0.5) > 0.3


def outside_discs(states):
    return np.hypot(states[:, 0] - 0.5, states[:, 1] - 0.5) > 0.3


class Plan(unittest.TestCase):
    def test_config(self):
        result = ompl_mfa.plan(SCENE, time=1, seed=7)
        self.assertEqual(result.status, "Exact solution")
        self.assertTrue(result.exact)
        self.assertLess(result.cost, 1.02 * 27.82)
        self.assertEqual(result.path.shape[1], 2)
        self.assertAlmostEqual(np.linalg.norm(np.diff(result.path, axis=0), axis=1).sum(), result.cost, places=9)
        self.assertTrue(np.all(np.diff(result.costs[:, 0]) > 0) and np.all(np.diff(result.costs[:, 1]) < 0))
        self.assertAlmostEqual(result.costs[-1, 1], result.cost, places=9)
        self.assertLessEqual(result.first_solution_time, result.time)

    def test_keywords(self):
        result = ompl_mfa.plan(start=(0.1, 0.2), goal=(0.9, 0.8), robot="point", bounds=SQUARE, time=0.1)
        self.assertAlmostEqual(result.cost, 1.0)
        world = os.path.join(SOURCE, "benchmarks", "worlds", "box_field.yaml")
        result = ompl_mfa.plan(world=world, robot="disc", robot__radius=0.1, start={"x": 1, "y": 1}, goal=(9, 9),
                               bounds=[(0, 10), (0, 10)], time=0.3, objective="length")
        self.assertIn(result.status, ("Exact solution", "Timeout"))

    def test_same_seed_same_path(self):
        paths = [ompl_mfa.plan(SCENE, time=60, iterations=300, seed=5).path for _ in range(2)]
        self.assertTrue(np.array_equal(*paths))

    def test_other_planners_and_parameters(self):
        self.assertIn("rrtconnect", ompl_mfa.planner_names())
        self.assertTrue(ompl_mfa.plan(SCENE, planner="rrtconnect", time=1).exact)
        self.assertTrue(ompl_mfa.plan(SCENE, params={"fireflies": False, "population_size": 30}, time=0.2).exact)

    def test_bad_input(self):
        for arguments, message in (
                ({"config": "none.cfg"}, "none.cfg"),
                ({"config": SCENE, "planner": "rrtt"}, "rrtt"),
                ({"config": SCENE, "params": {"populaton_size": 3}}, "population_size"),
                ({"config": SCENE, "time": 0}, "time"),
                ({"config": SCENE, "seed": 0}, "0"),
                ({"start": (0, 0), "goal": (1, 1), "robot": "pint", "bounds": SQUARE}, "pint"),
                ({"start": (0, 0, 1, 2), "goal": (1, 1), "robot": "point", "bounds": SQUARE}, "start")):
            with self.assertRaisesRegex(ompl_mfa.InputError, message):
                ompl_mfa.plan(**arguments)
        with self.assertRaises(TypeError):
            ompl_mfa.plan()
        self.assertTrue(issubclass(ompl_mfa.InputError, ValueError))

    def test_other_threads_run(self):
        count = 0

        def work():
            nonlocal count
            while not done:
                count += 1
                time.sleep(0.001)
        done = False
        thread = threading.Thread(target=work)
        thread.start()
        ompl_mfa.plan(SCENE, time=0.5)
        done = True
        thread.join()
        self.assertGreater(count, 20)


class Solve(unittest.TestCase):
    OPTIMUM = 2 * (np.sqrt(0.32 - 0.09) + 0.3 * (np.pi / 2 - np.arccos(0.3 / np.sqrt(0.32))))

    def test_functions(self):
        for function, vectorized in ((outside_disc, False), (outside_discs, True)):
            result = ompl_mfa.solve(function, SQUARE, (0.1, 0.1), (0.9, 0.9), time=1, vectorized=vectorized)
            self.assertTrue(result.exact)
            self.assertLess(result.cost, 1.01 * self.OPTIMUM)
            self.assertGreater(result.cost, 0.995 * self.OPTIMUM)
            self.assertTrue(all(outside_disc(state) for state in result.path))

    def test_vectorized_motions_are_one_call(self):
        sizes = []

        def count(states):
            sizes.append(len(states))
            return np.ones(len(states), dtype=bool)
        ompl_mfa.solve(count, SQUARE, (0, 0), (1, 1), time=0.1, vectorized=True)
        self.assertGreater(max(sizes), 50)

    def test_spaces(self):
        half = np.pi / 2
        for space, start, goal, columns in (
                ("real", (0.1, 0.1), (0.9, 0.9), 2), ("se2", (0.1, 0.1, 0), (0.9, 0.9, half), 3),
                ("dubins", (0.1, 0.1, 0), (0.9, 0.9, half), 3), ("reedsshepp", (0.1, 0.1, 0), (0.9, 0.9, half), 3)):
            result = ompl_mfa.solve(outside_disc, SQUARE, start, goal, time=1, space=space, turning_radius=0.1)
            self.assertTrue(result.exact, space)
            self.assertEqual(result.path.shape[1], columns)
            self.assertTrue(np.allclose(result.path[[0, -1]], [start, goal], atol=1e-6), space)
        result = ompl_mfa.solve(lambda state: abs(state[2]) < 0.9, [(0, 1)] * 3, (0.1, 0.1, 0.1, 0, 0, 0, 1),
                                (0.9, 0.9, 0.8, 0, 0, 1, 0), time=0.5, space="se3")
        self.assertTrue(result.exact)
        self.assertEqual(result.path.shape[1], 7)

    def test_exceptions_pass_through(self):
        calls = 0

        def fails(_):
            nonlocal calls
            calls += 1
            if calls > 20:
                raise KeyError("mine")
            return calls % 3 != 0
        with self.assertRaisesRegex(KeyError, "mine"):
            ompl_mfa.solve(fails, SQUARE, (0.1, 0.1), (0.9, 0.9), time=20)
        self.assertEqual(calls, 21)

    def test_bad_input(self):
        for changes, message in (
                ({"bounds": [(0, 1)], "space": "se2", "start": (0, 0, 0), "goal": (1, 1, 0)}, "bounds"),
                ({"bounds": [(0, 1), (1, 0)]}, "coordinate 1"), ({"bounds": [(0, np.inf), (1, 2)]}, "coordinate 0"),
                ({"start": (0.1,)}, "start has 1"), ({"goal": (0.1, np.nan)}, "goal"), ({"goal": (0.1, 7)}, "goal"),
                ({"resolution": 0}, "resolution"), ({"space": "se4"}, "se4"), ({"planner": "x"}, "planner"),
                ({"vectorized": True, "is_valid": lambda states: [True]}, "returned 1 values"),
                ({"space": "se3", "bounds": [(0, 1)] * 3, "start": (0, 0, 0, 1, 1, 1, 1), "goal": (1, 1, 1, 0, 0, 0, 1)},
                 "quaternion")):
            arguments = {"is_valid": outside_disc, "bounds": SQUARE, "start": (0.1, 0.1), "goal": (0.9, 0.9), **changes}
            with self.assertRaisesRegex(ompl_mfa.InputError, message):
                ompl_mfa.solve(**arguments)

    def test_interrupt(self):
        for call in ("solve(lambda state: True, [(0, 1)] * 2, (0, 0), (1, 1), time=60, planner='rrtstar')",
                     f"plan({SCENE!r}, time=60)",
                     "minimize(lambda x: 1.0, [(0, 1)], max_generations=10**9)"):
            script = textwrap.dedent(f"""
                import ompl_mfa
                print("ready", flush=True)
                ompl_mfa.{call}
            """)
            with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE) as process:
                process.stdout.readline()
                time.sleep(0.5)
                process.send_signal(signal.SIGINT)
                errors = process.communicate(timeout=20)[1].decode()
                self.assertIn("KeyboardInterrupt", errors)


class Optimize(unittest.TestCase):
    BOX = [(-5, 5)] * 3

    def test_minimize(self):
        for algorithm, accuracy in (("mfa", 1e-6), ("fa", 1)):
            result = ompl_mfa.minimize(lambda x: float((x ** 2).sum()), self.BOX, algorithm, seed=3)
            self.assertLess(result.fun, accuracy)
            self.assertAlmostEqual(result.fun, float((result.x ** 2).sum()))
            self.assertEqual(result.nit, 50)
            self.assertTrue(result.success)
            self.assertEqual(result.population.shape, (100, 3))

    def test_vectorized_is_the_same_run_in_few_calls(self):
        calls = []

        def squares(x):
            calls.append(x.shape)
            return (x ** 2).sum(axis=0)
        for algorithm in ("mfa", "fa"):
            calls.clear()
            many = ompl_mfa.minimize(squares, self.BOX, algorithm, seed=4, vectorized=True)
            single = ompl_mfa.minimize(lambda x: float((x ** 2).sum()), self.BOX, algorithm, seed=4)
            self.assertEqual(many.fun, single.fun)
            self.assertEqual(many.nfev, single.nfev)
            self.assertLess(len(calls), many.nfev / 2)
            self.assertTrue(all(shape[0] == 3 for shape in calls))
            # an interrupted generation goes on with the same points
            parts = ompl_mfa.FireflyOptimizer([-5] * 3, [5] * 3, algorithm, seed=4)
            limit = 0
            while parts.generation < 50:
                limit += 37
                parts.step(squares, vectorized=True, max_evaluations=limit)
            self.assertEqual(parts.best_value, single.fun)

    def test_limits_and_callback(self):
        result = ompl_mfa.minimize(lambda x: float((x ** 2).sum()), self.BOX, max_evaluations=333)
        self.assertEqual(result.nfev, 333)
        self.assertIn("max_evaluations", result.message)
        result = ompl_mfa.minimize(lambda x: float((x ** 2).sum()), self.BOX, callback=lambda r: r.nit >= 3)
        self.assertEqual(result.nit, 3)
        start = np.array([[1e-9, 0, 0]])
        result = ompl_mfa.minimize(lambda x: float((x ** 2).sum()), self.BOX, max_generations=0, x0=start)
        self.assertLessEqual(result.fun, 1e-18)

    def test_bad_input(self):
        for arguments in ({"bounds": [1, 2]}, {"bounds": [(1, 0)]}, {"algorithm": "xfa"}, {"population": 1},
                          {"alpha": -1}, {"x0": [1, 2]}):
            with self.assertRaises(ValueError):
                ompl_mfa.minimize(**{"f": lambda x: 0.0, "bounds": self.BOX, **arguments})
        with self.assertRaises(ZeroDivisionError):
            ompl_mfa.minimize(lambda x: 1 / 0, self.BOX)
        with self.assertRaisesRegex(ValueError, "returned 2 values"):
            ompl_mfa.minimize(lambda x: [1, 2], self.BOX, vectorized=True)

    def test_optimizer(self):
        optimizer = ompl_mfa.FireflyOptimizer([-1, -1], [1, 1], population=10, seed=2)
        self.assertEqual(optimizer.best_value, np.inf)
        optimizer.inject([0.5, 0.5])
        self.assertTrue(optimizer.step(lambda x: float(abs(x).sum())))
        self.assertIn([0.5, 0.5], optimizer.population.tolist())
        self.assertEqual(optimizer.evaluations, 10)
        with self.assertRaises(RuntimeError):
            optimizer.inject([0, 0])
        optimizer.step(lambda x: float("nan"))
        self.assertTrue(np.isfinite(optimizer.best_value))


class Campaigns(unittest.TestCase):
    def test_benchmark(self):
        with tempfile.TemporaryDirectory() as folder:
            config = os.path.join(folder, "small.cfg")
            with open(SCENE, encoding="utf-8") as scene:
                problem = scene.read().split("[benchmark]")[0]
            with open(config, "w", encoding="utf-8") as out:
                out.write(problem + "[benchmark]\ntime_limit = 0.2\nrun_count = 2\n[planner]\nmfa =\nrrtconnect =\n")
            environment = dict(os.environ, OMPL_MFA_RESOURCE_DIR=os.path.dirname(SCENE))
            os.environ.update(environment)
            log = os.path.join(folder, "out.log")
            database = os.path.join(folder, "out.db")
            results = ompl_mfa.benchmark(config, log, jobs=2, database=database)
            self.assertEqual(sorted(results.runs["planner"]), ["MFA", "MFA", "RRTConnect", "RRTConnect"])
            self.assertTrue(np.all(results.runs["solved"]))
            self.assertEqual(results.runs["path_cost"].dtype, float)
            self.assertEqual(results.runs["seed"].dtype, np.int64)
            self.assertGreater(len(results.progress["time"]), 10)
            self.assertEqual(results.time_limit, 0.2)
            self.assertTrue(os.path.getsize(database) > 0)
            again = ompl_mfa.read_results(log)
            self.assertEqual(again.runs.keys(), results.runs.keys())
            with self.assertRaisesRegex(ompl_mfa.InputError, "nothing.cfg"):
                ompl_mfa.benchmark(os.path.join(folder, "nothing.cfg"), log)
            with self.assertRaises(ompl_mfa.InputError):
                ompl_mfa.read_results(config)


class Package(unittest.TestCase):
    def test_every_public_name_is_documented(self):
        for name in ompl_mfa.__all__:
            value = getattr(ompl_mfa, name)
            if callable(value) and value is not ompl_mfa.InputError:
                self.assertTrue(value.__doc__ and len(value.__doc__) > 20, name)

    def test_types_name_what_is_compiled(self):
        with open(os.path.join(os.path.dirname(ompl_mfa.__file__), "_core.pyi"), encoding="utf-8") as stub:
            text = stub.read()
        for name in dir(ompl_mfa._core):
            if not name.startswith("_"):
                self.assertRegex(text, rf"(class|def) {name}\b|^{name}:|\n{name}:")
        for name in dir(ompl_mfa.FireflyOptimizer):
            if not name.startswith("_"):
                self.assertIn(f"def {name}(", text)


if __name__ == "__main__":
    unittest.main()
