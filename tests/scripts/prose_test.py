# SPDX-License-Identifier: GPL-3.0-or-later
"""A README becomes HTML with its text and without scripts."""
import unittest

import fake_tree  # noqa: F401 (finds the scripts)
from reproduction.prose import listed, read

README = """# Table 1: counts

| | |
| --- | --- |
| Claim | about 25 % fewer, `NCL` |
| Command | `run it` |
| Compared | with `expected.csv` |

Free text in
two lines.

- one
- two,
  gone on

| column | unit |
|---|---|
| `a` | mm |

```
| no table |
```
"""


class Prose(unittest.TestCase):
    def test_title_claim_and_body_are_converted(self):
        readme = read(README, "fallback")
        self.assertEqual(readme.title, "Table 1: counts")
        self.assertEqual(readme.claim, "about 25 % fewer, <code>NCL</code>")
        self.assertEqual(readme.compared, "with <code>expected.csv</code>")
        self.assertNotIn("Claim", readme.body)
        self.assertNotIn("Compared", readme.body)
        for html in ("<td>Command</td><td><code>run it</code></td>",
                     "<p>Free text in two lines.</p>", "<ul><li>one</li><li>two, gone on</li></ul>",
                     "<tr><th>column</th><th>unit</th></tr>", "<pre>| no table |</pre>"):
            self.assertIn(html, readme.body)

    def test_comment_before_the_title_is_left_out(self):
        licence = "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n"
        self.assertEqual(read(licence + README, "fallback"), read(README, "fallback"))

    def test_comment_in_a_fenced_block_is_text(self):
        self.assertIn("&lt;!-- kept --&gt;", read("```\n<!-- kept -->\n```\n", "").body)

    def test_fallback_is_the_title_without_a_heading(self):
        for text in ("", "Only text.", "## Second"):
            self.assertEqual(read(text, "fallback").title, "fallback")

    def test_empty_table_head_is_left_out(self):
        self.assertNotIn("<th></th>", read(README, "").body)

    def test_link_has_the_address_that_the_page_gives_it(self):
        addresses = {"table-1": "#paper-table-1", "a\"b": "#<&\""}
        body = read("[one](table-1), [two](other) and [three](a\"b)", "", addresses.get).body
        self.assertEqual(body, '<p><a href="#paper-table-1">one</a>, two and <a href="#&lt;&amp;&quot;">three</a></p>')

    def test_items_of_a_section_are_listed(self):
        text = "# Title\n\n- no\n\n## In short\n\n- one\n- two,\n  **gone** on\n\n## Next\n\n- no\n"
        self.assertEqual(listed(text, "In short"), ["one", "two, <strong>gone</strong> on"])
        self.assertEqual(listed("text", "In short"), [])

    def test_text_is_escaped(self):
        for payload in ("<script>alert(1)</script>", "<img src=x onerror=alert(1)>",
                        "[text](javascript:alert)", '`"><script>`', "**<b onload=x>**"):
            for text in (payload, f"## {payload}", f"- {payload}", f"| {payload} |",
                         f"```\n{payload}\n```"):
                body = read(text, "").body
                for live in ("<script", "<img", "<b ", "href"):
                    self.assertNotIn(live, body)


if __name__ == "__main__":
    unittest.main()
