"""What port/python/README.md shows is what happens: its pycon blocks, one session."""
import doctest
import os
import re
import unittest

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "port", "python", "README.md")


class Page(unittest.TestCase):
    def test_the_page_shows_what_happens(self):
        with open(PAGE) as file:
            session = "\n".join(re.findall(r"^```pycon\n(.*?)^```$", file.read(), re.S | re.M))
        test = doctest.DocTestParser().get_doctest(session, {}, "README.md", PAGE, 0)
        self.assertGreater(len(test.examples), 5)
        said = []
        doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=said.append)
        self.assertEqual("".join(said), "")


if __name__ == "__main__":
    unittest.main()
