# SPDX-License-Identifier: GPL-3.0-or-later
"""Which commands make the pictures of docs/images."""
import re
import unittest

import fake_tree  # noqa: F401  puts scripts/ on the path

import write_pictures
from write_pictures import COSTLY, IMAGES, PAGE_PICTURES, PICTURES, ROOT, needed_commands


class Pictures(unittest.TestCase):
    def test_every_picture_is_shown_and_made(self):
        pages = [ROOT / "README.md", *(ROOT / "docs/guide").glob("*.md")]
        shown = {name for page in pages
                 for name in re.findall(r"images/([\w-]+\.(?:svg|png))", page.read_text(encoding="utf-8"))}
        self.assertEqual(shown, {*PICTURES, *PAGE_PICTURES, *COSTLY})
        self.assertEqual(shown, {path.name for path in IMAGES.glob("*.*g")})

    def test_pictures_of_pages_are_small_and_1280_pixels_wide(self):
        for name in PAGE_PICTURES:
            data = (IMAGES / name).read_bytes()
            self.assertLess(len(data), 150_000, name)
            self.assertEqual(int.from_bytes(data[16:20], "big"), 1280, name)  # width in the header of a PNG file

    def test_every_command_with_a_page_has_its_picture(self):
        commands = {path.stem for path in (ROOT / "src/cli").glob("*.cpp")
                    if "write_html(" in path.read_text(encoding="utf-8")}
        self.assertEqual({f"page-{command}.png" for command in commands}, set(PAGE_PICTURES))

    def test_commands_that_write_the_input_come_first(self):
        for picture in [*PICTURES.values(), *PAGE_PICTURES.values()]:
            folder = picture.file.split("/")[0]
            *before, last = needed_commands(picture.page, folder)
            self.assertIn(folder, write_pictures.folder_of(last), picture)
            made = {"datasets", *(made for command in before for made in write_pictures.folder_of(command))}
            for word in last.split():
                if "/" in word and not word.startswith("W/"):
                    self.assertIn(word.split("/")[0], made, last)
        plan, verify = needed_commands("README.md", "checked")
        self.assertTrue(plan.startswith("endmill plan") and verify.startswith("endmill verify"))

    def test_an_unknown_name_is_refused(self):
        with self.assertRaises(SystemExit) as refused:
            write_pictures.main(["--check", "none.svg"])
        self.assertEqual(refused.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
