# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of sources finds each kind of source that leads nowhere."""
import unittest

from fake_tree import FakeTree

import check_sources


class Sources(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("paper/references.bib", "@misc{KimChoi,\n  title = {x}\n}\n")
        self.write("docs/mathematics/removal.md", "# Removal\n\n## 4. Vectors\n\n### 4.1 Ramps\n")

    def check_comment(self, *lines):
        text = "".join(f"/// {line}\n" for line in lines)
        self.write("src/endmill/core/vec.h", f"// SPDX\n{text}double x;\n")
        return self.check(check_sources.main, self.root)

    def assert_good(self, *lines):
        self.assertEqual(self.check_comment(*lines),
                         (0, "1 sources, all in the repository or in a cited work\n"))

    def assert_found(self, words, *lines):
        code, printed = self.check_comment(*lines)
        self.assertEqual(code, 1, printed)
        self.assertIn(words, printed)

    def test_an_equation_of_a_cited_paper(self):
        self.assert_good("Area.", "Source: [KimChoi, eq. (4), (15)].")

    def test_a_section_of_a_page(self):
        self.assert_good("Source: docs/mathematics/removal.md, section 4.1.")

    def test_a_source_over_two_lines(self):
        self.assert_good("Source: the ramp of", "docs/mathematics/removal.md, section 4.")

    def test_a_key_that_is_not_in_the_bibliography(self):
        self.assert_found("[Nobody] is not in", "Source: [Nobody, eq. (4)].")

    def test_a_paper_without_a_number(self):
        self.assert_found("has no number", "Source: [KimChoi].")

    def test_a_page_that_does_not_exist(self):
        self.assert_found("does not exist", "Source: docs/mathematics/forces.md, section 1.")

    def test_a_section_that_does_not_exist(self):
        self.assert_found("has no section 5", "Source: docs/mathematics/removal.md, section 5.")

    def test_a_source_that_names_nothing(self):
        self.assert_found("names neither", "Source: a well-known formula.")

    def test_a_source_after_the_paragraph_does_not_count(self):
        self.assert_found("names neither", "Source: a formula.", "", "See [KimChoi, eq. (4)].")

    def test_a_specification_outside_the_repository(self):
        self.assert_found("specification", "As the spec of removal has it.")


if __name__ == "__main__":
    unittest.main()
