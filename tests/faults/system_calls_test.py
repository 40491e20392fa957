# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of the system fail, or the process is killed or interrupted at one, in every command that writes. Its output
folder is then old or new as a whole."""
import errno
import signal
import unittest

from faults import COMMANDS, FAILURES, IS_LONG, FaultTest, contents, difference, some_of

CALLS = ("open", "mkdir", "rename", "unlink", "rmdir", "write", "read", "fsync", "fchmod", "flock", "opendir")
# Without these the process cannot remove its staging folder. The next run does.
REMOVING = ("open", "unlink", "rmdir", "opendir")
# The calls at which the process is killed, beside rename.
KILLS = ("mkdir", "write", "unlink", "fsync") + (("open", "read", "rmdir", "fchmod", "flock", "opendir") if IS_LONG else ())
INTERRUPTS = ("mkdir", "rename", "open")
OLD = {"summary.json": b"old", "u/old.csv": b"old", "mine.txt": b"mine"}


def fault_of(call, number, failure):
    error, later = failure
    return f"{call}:{number}{later}:{error}"


def put_old(folder, names):
    """Files of an earlier run with the names of the new ones, and a file of somebody else."""
    for name, content in {**{name: b"old" for name in names if not name.endswith("/")}, **OLD}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)


class FailingCallTest(FaultTest):
    def states(self, name):
        """The files of a run into a folder with old files: before and after."""
        new, counts = self.sound(name)

        def act(folder):
            put_old(folder, new)
            before = contents(folder)
            done = self.run_command(name, folder, "--force")
            self.assertIn(done.status, (0, 1), f"{name}: {done.error}")
            return before, done.files
        return new, counts, *self.in_new_place(act)

    def check(self, name, call, number, failure, new, before, after):
        def act(folder):
            put_old(folder, new)
            done = self.run_command(name, folder, "--force", fault=fault_of(call, number, failure))
            case = f"{name}, {call} {number}, error {failure}: exit {done.status}, {done.error}"
            self.assertIn(done.status, (0, 1, 3, 5, 6), case)
            change = difference(done.files, after if done.status in (0, 1) else before)
            if change and failure[1]:
                # The process cannot restore the folder while its calls fail. The next run does, as after a kill.
                self.check_mended(name, folder, done, before, after, case)
            else:
                self.assertEqual("", change, case)
                if call not in REMOVING and not failure[1]:
                    self.assertEqual(done.left, 0, case)
            return done.occurred
        return self.in_new_place(act)

    def test_a_failing_call_leaves_the_old_or_the_new_folder(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts, before, after = self.states(name)
                cases = [(name, call, number, failure, new, before, after)
                         for call in CALLS for number in some_of(counts[call] + 5, 3) for failure in FAILURES]
                self.in_parallel(self.check, cases)

    def check_new_folder(self, name, call, number, failure, new):
        def act(folder):
            done = self.run_command(name, folder, fault=fault_of(call, number, failure))
            case = f"{name}, {call} {number}, error {failure}: exit {done.status}, {done.error}"
            self.assertIn(done.status, (0, 1, 3, 5, 6), case)
            self.assertEqual("", difference(done.files, new if done.status in (0, 1) else None), case)
            return done.occurred
        return self.in_new_place(act)

    def test_a_failing_call_leaves_no_half_of_a_new_folder(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts = self.sound(name)
                self.in_parallel(self.check_new_folder,
                                 [(name, call, number, failure, new) for call in CALLS
                                  for number in some_of(counts[call], 2) for failure in FAILURES])

    def check_mended(self, name, folder, done, before, after, case):
        """A folder between the old and the new state has no summary, and the next run makes it new."""
        if difference(done.files, before) and difference(done.files, after):
            self.assertNotIn("summary.json", done.files, case)
        again = self.run_command(name, folder, "--force")
        self.assertIn(again.status, (0, 1), case)
        self.assertEqual(("", 0), (difference(again.files, after), again.left), case)

    def check_kill(self, name, call, number, new, before, after):
        def act(folder):
            put_old(folder, new)
            done = self.run_command(name, folder, "--force", fault=f"{call}:{number}:kill")
            case = f"{name}, killed at {call} {number}: exit {done.status}, {done.error}"
            if done.status != -9:
                return False  # there was no such call
            self.check_mended(name, folder, done, before, after, case)
            return True
        return self.in_new_place(act)

    def test_a_kill_leaves_a_folder_that_the_next_run_mends(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts, before, after = self.states(name)
                renames = 2 * len(new) + 4
                cases = [(name, "rename", number, new, before, after) for number in some_of(renames, 6)]
                cases += [(name, call, number, new, before, after) for call in KILLS
                          for number in some_of(counts[call], 2)]
                self.in_parallel(self.check_kill, cases)

    def check_kill_twice(self, name, first, second, new, before, after):
        """The run that restores the folder after a kill is killed as well; a third one restores it and then fails."""
        def act(folder):
            put_old(folder, new)
            done = self.run_command(name, folder, "--force", fault=f"rename:{first}:kill")
            again = self.run_command(name, folder, "--force", fault=f"{second}:kill")
            last = self.run_command(name, folder, "--force", fault=f"write:1:{errno.ENOSPC}")
            case = f"{name}, killed at rename {first}, then at {second}: exit {last.status}, {last.error}"
            self.assertEqual(last.status, 5, case)
            if difference(last.files, after):
                self.assertEqual("", difference(last.files, before), case)
            self.assertEqual(last.left, 0, case)
            return done.status == again.status == -9
        return self.in_new_place(act)

    def test_two_kills_leave_the_old_or_the_new_folder(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, _, before, after = self.states(name)
                renames = 2 * len(new) + 4
                seconds = [f"{call}:{number}" for call in ("rename", "unlink", "rmdir", "open", "mkdir")
                           for number in (range(1, 9) if IS_LONG else (2, 5))]
                firsts = sorted({1 + k * (renames - 1) // 7 for k in range(8)}) if IS_LONG else some_of(renames, 2)
                self.in_parallel(self.check_kill_twice, [(name, first, second, new, before, after)
                                                         for first in firsts for second in seconds])

    def test_a_kill_leaves_an_empty_folder_empty(self):
        """The folder was there, without files."""
        def check(name, number, new):
            def act(folder):
                folder.mkdir()
                done = self.run_command(name, folder, fault=f"rename:{number}:kill")
                again = self.run_command(name, folder)
                case = f"{name}, killed at rename {number}: {again.error}"
                self.assertIn(again.status, (0, 1) if difference(done.files, new) else (2,), case)
                self.assertEqual("", difference(again.files, new), case)
                return done.status == -9
            return self.in_new_place(act)
        for name in COMMANDS:
            with self.subTest(name):
                new, counts = self.sound(name)
                self.in_parallel(check, [(name, number, new) for number in some_of(counts["rename"] + len(new), 4)])

    def check_interrupt(self, name, call, number, new, before, after, options):
        def act(folder):
            if options:
                put_old(folder, new)
            done = self.run_command(name, folder, *options, fault=f"{call}:{number}:term")
            case = f"{name}, interrupted at {call} {number}: exit {done.status}, {done.error}"
            self.assertIn(done.status, (0, 1, 128 + signal.SIGTERM), case)
            if done.status == 128 + signal.SIGTERM and difference(done.files, before):
                self.assertEqual("", difference(done.files, after), case)
            self.assertEqual(done.left, 0, case)
            return done.status == 128 + signal.SIGTERM
        return self.in_new_place(act)

    def test_an_interrupt_leaves_the_old_or_the_new_folder(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts, before, after = self.states(name)
                self.in_parallel(self.check_interrupt,
                                 [(name, call, number, new, *states) for call in INTERRUPTS
                                  for number in some_of(counts[call], 2)
                                  for states in ((before, after, ("--force",)), (None, new, ()))])

    def check_killed_new(self, name, call, number, new):
        def act(folder):
            done = self.run_command(name, folder, fault=f"{call}:{number}:kill")
            case = f"{name}, killed at {call} {number}: {done.error}"
            if done.files is not None:
                self.assertEqual("", difference(done.files, new), case)
            elif done.status == -9:
                again = self.run_command(name, folder)
                self.assertIn(again.status, (0, 1), case + again.error)
                self.assertEqual(("", 0), (difference(again.files, new), again.left), case)
            return done.status == -9
        return self.in_new_place(act)

    def test_a_killed_run_can_be_repeated_without_force(self):
        for name in COMMANDS:
            with self.subTest(name):
                new, counts = self.sound(name)
                self.in_parallel(self.check_killed_new,
                                 [(name, call, number, new) for call in ("rename", *KILLS)
                                  for number in some_of(counts[call], 2)])


if __name__ == "__main__":
    unittest.main()
