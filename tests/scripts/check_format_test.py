# SPDX-License-Identifier: GPL-3.0-or-later
"""check_format.py reports unformatted files and leftovers of a merge."""
import unittest

from fake_tree import FakeTree

import check_format


class Format(FakeTree):
    def setUp(self):
        super().setUp()
        self.git("init", "--initial-branch=main")

    def test_staged_leftovers_are_reported(self):
        for name in ("src/endmill/core/vec.h.orig", "README.md.rej"):
            self.write(name, "<<<<<<<\n")
            self.assertEqual(self.check(check_format.main, self.root)[0], 0)
            self.git("add", ".")
            code, said = self.check(check_format.main, self.root)
            self.assertEqual(code, 1)
            self.assertIn(f"{name} is left over", said)
            self.git("rm", "--force", name)
        self.assertEqual(self.check(check_format.main, self.root)[0], 0)

    def test_similar_names_are_accepted(self):
        self.write("scripts/original.py")
        self.write("datasets/orig/README.md")
        self.git("add", ".")
        self.assertEqual(self.check(check_format.main, self.root)[0], 0)


class OutsideARepository(FakeTree):
    def test_folder_outside_a_repository_has_no_leftovers(self):
        self.write("a.orig")
        self.assertEqual(self.check(check_format.main, self.root)[0], 0)


if __name__ == "__main__":
    unittest.main()
