"""What the pages show is what happens: the pycon blocks of each, one session."""
import doctest
import os
import re
import unittest

PORT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "port")


class Page(unittest.TestCase):
    def shows(self, *path):
        with open(os.path.join(PORT, *path)) as file:
            session = "\n".join(re.findall(r"^```pycon\n(.*?)^```$", file.read(), re.S | re.M))
        test = doctest.DocTestParser().get_doctest(session, {}, path[-1], path[-1], 0)
        self.assertGreater(len(test.examples), 4)
        said = []
        doctest.DocTestRunner().run(test, out=said.append)
        self.assertEqual("".join(said), "")

    def test_the_page_of_python_shows_what_happens(self):
        self.shows("python", "README.md")

    def test_the_page_of_the_oracle_shows_what_happens(self):
        self.shows("ORACLE.md")


if __name__ == "__main__":
    unittest.main()
