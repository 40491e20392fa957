# SPDX-License-Identifier: GPL-3.0-or-later
"""check_layers.py reports each kind of fault, and none in a correct tree."""
import unittest

from fake_tree import FakeTree

import check_layers

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
MODULES = """# SPDX-License-Identifier: GPL-3.0-or-later
# endmill_module(ghost) in a comment declares nothing
endmill_module(core LIBRARIES Eigen3::Eigen PRIVATE_LIBRARIES Threads::Threads)
endmill_module(surface
               USES core
               LIBRARIES x::y TEST_LIBRARIES files)
endmill_module(files USES core surface PRIVATE_LIBRARIES z::w)
"""


class Layers(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("src/CMakeLists.txt", MODULES)
        for module, header in (("core", "vec"), ("surface", "patch"), ("files", "csv")):
            self.write_header(module, header)
            self.write_umbrella(module, header)
        self.write("src/endmill/surface/patch.cpp",
                   SPDX + '#include "endmill/core/vec.h"\n#include <boost/math/roots.hpp>\n')
        self.write("src/endmill/surface/net.cpp", SPDX + '#include "endmill/core/vec.h"\n')
        self.write("src/endmill/files/csv.cpp", SPDX + '#include "endmill/core/vec.h"\n'
                   '#include "endmill/surface/patch.h"\n')
        self.write("src/cli/plan.cpp", SPDX + '#include "endmill/files/csv.h"\n')

    def write_header(self, module, header, text=""):
        """Adds a header with its test."""
        self.write(f"src/endmill/{module}/{header}.h", SPDX + text)
        self.write(f"tests/{module}/{header.split('/')[-1]}_test.cpp", SPDX)

    def write_umbrella(self, module, *headers):
        self.write(f"src/endmill/{module}.h", SPDX + "".join(
            f'#include "endmill/{module}/{header}.h"\n' for header in headers))

    def assert_found(self, *words):
        code, printed = self.check(check_layers.main, self.root)
        self.assertEqual(code, 1, printed)
        self.assertEqual(len(printed.splitlines()), 1, printed)
        for word in words:
            self.assertIn(word, printed)

    def test_correct_tree_passes(self):
        found = self.check(check_layers.main, self.root)
        self.assertEqual(found, (0, "3 modules, all as declared\n"))

    def test_undeclared_use_of_a_module_is_reported(self):
        self.write("src/endmill/core/vec.cpp", SPDX + '#include "endmill/surface/patch.h"\n')
        code, printed = self.check(check_layers.main, self.root)
        self.assertEqual(code, 1)
        self.assertIn("src/endmill/core/vec.cpp: core -> surface", printed)

    def test_declared_arrow_that_no_include_follows_is_reported(self):
        self.write("src/endmill/files/csv.cpp", SPDX + '#include "endmill/core/vec.h"\n')
        self.assert_found("files declares surface and includes no header of it")

    def test_types_that_differ_in_word_order_are_reported(self):
        self.write("src/endmill/surface/net.cpp",
                   SPDX + '#include "endmill/core/vec.h"\nstruct PatchBox {};\n')
        self.write("src/cli/plan.cpp", SPDX + "class BoxPatch;\nenum class NURBSPatch {};\n")
        self.assert_found("types", "BoxPatch, PatchBox")

    def test_nested_types_that_differ_in_word_order_are_reported(self):
        self.write("src/cli/plan.cpp",
                   SPDX + "using OneTwo = int;\nstruct Plan {\n    enum TwoOne {};\n};\n")
        self.assert_found("types", "OneTwo, TwoOne")

    def test_files_that_differ_in_word_order_are_reported(self):
        self.write("src/cli/plan_patch.cpp", SPDX)
        self.write("src/endmill/surface/patch_plan.cpp", SPDX)
        self.assert_found("files", "patch_plan, plan_patch")

    def test_members_of_a_type_are_no_types(self):
        self.write("src/cli/plan.cpp", SPDX + "struct Plan {};\nstruct Plan::Detail {};\n"
                   "void Plan::TwoOne() {}\nstruct OneTwo {};\n")
        self.test_correct_tree_passes()

    def test_umbrella_header_in_the_library_is_reported(self):
        self.write("src/endmill/surface/patch.cpp", SPDX + '#include "endmill/core.h"\n')
        self.assert_found("src/endmill/surface/patch.cpp", "core.h")

    def test_relative_include_is_reported(self):
        self.write("src/endmill/core/vec.cpp", SPDX + '#include "../surface/patch.h"\n')
        self.assert_found("src/endmill/core/vec.cpp", "../surface/patch.h")

    def test_module_declared_after_its_user_is_reported(self):
        self.write("src/CMakeLists.txt", MODULES.replace("USES core\n", "USES core files\n"))
        code, printed = self.check(check_layers.main, self.root)
        self.assertEqual(code, 1)
        self.assertIn("surface uses files, which is not declared above it", printed)
        self.assertIn("surface uses files; only job, import and cli may", printed)

    def test_folder_without_a_declaration_is_reported(self):
        self.write("src/endmill/utils/all.cpp", SPDX)
        self.write_umbrella("utils")
        self.assert_found("src/endmill/utils", "not declared")

    def test_declaration_without_a_folder_is_reported(self):
        self.write("src/CMakeLists.txt", MODULES + "endmill_module(path USES core)\n")
        self.assert_found("src/endmill/path", "no folder")

    def test_folder_other_than_detail_is_reported(self):
        self.write("src/endmill/core/impl/all.cpp", SPDX)
        self.assert_found("src/endmill/core/impl", "detail/")

    def test_library_in_a_header_is_reported(self):
        for library in ("CGAL/Point_3.h", "OpenMesh/Core/Mesh.hh", "boost/x.hpp",
                        "embree3/rtcore.h", "tbb/parallel_for.h"):
            self.write("src/endmill/core/vec.h", SPDX + f"#include <{library}>\n")
            self.assert_found("src/endmill/core/vec.h", library)

    def test_public_header_that_includes_a_private_one_is_reported(self):
        self.write_header("core", "detail/lanes")
        self.write("src/endmill/surface/patch.h",
                   SPDX + '#include "endmill/core/detail/lanes.h"\n')
        self.assert_found("src/endmill/surface/patch.h", "core/detail/lanes.h")

    def test_private_header_may_include_another(self):
        self.write_header("core", "detail/lanes")
        self.write_header("surface", "detail/rows", '#include "endmill/core/detail/lanes.h"\n')
        self.test_correct_tree_passes()

    def test_command_that_includes_a_private_header_is_reported(self):
        self.write_header("files", "detail/rows")
        self.write("src/cli/plan.cpp", SPDX + '#include "endmill/files/detail/rows.h"\n')
        self.assert_found("src/cli/plan.cpp", "files/detail/rows.h")

    def test_incomplete_umbrella_header_is_reported(self):
        self.write_header("core", "angle")
        self.assert_found("src/endmill/core.h", "exactly")

    def test_module_without_an_umbrella_header_is_reported(self):
        (self.root / "src/endmill/core.h").unlink()
        self.assert_found("src/endmill/core.h", "exactly")

    def test_too_many_public_headers_are_reported(self):
        names = [f"header_{chr(ord('a') + k)}" for k in range(15)]
        for name in names:
            self.write_header("core", name)
        self.write_umbrella("core", *names, "vec")
        self.assert_found("src/endmill/core", "16 headers", "at most 14")

    def test_units_that_include_each_other_are_reported(self):
        self.write_header("core", "angle", '#include "endmill/core/vec.h"\n')
        self.write("src/endmill/core/vec.cpp", SPDX + '#include "endmill/core/angle.h"\n')
        self.write_umbrella("core", "angle", "vec")
        self.assert_found("circle", "endmill/core/angle endmill/core/vec")

    def test_header_without_a_test_is_reported(self):
        (self.root / "tests/surface/patch_test.cpp").unlink()
        self.assert_found("src/endmill/surface/patch.h", "tests/surface/patch_test.cpp")

    def test_test_of_one_aspect_counts_as_a_test(self):
        (self.root / "tests/surface/patch_test.cpp").unlink()
        self.write("tests/surface/patch_borders_test.cpp", SPDX)
        self.test_correct_tree_passes()

    def test_file_without_a_licence_is_reported(self):
        self.write("experiments/paper/item/main.cpp", "int main() {}\n")
        self.assert_found("experiments/paper/item/main.cpp", "SPDX")

    def test_unfinished_code_is_reported(self):
        for word in ("TO" + "DO", "FIX" + "ME"):
            self.write("scripts/a.py", f"# SPDX-License-Identifier: x\n# {word}: later\n")
            self.assert_found("scripts/a.py:2")


if __name__ == "__main__":
    unittest.main()
