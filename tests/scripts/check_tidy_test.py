# SPDX-License-Identifier: GPL-3.0-or-later
"""check_tidy.py selects the changed files."""
import unittest

from fake_tree import FakeTree

import check_tidy


class Tidy(FakeTree):
    def setUp(self):
        super().setUp()
        self.git("init", "--initial-branch=main")
        self.vec = self.write("src/endmill/core/vec.cpp", '#include "endmill/core/vec.h"\n')
        includes_angle = '#include "endmill/core/angle.h"\n'
        self.angle_test = self.write("tests/core/angle_test.cpp", includes_angle)
        self.compiled = [self.vec, self.angle_test]
        self.commit()

    def commit(self):
        self.git("add", ".")
        self.git("commit", "--message", "a step")

    def test_first_commit_has_no_commit_to_compare_with(self):
        self.assertIsNone(check_tidy.changed(self.root))

    def test_changes_include_the_last_commit_and_uncommitted_files(self):
        self.write("src/endmill/core/vec.cpp", "// changed\n")
        self.commit()
        self.assertEqual(check_tidy.changed(self.root), [self.vec])
        new = self.write("src/endmill/core/new.cpp")
        self.write("tests/core/angle_test.cpp", "// changed\n")
        self.assertEqual(check_tidy.changed(self.root), sorted([new, self.vec, self.angle_test]))

    def test_branch_is_compared_with_its_merge_base(self):
        self.git("update-ref", "refs/remotes/origin/main", "HEAD")
        for text in ("// one\n", "// two\n"):
            self.write("src/endmill/core/vec.cpp", text)
            self.commit()
            self.write("README.md", text)
            self.commit()
        self.assertEqual(check_tidy.changed(self.root), [self.root / "README.md", self.vec])

    def test_deleted_file_is_not_checked(self):
        self.vec.unlink()
        self.commit()
        self.assertEqual(check_tidy.changed(self.root), [])

    def test_header_is_checked_through_the_source_of_its_name(self):
        header = self.write("src/endmill/core/vec.h")
        self.assertEqual(check_tidy.select([header], self.compiled), [self.vec])

    def test_header_without_a_source_is_checked_through_an_includer(self):
        header = self.write("src/endmill/core/angle.h")
        self.assertEqual(check_tidy.select([header], self.compiled), [self.angle_test])

    def test_files_that_are_not_compiled_are_not_checked(self):
        files = [self.write("README.md"), self.write("src/endmill/core/lonely.h")]
        self.assertEqual(check_tidy.select(files, self.compiled), [])

    def test_files_of_a_unity_build_are_checked_separately(self):
        parts = [self.write("src/cli/plan.cpp"), self.write("src/cli/trim.cpp")]
        text = "".join(f'#include "{part}"\n' for part in parts)
        unity = self.write("build/release/Unity/unity_0_cxx.cxx", text)
        together = {"directory": str(self.root), "file": str(unity), "command": f"c++ -c {unity}"}
        self.assertEqual(check_tidy.each_alone(together),
                         [{"directory": str(self.root), "file": str(part),
                           "command": f"c++ -c {part}"} for part in parts])
        alone = {"directory": str(self.root), "file": str(parts[0]), "command": "c++"}
        self.assertEqual(check_tidy.each_alone(alone), [alone])


if __name__ == "__main__":
    unittest.main()
