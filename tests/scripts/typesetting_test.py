# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of the paper come from CSV files and are rounded to what the comparison needs."""
import unittest

from fake_tree import ROOT, FakeTree
from reproduction.fault import Fault
from typesetting.__main__ import definitions, list_cells, prepare, resolve_all, sources
from typesetting.bibliography import latin_bibliography
from typesetting.calls import find_calls
from typesetting.cells import Cells
from typesetting.claims_table import claims_table, merged, read_claims
from typesetting.numbers import escape, fixed, formatted, grouped, significant
from typesetting.typed import read_allowed, typed_numbers

CLAIMS = "id,paper,place,kind,claim,experiment,row,column,verdict\n"


class Numbers(FakeTree):
    def test_five_digits_are_grouped_and_four_are_not(self):
        self.assertEqual([grouped(text) for text in ("1061", "20809.3", "-148240")],
                         ["1061", r"20\,809.3", r"\ensuremath{-}148\,240"])

    def test_significant_digits_are_never_in_scientific_notation(self):
        self.assertEqual([significant(value, 3) for value in (0.0123456, 12.3456, 1234.5, 0, 0.9999)],
                         ["0.0123", "12.3", "1230", "0", "1.00"])

    def test_a_rounded_zero_has_no_sign(self):
        self.assertEqual(fixed(-0.001, 1), "0.0")

    def test_forms(self):
        self.assertEqual([formatted(0.12345, form) for form in ("2", "s2", "p1")], ["0.12", "0.12", "12.3"])
        self.assertEqual(formatted(0.00012, "e1"), r"\ensuremath{1.2\cdot10^{-4}}")
        with self.assertRaises(Fault):
            formatted(1, "%")

    def test_letters_without_latex_are_refused(self):
        self.assertEqual(escape("5 % of λ"), r"5 \% of \ensuremath{\lambda}")
        with self.assertRaises(Fault):
            escape("곡면")


class Calls(FakeTree):
    def calls(self, text):
        return find_calls(self.write("a.tex", text))

    def test_arguments_lose_their_escapes_and_keep_their_place(self):
        call = self.calls("\n\\computed[1]{p/i}{share, \\%}{a_b}")[0]
        self.assertEqual((call.name, call.form, call.plain), ("computed", "1", ("p/i", "share, %", "a_b")))
        self.assertTrue(call.place.endswith("a.tex:2"))

    def test_both_are_two_calls(self):
        self.assertEqual([call.name for call in self.calls(r"\both{p/i}{r}{c}")], ["published", "computed"])

    def test_comments_and_longer_names_are_no_calls(self):
        self.assertEqual(self.calls("% \\computed{a}{b}{c}\n\\computedvalue{a}{b}{c}"), [])

    def test_missing_argument_is_refused_with_its_place(self):
        with self.assertRaisesRegex(Fault, "a.tex:1: .computed needs 3"):
            self.calls(r"\computed{p/i}{r}")


