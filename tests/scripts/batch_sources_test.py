# SPDX-License-Identifier: GPL-3.0-or-later
"""batch_sources.py puts source files into one batch only if their names cannot collide."""
import unittest

import fake_tree  # noqa: F401  puts scripts/ on the path
from batch_sources import batches, helpers, words

HELPER = "namespace {\n\ndouble half(double x)\n{\n    return x / 2;\n}\n\n}  // namespace\n"


class Helpers(unittest.TestCase):
    def test_helpers_are_functions_variables_types_and_aliases(self):
        text = """namespace {
using Points = std::vector<Vec3>;
constexpr double radius = 5;
const Limits limits{0.1, 0.2};
struct Case {
    int member;
};
enum class Kind { A };
std::vector<std::pair<int, int>> pairs_of(const Mesh& mesh,
                                          int count)
{
    int local = 0;
}
class Fixture : public testing::Test {
}  // namespace
double published(double x)
using Outside = int;
"""
        self.assertEqual(helpers(text),
                         {"Points", "radius", "limits", "Case", "Kind", "pairs_of", "Fixture",
                          "Outside"})

    def test_helpers_exclude_tests_and_using_declarations(self):
        text = "namespace {\nusing testing::HasSubstr;\nusing namespace std;\nTEST(Suite, Name)\nnamespace endmill {\n"
        self.assertEqual(helpers(text), set())


class Words(unittest.TestCase):
    def test_words_exclude_members_qualified_names_comments_and_strings(self):
        self.assertEqual(words('a.b c->d e::f // g\n"h" i(j)'), {"a", "c", "e", "i", "j"})

    def test_words_include_names_of_using_declarations(self):
        self.assertIn("random_point", words("using test::random_point;\n"))

    def test_words_include_functions_of_the_namespace_test(self):
        self.assertIn("random_point", words("const Vec3 p = test::random_point(random, 1);\n"))


class Batches(unittest.TestCase):
    def test_batches_are_filled_to_their_size(self):
        texts = {name: "" for name in "abcde"}
        self.assertEqual(batches(texts, 2), [["a", "b"], ["c", "d"], ["e"]])

    def test_files_with_the_same_helper_are_separated(self):
        self.assertEqual(batches({"a": HELPER, "b": HELPER, "c": ""}, 8), [["a", "c"], ["b"]])

    def test_local_name_equal_to_a_helper_is_separated(self):
        local = "TEST(A, B)\n{\n    double half = 1;\n}\n"
        self.assertEqual(batches({"a": HELPER, "b": local}, 8), [["a"], ["b"]])
        self.assertEqual(batches({"b": local, "a": HELPER}, 8), [["b"], ["a"]])

    def test_member_with_the_name_of_a_helper_may_share_a_batch(self):
        member = "TEST(A, B)\n{\n    EXPECT_EQ(line.half, other::half);\n}\n"
        self.assertEqual(batches({"a": HELPER, "b": member}, 8), [["a", "b"]])

    def test_file_that_brings_unseen_names_stays_alone(self):
        self.assertEqual(batches({"a": "using enum Kind;\n", "b": "", "c": ""}, 8), [["b", "c"], ["a"]])


if __name__ == "__main__":
    unittest.main()
