# SPDX-License-Identifier: GPL-3.0-or-later
"""check_sources.py reports each kind of source without a valid target, and headers that do not exist."""
import unittest

from fake_tree import FakeTree

import check_sources


class Sources(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("paper/references.bib", "@misc{KimChoi,\n  title = {x}\n}\n")
        self.write("docs/methods/removal.md", "# Removal\n\n## 4. Vectors\n\n### 4.1 Ramps\n")

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

    def test_equation_of_a_cited_paper_is_accepted(self):
        self.assert_good("Area.", "Source: [KimChoi, eq. (4), (15)].")

    def test_section_of_a_page_is_accepted(self):
        self.assert_good("Source: docs/methods/removal.md, section 4.1.")

    def test_source_over_two_lines_is_accepted(self):
        self.assert_good("Source: the ramp of", "docs/methods/removal.md, section 4.")

    def test_key_outside_the_bibliography_is_reported(self):
        self.assert_found("[Nobody] is not in", "Source: [Nobody, eq. (4)].")

    def test_paper_without_a_number_is_reported(self):
        self.assert_found("has no number", "Source: [KimChoi].")

    def test_missing_page_is_reported(self):
        self.assert_found("does not exist", "Source: docs/methods/forces.md, section 1.")

    def test_missing_section_is_reported(self):
        self.assert_found("has no section 5", "Source: docs/methods/removal.md, section 5.")

    def test_source_without_a_target_is_reported(self):
        self.assert_found("names neither", "Source: a well-known formula.")

    def test_source_ends_with_its_paragraph(self):
        self.assert_found("names neither", "Source: a formula.", "", "See [KimChoi, eq. (4)].")

    def test_mention_of_a_specification_is_reported(self):
        self.assert_found("specification", "As the spec of removal has it.")

    def test_mention_of_a_specification_in_python_is_reported(self):
        for text in ('"""As the spec of removal has it."""\n', "x = 1  # see the specification\n",
                     'def f():\n    """The vectors\n    of the spec."""\n'):
            self.write("tests/cli/new_test.py", text)
            self.assert_found("tests/cli/new_test.py:", "Source: [KimChoi, eq. (4)].")
        self.write("tests/cli/new_test.py", '"""Specialised."""\nspec = "spec"  # not a "spec"\n')
        self.assert_good("Source: [KimChoi, eq. (4)].")


class NamedHeaders(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("paper/references.bib")
        for name in ("core.h", "core/vec.h", "core/detail/line.h", "mesh/weld.h"):
            self.write(f"src/endmill/{name}", "// SPDX\n")

    def check_readme(self, text, readme="core/README.md"):
        self.write(f"src/endmill/{readme}", text)
        return self.check(check_sources.main, self.root)

    def test_headers_of_any_module_are_accepted(self):
        text = "`vec.h`: `line.h`, `detail/line.h`, (weld.h), `mesh/weld.h`, `endmill/core/vec.h`, `endmill/core.h`.\n"
        self.assertEqual(self.check_readme(text)[0], 0)
        text = "| `mesh` | `weld.h` |, `endmill/<module>.h`\n"
        self.assertEqual(self.check_readme(text, "README.md")[0], 0)

    def test_missing_headers_are_reported_with_their_line(self):
        for name in ("stock_fronts.h", "detail/vec.h", "core/weld.h", "endmill/mesh.h"):
            with self.subTest(name=name):
                code, printed = self.check_readme(f"# core\n\n| x | `vec.h`, `{name}` |\n")
                self.assertEqual(code, 1)
                self.assertEqual(printed, f"src/endmill/core/README.md:3: no header {name}\n")


if __name__ == "__main__":
    unittest.main()