class CellsOfAnExperiment(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("experiments/p/i/published.csv",
                   "row,column,published,digits,verdict,claim,quantity\n"
                   "a,x,25,0,reproduced,,\na,y,0.3680141,7,differs,,\nb,x,<= 3,,differs,it is small,size in mm\n")
        self.write("experiments/p/i/params.json", '{"parameters": {"grid": [100, 0.5]}}')
        self.write("results/p/i/result.csv", "row,x,y\na,25.08,0.3680129\nb,4,\nc,,yes\n")
        claims = read_claims(self.write("claims.csv", CLAIMS
                                        + "K-1,interference,section 1,sentence,it is small,p/i,b,x,differs\n"))
        self.cells = Cells(self.root, self.root / "results", claims)

    def text(self, source):
        return self.cells.resolve(find_calls(self.write("a.tex", source))[0])

    def test_computed_number_has_the_digits_of_the_print(self):
        self.assertEqual(self.text(r"\computed{p/i}{a}{x}"), "25")
        self.assertEqual(self.text(r"\computed[2]{p/i}{a}{x}"), "25.08")

    def test_computed_number_shows_its_difference_from_the_print(self):
        self.assertEqual(self.text(r"\computed{p/i}{a}{y}"), "0.3680129")

    def test_other_macros(self):
        for source, text in ((r"\published{p/i}{a}{x}", "25"), (r"\verdict{p/i}{a}{y}", "differs"),
                             (r"\parameter{p/i}{grid/1}", "0.5"), (r"\largest{p/i}{*}{x}", "25.1"),
                             (r"\quotient[1]{p/i}{a}{x}{b}{x}", "6.3"), (r"\howmany{p/i}{*}{x}{> 5}", "1"),
                             (r"\claimcount{interference}{differs}", "1"), (r"\claimverdict{K-1}", "differs")):
            self.assertEqual(self.text(source), text, source)

    def test_claim_line_shows_what_decides_it(self):
        self.assertIn(r"& size in mm: 4; holds if \ensuremath{\le} 3 & differs", self.text(r"\claimline{K-1}"))

    def test_cells_are_defined_for_latex_and_listed_with_their_place(self):
        calls = find_calls(self.write("a.tex", r"\computed[2]{p/i}{a}{x}"))
        texts = resolve_all(self.cells, calls)
        self.assertEqual(definitions(texts), "\\definecell{\\detokenize{computed|2|p/i|a|x}}{25.08}\n")
        self.assertEqual(list_cells(calls, texts), "a.tex:1 \\computed p/i | a | x = 25.08\n")

    def test_split_claim_is_shown_by_its_first_part_if_its_verdict_is_one(self):
        row = "K-2{},interference,section 1,sentence,part {},p/i,b,x,{}\n"
        for second, shown in (("differs", True), ("reproduced", False)):
            claims = read_claims(self.write("split.csv", CLAIMS + row.format("a", 1, "differs")
                                            + row.format("b", 2, second)))
            cells = Cells(self.root, self.root / "results", claims)
            if shown:
                self.assertEqual(cells.claimverdict("", "K-2"), "differs")
            else:
                with self.assertRaisesRegex(Fault, "several verdicts"):
                    cells.claimverdict("", "K-2")

    def test_missing_cell_is_named_with_file_and_line(self):
        for source, words in ((r"\computed{p/i}{z}{x}", "no row 'z'"), (r"\computed{p/i}{a}{z}", "no column 'z'"),
                              (r"\computed{p/i}{c}{x}", "is empty"), (r"\computed{p/j}{a}{x}", "reproduce.sh p/j"),
                              (r"\published{p/i}{a}{z}", "published.csv has no row 'a'"),
                              (r"\parameter{p/i}{grid/9}", "no parameter 'grid/9'"),
                              (r"\claimverdict{K-2}", "no claim 'K-2'")):
            with self.assertRaisesRegex(Fault, words):
                self.text("\n" + source)
            with self.assertRaisesRegex(Fault, "a.tex:2"):
                self.text("\n" + source)

    def test_all_faults_are_listed(self):
        calls = find_calls(self.write("a.tex", "\\computed{p/i}{z}{x}\n\\computed{p/i}{a}{z}"))
        with self.assertRaisesRegex(Fault, "(?s)a.tex:1.*a.tex:2"):
            resolve_all(self.cells, calls)


class ClaimsTable(FakeTree):
    def test_bad_rows_are_named(self):
        row = "K-1,interference,1,sentence,c,p/i,b,x,differs\n"
        for text, words in ((row + row, "K-1.*stands twice"), (row.replace("differs", "agrees"), "verdict 'agrees'"),
                            (row.replace("interference", "other"), "unknown paper 'other'")):
            with self.assertRaisesRegex(Fault, words):
                read_claims(self.write("claims.csv", CLAIMS + text))

    def test_neighbours_that_differ_in_a_few_words_share_a_line(self):
        rows = [{"id": f"K-1{i}", "place": "1", "experiment": "p/i", "verdict": "differs", "kind": "sentence",
                 "claim": f"the path along {axis} is the shortest of all paths."} for i, axis in (("a", "u"), ("b", "v"))]
        self.assertEqual([(row["id"], row["claim"]) for row in merged(rows)],
                         [("K-1a to b", "the path along u | v is the shortest of all paths.")])
        self.assertEqual(len(merged([rows[0], {**rows[1], "verdict": "reproduced"}])), 2)

    def test_cells_of_a_table_share_a_line(self):
        rows = [{"id": f"K-{i}", "place": "table 1", "experiment": "p/i", "verdict": "calibrated", "kind": "cell",
                 "claim": f"table 1: {i} points along {axis} with a ball of {i + 5} mm."}
                for i, axis in ((1, "u"), (2, "v"), (3, "u"))]
        self.assertEqual([row["claim"] for row in merged(rows)],
                         ["table 1: 1 points along u with a ball of 6 mm. … table 1: 3 points along u with a ball of "
                          "8 mm. (3 cells)"])

    def test_definitions_are_listed_behind_the_claims(self):
        text = claims_table(read_claims(self.write(
            "claims.csv", CLAIMS + "K-1,interference,1,definition,d,,,,definition\n"
            "K-2,interference,2,cell,5 %,p/table-1,b,x,–\n")))
        self.assertRegex(text, r"(?s)5 \\% & table-\\allowbreak\{\}1 & input.*Definitions.*K-1")


class TypedNumbers(FakeTree):
    def typed(self, text, allowed=()):
        return [line for line, _ in typed_numbers(text, allowed)]

    def test_measured_numbers_are_found(self):
        for text in ("it takes 34 s", "41 \\% of them", "about $0.5$ mm", "with $R=7.5$ mm", "$10^{-3}$",
                     "by a factor of 178"):
            self.assertTrue(self.typed(text), text)

    def test_formulas_places_and_cells_may_have_digits(self):
        for text in (r"$2\sqrt{2Rh-h^2}$", "eqs.~(4) and (5)", "figures 13 to 15", "method 3", "section 4.2",
                     r"\begin{equation*}x=40\end{equation*}", r"\computed[1]{p/i}{d=0.5 u}{x2}", "% 12\n",
                     r"\cite{KimChoi2}", r"\texttt{net\_24}", "mm$^3$", "$k=0$", r"\begin{tabular}{p{0.3\textwidth}}"):
            self.assertEqual(self.typed(text), [], text)

    def test_phrases_may_be_allowed(self):
        self.assertEqual(self.typed("steel SM45C and 3r", ["SM45C", "3r"]), [])

    def test_the_paper_has_none(self):
        allowed = read_allowed(ROOT / "paper/typed-numbers.txt")
        self.assertLessEqual(len(allowed), 15, "the list is meant to stay short")
        found = [f"{path.name}:{line}: {words}" for path in sources(ROOT)
                 for line, words in typed_numbers(path.read_text(encoding="utf-8"), allowed)]
        self.assertEqual(found, [])


class ThePaper(FakeTree):
    def test_without_results_it_names_the_command_that_makes_them(self):
        with self.assertRaisesRegex(Fault, "scripts/reproduce.sh --full"):
            prepare(ROOT, self.root / "results", self.root / "claims.csv", self.root / "build")

    def test_every_experiment_of_the_paper_exists(self):
        for path in sources(ROOT):
            for call in find_calls(path):
                if not call.name.startswith(("claim", "figurelines")):
                    self.assertTrue((ROOT / "experiments" / call.plain[0]).is_dir(), call.place)

    def test_bibliography_keeps_no_korean(self):
        text = latin_bibliography((ROOT / "paper/references.bib").read_text(encoding="utf-8"))
        self.assertIn("In Korean with an English abstract.}", text)
        self.assertTrue(all(ord(letter) < 0x250 for letter in text))


if __name__ == "__main__":
    unittest.main()
