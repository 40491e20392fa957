# SPDX-License-Identifier: GPL-3.0-or-later
"""Formatted files only, and nothing that a merge left behind."""
import unittest

from fake_tree import FakeTree

import check_format


class Format(FakeTree):
    def setUp(self):
        super().setUp()
        self.git("init", "--initial-branch=main")

    def test_leftovers_are_complained_of_once_they_are_to_be_committed(self):
        for name in ("src/endmill/core/vec.h.orig", "README.md.rej"):
            self.write(name, "<<<<<<<\n")
            self.assertEqual(self.check(check_format.main, self.root)[0], 0)
            self.git("add", ".")
            code, said = self.check(check_format.main, self.root)
            self.assertEqual(code, 1)
            self.assertIn(f"{name} is left over", said)
            self.git("rm", "--force", name)
        self.assertEqual(self.check(check_format.main, self.root)[0], 0)

    def test_names_that_only_look_like_it_are_welcome(self):
        self.write("scripts/original.py")
        self.write("datasets/orig/README.md")
        self.git("add", ".")
        self.assertEqual(self.check(check_format.main, self.root)[0], 0)


class OutsideARepository(FakeTree):
    def test_there_is_nothing_committed(self):
        self.write("a.orig")
        self.assertEqual(self.check(check_format.main, self.root)[0], 0)


if __name__ == "__main__":
    unittest.main()
