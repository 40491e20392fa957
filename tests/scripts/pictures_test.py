# SPDX-License-Identifier: GPL-3.0-or-later
"""Which commands make the pictures of docs/images."""
import re
import unittest

import fake_tree  # noqa: F401  puts scripts/ on the path

import write_pictures
from write_pictures import COSTLY, IMAGES, PICTURES, ROOT, needed_commands


class Pictures(unittest.TestCase):
    def test_every_picture_is_shown_and_made(self):
        pages = [ROOT / "README.md", *(ROOT / "docs/guide").glob("*.md")]
        shown = {name for page in pages
                 for name in re.findall(r"images/([\w-]+\.svg)", page.read_text(encoding="utf-8"))}
        self.assertEqual(shown, {*PICTURES, *COSTLY})
        self.assertEqual(shown, {path.name for path in IMAGES.glob("*.svg")})

    def test_commands_that_write_the_input_come_first(self):
        for picture in PICTURES.values():
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
