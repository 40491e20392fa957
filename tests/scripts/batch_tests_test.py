# SPDX-License-Identifier: GPL-3.0-or-later
"""Test files share a batch only if no name of one can be taken for a name of another."""
import unittest

import fake_tree  # noqa: F401  puts scripts/ on the path
from batch_tests import batches, helpers, words

HELPER = "namespace {\n\ndouble half(double x)\n{\n    return x / 2;\n}\n\n}  // namespace\n"


class Helpers(unittest.TestCase):
    def test_are_functions_variables_types_and_aliases(self):
        text = """using Points = std::vector<Vec3>;
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
"""
        self.assertEqual(helpers(text),
                         {"Points", "radius", "limits", "Case", "Kind", "pairs_of", "Fixture"})

    def test_are_not_tests_or_names_that_a_using_declaration_brings(self):
        text = "using testing::HasSubstr;\nusing namespace std;\nTEST(Suite, Name)\nnamespace endmill {\n"
        self.assertEqual(helpers(text), set())


class Words(unittest.TestCase):
    def test_leave_out_members_qualified_names_comments_and_texts(self):
        self.assertEqual(words('a.b c->d e::f // g\n"h" i(j)'), {"a", "c", "e", "i", "j"})

    def test_contain_what_a_using_declaration_brings(self):
        self.assertIn("random_point", words("using test::random_point;\n"))

    def test_contain_functions_of_the_namespace_test_which_a_helper_would_make_ambiguous(self):
        self.assertIn("random_point", words("const Vec3 p = test::random_point(random, 1);\n"))


class Batches(unittest.TestCase):
    def test_are_filled_to_their_size(self):
        texts = {name: "" for name in "abcde"}
        self.assertEqual(batches(texts, 2), [["a", "b"], ["c", "d"], ["e"]])

    def test_one_helper_defined_twice_is_kept_apart(self):
        self.assertEqual(batches({"a": HELPER, "b": HELPER, "c": ""}, 8), [["a", "c"], ["b"]])

    def test_a_local_name_beside_a_helper_is_kept_apart(self):
        local = "TEST(A, B)\n{\n    double half = 1;\n}\n"
        self.assertEqual(batches({"a": HELPER, "b": local}, 8), [["a"], ["b"]])
        self.assertEqual(batches({"b": local, "a": HELPER}, 8), [["b"], ["a"]])

    def test_a_member_of_that_name_is_no_obstacle(self):
        member = "TEST(A, B)\n{\n    EXPECT_EQ(line.half, other::half);\n}\n"
        self.assertEqual(batches({"a": HELPER, "b": member}, 8), [["a", "b"]])


if __name__ == "__main__":
    unittest.main()
