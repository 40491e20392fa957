# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy looks at what changed."""
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

    def test_a_first_commit_has_nothing_to_be_compared_with(self):
        self.assertIsNone(check_tidy.changed(self.root))

    def test_what_the_last_commit_changed_and_what_is_not_committed(self):
        self.write("src/endmill/core/vec.cpp", "// changed\n")
        self.commit()
        self.assertEqual(check_tidy.changed(self.root), [self.vec])
        new = self.write("src/endmill/core/new.cpp")
        self.write("tests/core/angle_test.cpp", "// changed\n")
        self.assertEqual(check_tidy.changed(self.root), sorted([new, self.vec, self.angle_test]))

    def test_a_branch_is_compared_with_where_it_left_main(self):
        self.git("update-ref", "refs/remotes/origin/main", "HEAD")
        for text in ("// one\n", "// two\n"):
            self.write("src/endmill/core/vec.cpp", text)
            self.commit()
            self.write("README.md", text)
            self.commit()
        self.assertEqual(check_tidy.changed(self.root), [self.root / "README.md", self.vec])

    def test_a_deleted_file_is_not_looked_at(self):
        self.vec.unlink()
        self.commit()
        self.assertEqual(check_tidy.changed(self.root), [])

    def test_a_header_is_looked_at_through_the_file_of_its_name(self):
        header = self.write("src/endmill/core/vec.h")
        self.assertEqual(check_tidy.select([header], self.compiled), [self.vec])

    def test_a_header_without_one_is_looked_at_through_a_file_that_includes_it(self):
        header = self.write("src/endmill/core/angle.h")
        self.assertEqual(check_tidy.select([header], self.compiled), [self.angle_test])

    def test_what_is_not_compiled_is_not_looked_at(self):
        files = [self.write("README.md"), self.write("src/endmill/core/lonely.h")]
        self.assertEqual(check_tidy.select(files, self.compiled), [])

    def test_files_that_are_compiled_together_are_looked_at_alone(self):
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
