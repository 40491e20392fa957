# SPDX-License-Identifier: GPL-3.0-or-later
"""filter_markdown.py converts Markdown to pages with labels and links."""
from pathlib import Path

import unittest

from fake_tree import FakeTree

from filter_markdown import filtered


class Filter(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("README.md", "# Project\n")
        self.write("docs/guide/plan.md", "# Plan\n")
        self.write("docs/conventions.md", "# Conventions\n")
        self.write("src/endmill/core/README.md", "# core\n")
        self.write("datasets/a.json", "{}\n")
        self.write("docs/images/plan.svg", "<svg/>\n")

    def page(self, text, name="docs/guide/plan.md"):
        return filtered(self.root, Path(name), text)

    def test_headings_get_labels_and_the_readme_is_the_main_page(self):
        self.assertEqual(self.page("<!-- SPDX-License-Identifier: X -->\n# Plan\n\n## Exit codes\n"),
                         "# Plan {#page_docs_guide_plan}\n\n"
                         "## Exit codes {#page_docs_guide_plan_exit-codes}\n")
        self.assertEqual(self.page("# Project\n", "README.md"), "# Project {#mainpage}\n")

    def test_links_to_pages_headings_and_folders_become_labels(self):
        for target, label in (("../conventions.md", "page_docs_conventions"),
                              ("../conventions.md#units", "page_docs_conventions_units"),
                              ("#units", "page_docs_guide_plan_units"),
                              ("../../src/endmill/core", "page_src_endmill_core_README"),
                              ("../../README.md", "index")):
            self.assertEqual(self.page(f"see [it]({target})\n"), f"see [it](@ref {label})\n")

    def test_links_to_other_files_become_text_and_links_to_sites_stay(self):
        self.assertEqual(self.page("[data](../../datasets/a.json) [web](https://example.org/a.md)\n"),
                         "data [web](https://example.org/a.md)\n")

    def test_broken_links_give_a_warning_of_doxygen(self):
        self.assertEqual(self.page("[it](../gone.md)\n"), "[it](../gone.md)\n")
        self.assertEqual(self.page("![it](gone.svg)\n"), "@ref no_image_gone_svg\n")

    def test_images_lose_their_folders(self):
        self.assertEqual(self.page("![A path](../images/plan.svg)\n"), "![A path](plan.svg)\n")

    def test_code_is_unchanged(self):
        code = "```sh\n# no heading\n[no](../conventions.md)\n```\n"
        self.assertEqual(self.page(code), code)


if __name__ == "__main__":
    unittest.main()
