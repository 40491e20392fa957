# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads and memory run out in every command that writes: it works without them, or says so."""
import random
import resource
import unittest

from faults import COMMANDS, IS_LONG, NO_MEMORY, NO_MORE_THREADS, FaultTest, difference


class ResourcesTest(FaultTest):
    def test_threads(self):
        """The caller works alone, or with the threads that it got."""
        for name in COMMANDS:
            with self.subTest(name):
                new, _ = self.sound(name)

                def check(number, name=name, new=new):
                    def act(folder):
                        done = self.run_command(name, folder, fault=f"thread:{number}:{NO_MORE_THREADS}")
                        self.assertIn(done.status, (0, 1), done.error)
                        self.assertEqual("", difference(done.files, new))
                    self.in_new_place(act)
                self.in_parallel(check, [(number,) for number in ("1+", "2+", "1", "2", "3")])

    def check_memory(self, name, number, new):
        def act(folder):
            done = self.run_command(name, folder, fault=f"memory:{number}:{NO_MEMORY}")
            case = f"{name}, memory {number}: exit {done.status}, {done.error}"
            self.assertIn(done.status, (0, 1, 6), case)
            if done.files is not None or done.status != 6:
                self.assertEqual("", difference(done.files, new), case)
            if done.status == 6:
                self.assertIn("out of memory", done.error, case)
        self.in_new_place(act)

    def test_memory(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts = self.sound(name)
                chance = random.Random(name)
                numbers = [chance.randint(1, counts["memory"]) for _ in range(100 if IS_LONG else 12)]
                cases = [(name, f"{number}{later}", new) for number in numbers for later in ("", "+")]
                self.in_parallel(self.check_memory, cases)

    def test_a_small_address_space(self):
        def check(name, kib):
            def act(folder):
                done = self.run_command(name, folder, preexec_fn=lambda: resource.setrlimit(
                    resource.RLIMIT_AS, (kib * 1024, kib * 1024)))
                if "error while loading shared libraries" in done.error:
                    return False
                self.assertIn(done.status, (0, 1, 6), f"{name}, {kib} KiB: {done.error}")
                return True
            return self.in_new_place(act)
        self.in_parallel(check, [(name, kib) for name in COMMANDS for kib in (40_000, 60_000, 90_000, 200_000)])


if __name__ == "__main__":
    unittest.main()
