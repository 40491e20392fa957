# SPDX-License-Identifier: GPL-3.0-or-later
"""The checks of the house find each kind of disorder, and none in a tidy house."""
import unittest

from fake_tree import FakeTree

import check_layers

SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
MODULES = """# SPDX-License-Identifier: GPL-3.0-or-later
# endmill_module(ghost) in a comment declares nothing
endmill_module(core LIBRARIES Eigen3::Eigen PRIVATE_LIBRARIES TBB::tbb)
endmill_module(surface
               USES core
               LIBRARIES x::y)
endmill_module(io USES core surface PRIVATE_LIBRARIES z::w)
"""


class Layers(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("src/CMakeLists.txt", MODULES)
        for module, header in (("core", "vec"), ("surface", "patch"), ("io", "csv")):
            self.write(f"src/endmill/{module}/{header}.h", SPDX)
            self.write(f"tests/{module}/{header}_test.cpp", SPDX)
        self.write("src/endmill/surface/patch.cpp",
                   SPDX + '#include "endmill/core/vec.h"\n#include <boost/math/roots.hpp>\n')
        self.write("src/cli/plan.cpp", SPDX + '#include "endmill/io/csv.h"\n')

    def assert_found(self, *words):
        code, printed = self.check(check_layers.main, self.root)
        self.assertEqual(code, 1, printed)
        self.assertEqual(len(printed.splitlines()), 1, printed)
        for word in words:
            self.assertIn(word, printed)

    def test_a_tidy_house_passes(self):
        found = self.check(check_layers.main, self.root)
        self.assertEqual(found, (0, "3 modules, all as declared\n"))

    def test_an_undeclared_arrow(self):
        self.write("src/endmill/core/vec.cpp", SPDX + '#include "endmill/surface/patch.h"\n')
        self.assert_found("src/endmill/core/vec.cpp", "core -> surface")

    def test_an_arrow_around_the_declaration(self):
        self.write("src/endmill/core/vec.cpp", SPDX + '#include "../surface/patch.h"\n')
        self.assert_found("src/endmill/core/vec.cpp", "../surface/patch.h")

    def test_a_module_that_is_declared_below_its_user(self):
        self.write("src/CMakeLists.txt", MODULES.replace("USES core\n", "USES core io\n"))
        code, printed = self.check(check_layers.main, self.root)
        self.assertEqual(code, 1)
        self.assertIn("surface uses io, which is not declared above it", printed)
        self.assertIn("surface uses io; only job and cli may", printed)

    def test_a_folder_without_a_declaration(self):
        self.write("src/endmill/utils/all.cpp", SPDX)
        self.assert_found("src/endmill/utils", "not declared")

    def test_a_declaration_without_a_folder(self):
        self.write("src/CMakeLists.txt", MODULES + "endmill_module(path USES core)\n")
        self.assert_found("src/endmill/path", "no folder")

    def test_a_library_in_a_header(self):
        for library in ("CGAL/Point_3.h", "OpenMesh/Core/Mesh.hh", "boost/x.hpp",
                        "embree3/rtcore.h", "tbb/parallel_for.h"):
            self.write("src/endmill/core/vec.h", SPDX + f"#include <{library}>\n")
            self.assert_found("src/endmill/core/vec.h", library)

    def test_a_header_for_users_that_needs_an_internal_one(self):
        self.write("src/endmill/core/vec.h", SPDX + "// Internal to core\n")
        self.write("src/endmill/surface/patch.h", SPDX + '#include "endmill/core/vec.h"\n')
        self.assert_found("src/endmill/surface/patch.h", "endmill/core/vec.h", "internal")

    def test_an_internal_header_may_need_another(self):
        for header in ("core/vec.h", "surface/patch.h"):
            self.write(f"src/endmill/{header}", SPDX + "// Internal to its module\n")
        self.write("src/endmill/surface/patch.h",
                   SPDX + '// Internal to surface\n#include "endmill/core/vec.h"\n')
        self.test_a_tidy_house_passes()

    def test_a_header_without_a_test(self):
        (self.root / "tests/surface/patch_test.cpp").unlink()
        self.assert_found("src/endmill/surface/patch.h", "tests/surface/patch_test.cpp")

    def test_a_file_without_a_licence(self):
        self.write("experiments/paper/item/main.cpp", "int main() {}\n")
        self.assert_found("experiments/paper/item/main.cpp", "SPDX")

    def test_what_is_not_finished(self):
        for word in ("TO" + "DO", "FIX" + "ME"):
            self.write("scripts/a.py", f"# SPDX-License-Identifier: x\n# {word}: later\n")
            self.assert_found("scripts/a.py:2")


if __name__ == "__main__":
    unittest.main()
