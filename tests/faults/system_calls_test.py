# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of the system fail, or the process is killed at one, in every command that writes. Its output folder is
then old or new as a whole."""
import unittest

from faults import COMMANDS, FULL_DISK, FaultTest, difference, some_of

CALLS = ("open", "mkdir", "rename", "unlink", "rmdir", "write", "read", "fsync", "fchmod", "flock", "opendir")
# Without these the process cannot remove its staging folder. The next run does.
REMOVING = ("open", "unlink", "rmdir", "opendir")
OLD = {"summary.json": b"old", "u/old.csv": b"old", "mine.txt": b"mine"}


def put_old(folder, names):
    """Files of an earlier run with the names of the new ones, and a file of somebody else."""
    for name, content in {**{name: b"old" for name in names}, **OLD}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)


class FailingCallTest(FaultTest):
    def states(self, name):
        """The files of a run into a folder with old files: before and after."""
        new, counts = self.sound(name)
        before = {**{each: b"old" for each in new}, **OLD}

        def act(folder):
            put_old(folder, new)
            done = self.run_command(name, folder, "--force")
            self.assertIn(done.status, (0, 1), f"{name}: {done.error}")
            return done.files
        return new, counts, before, self.in_new_place(act)

    def check(self, name, call, number, new, before, after):
        def act(folder):
            put_old(folder, new)
            done = self.run_command(name, folder, "--force", fault=f"{call}:{number}:{FULL_DISK}")
            case = f"{name}, {call} {number}: exit {done.status}, {done.error}"
            self.assertIn(done.status, (0, 1, 3, 5, 6), case)
            self.assertEqual("", difference(done.files, after if done.status in (0, 1) else before), case)
            if call not in REMOVING:
                self.assertEqual(done.left, 0, case)
        self.in_new_place(act)

    def test_a_failing_call_leaves_the_old_or_the_new_folder(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts, before, after = self.states(name)
                cases = [(name, call, number, new, before, after)
                         for call in CALLS for number in some_of(counts[call] + 5, 3)]
                self.in_parallel(self.check, cases)

    def check_new_folder(self, name, call, number, new):
        def act(folder):
            done = self.run_command(name, folder, fault=f"{call}:{number}:{FULL_DISK}")
            case = f"{name}, {call} {number}: exit {done.status}, {done.error}"
            self.assertIn(done.status, (0, 1, 3, 5, 6), case)
            self.assertEqual("", difference(done.files, new if done.status in (0, 1) else None), case)
        self.in_new_place(act)

    def test_a_failing_call_leaves_no_half_of_a_new_folder(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts = self.sound(name)
                self.in_parallel(self.check_new_folder,
                                 [(name, call, number, new) for call in CALLS
                                  for number in some_of(counts[call], 2)])

    def check_kill(self, name, call, number, new, before, after):
        def act(folder):
            put_old(folder, new)
            done = self.run_command(name, folder, "--force", fault=f"{call}:{number}:kill")
            case = f"{name}, killed at {call} {number}: exit {done.status}, {done.error}"
            if done.status != -9:
                return  # there was no such call
            if difference(done.files, before) and difference(done.files, after):
                self.assertNotIn("summary.json", done.files, case)
            again = self.run_command(name, folder, "--force")
            self.assertIn(again.status, (0, 1), case)
            self.assertEqual(("", 0), (difference(again.files, after), again.left), case)
        self.in_new_place(act)

    def test_a_kill_leaves_a_folder_that_the_next_run_mends(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts, before, after = self.states(name)
                renames = 2 * len(new) + 4
                cases = [(name, "rename", number, new, before, after) for number in some_of(renames, 6)]
                cases += [(name, call, number, new, before, after) for call in ("mkdir", "write", "unlink", "fsync")
                          for number in some_of(counts[call], 2)]
                self.in_parallel(self.check_kill, cases)

    def check_killed_new(self, name, call, number, new):
        def act(folder):
            done = self.run_command(name, folder, fault=f"{call}:{number}:kill")
            case = f"{name}, killed at {call} {number}: {done.error}"
            if done.files is not None:
                self.assertEqual("", difference(done.files, new), case)
            else:
                again = self.run_command(name, folder)
                self.assertIn(again.status, (0, 1), case + again.error)
                self.assertEqual(("", 0), (difference(again.files, new), again.left), case)
        self.in_new_place(act)

    def test_a_killed_run_can_be_repeated_without_force(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts = self.sound(name)
                self.in_parallel(self.check_killed_new,
                                 [(name, call, number, new) for call in ("rename", "write", "fsync")
                                  for number in some_of(counts[call], 2)])


if __name__ == "__main__":
    unittest.main()
