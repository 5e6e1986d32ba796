"""Runs the suites beside it that need no more than the standard library; ends with `N passed, N failed`.

    python3 run.py [NAME...]        as unittest names them: test_scene.Verdicts
"""
import os
import sys
import unittest

os.environ.setdefault("PYTHONDONTWRITEBYTECODE", "1")
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
names = sys.argv[1:] or ["test_scene", "test_page", "test_kit"]
result = unittest.TextTestRunner(stream=sys.stdout, verbosity=0).run(unittest.defaultTestLoader.loadTestsFromNames(names))
bad = len(result.failures) + len(result.errors)
for test, why in result.skipped:
    print("skipped: %s (%s)" % (test, why))
print("%d passed, %d failed" % (result.testsRun - bad - len(result.skipped), bad))
sys.exit(bad > 0)
