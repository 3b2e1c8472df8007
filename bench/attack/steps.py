"""Run the commands on one input and say what went wrong."""

from __future__ import annotations

import io
import json
import resource
import time
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout, suppress
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.format.run import format_manifests
from rospkg_cli.cli.inspect.run import inspect
from rospkg_cli.cli.lint.lint_options import FixOptions, LintOptions, ReportOptions, RuleOptions
from rospkg_cli.cli.lint.run import lint
from rospkg_cli.config.schema import ConfigError
from rospkg_cli.engine.baseline import BaselineError
from rospkg_cli.engine.discovery.locate import LocateError
from rospkg_cli.engine.fixing.write import WriteError
from rospkg_cli.engine.run.rule_plugins import PluginError
from rospkg_cli.index import NamesError
from rospkg_cli.report import FORMATS

from .case import Case, remove, write_case
from .checks import Tree, differing, faults_of_change, faults_of_output, snapshot
from .limits import OvertimeError, cause, limited, place_of

REFUSALS: tuple[type[Exception], ...] = (
    UsageError,
    ConfigError,
    LocateError,
    PluginError,
    BaselineError,
    WriteError,
    NamesError,
)
"""What a command may raise: one sentence for the user, exit 2."""
EVERY_COMMAND = 50
"""One input of so many is also reported through the command in each format by itself."""


@dataclass(frozen=True)
class Fault:
    """What went wrong: in which step, what, and where in the code as far as that is known."""

    step: str
    what: str
    where: str = ""
    detail: str = ""


@dataclass
class Outcome:
    faults: list[Fault] = field(default_factory=list)
    statuses: dict[str, int] = field(default_factory=dict)
    """Exit status of each step; 2 for a refusal."""
    seconds: dict[str, float] = field(default_factory=dict)
    """CPU seconds of each step."""
    memory: float = 0.0
    """MiB by which the largest memory that this process ever had grew."""


@dataclass
class Attempt:
    """One input on its way through the commands, in a folder of its own."""

    case: Case
    folder: Path
    outcome: Outcome = field(default_factory=Outcome)

    def blame(self, step: str, what: str, where: str = "", detail: str = "") -> None:
        room = str(self.folder)
        self.outcome.faults.append(Fault(step, what.replace(room, "ROOM"), where, detail.replace(room, "ROOM")))

    def step(self, name: str, command: Callable[[], int]) -> str:
        """Run one command within its limits, and return what it printed."""
        shown, said, began = io.StringIO(), io.StringIO(), time.process_time()
        try:
            with redirect_stdout(shown), redirect_stderr(said), limited():
                self.outcome.statuses[name] = command()
        except REFUSALS as refusal:
            self.outcome.statuses[name] = 2
            said.write(f"rospkg: {refusal}")
        except OvertimeError as error:
            self.blame(name, f"over the time: {error}", cause(error)[1])
        except BaseException as error:  # whatever it is, it is a find
            self.blame(name, *cause(error))
        self.outcome.seconds[name] = time.process_time() - began
        crashed = "Traceback (most recent call last)" in said.getvalue()
        for fault in () if crashed else faults_of_output("said", said.getvalue()):
            self.blame(name, fault)
        if crashed:
            self.blame_crashes(name, said.getvalue())
        return shown.getvalue()

    def blame_crashes(self, step: str, said: str) -> None:
        for text in said.split("Traceback (most recent call last)")[1:]:
            last = [line for line in text.splitlines() if line and not line.startswith(" ")]
            self.blame(step, f"RPK005 {(last or ['?'])[-1][:300]}", place_of(text))

    def run(self) -> Outcome:
        """Run everything; returns what went wrong."""
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        try:
            self.look()
            self.repair()
            self.arrange()
        finally:
            remove(self.folder)
        self.outcome.memory = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
        return self.outcome

    def write(self, name: str) -> tuple[Path, Path, Tree]:
        """Write the input to a folder; return that, the package, and what is there."""
        folder = self.folder / name
        package = write_case(self.case, folder)
        return folder, package, snapshot(folder)

    def look(self) -> None:
        """Lint in every format, and inspect: nothing may change."""
        folder, package, before = self.write("look")
        (self.folder / "out").mkdir()
        options = lint_options(package, output=tuple(f"{name}:{self.folder / 'out' / name}" for name in FORMATS[1:]))
        text = self.step("lint", lambda: lint(options))
        self.check_output("lint", "text", text)
        for name in FORMATS[1:]:
            if (self.folder / "out" / name).exists():
                self.check_output("lint", name, (self.folder / "out" / name).read_text(errors="surrogateescape"))
        self.check_codes()
        late = [fault for fault in self.outcome.faults if fault.what.startswith("over the time")]
        if late or self.case.number % EVERY_COMMAND == 0:
            for fault in late:  # all formats at once took too long: each by itself is what counts
                self.outcome.faults.remove(fault)
            for name in FORMATS:
                self.check_output(
                    "lint", name, self.step(f"lint {name}", partial(lint, lint_options(package, format=name)))
                )
        self.check_output("inspect", "inspect", self.step("inspect", lambda: inspect([package], color="never")))
        as_json = self.step("inspect json", lambda: inspect([package], format="json"))
        if self.outcome.statuses.get("inspect json") == 0:
            self.check_output("inspect json", "inspect json", as_json)
        for path in differing(before, snapshot(folder)):
            self.blame("look", f"changed: {path!a}")

    def check_output(self, step: str, name: str, text: str) -> None:
        if not text and self.outcome.statuses.get(step, 3) not in (0, 1):
            return
        for fault in faults_of_output(name, text):
            self.blame(step, f"{name}: {fault}")

    def check_codes(self) -> None:
        """Blame a crash that left no traceback, and a status that does not fit."""
        report = self.folder / "out" / "json"
        if not report.exists():
            return
        with suppress(ValueError):
            findings = json.loads(report.read_text(errors="replace"))["findings"]
            crashed = [each["message"] for each in findings if each["code"] == "RPK005"]
            if crashed and not self.outcome.faults:
                self.blame("lint", "RPK005", "", crashed[0][:300])

    def repair(self) -> None:
        """Repair a copy, and again: the second time nothing may change."""
        folder, package, before = self.write("fix")
        options = lint_options(package, FixOptions(fix=True, unsafe_fixes=self.case.unsafe))
        self.changing("fix", folder, before, lambda: lint(options))

    def arrange(self) -> None:
        """Format a copy, and again."""
        folder, package, before = self.write("format")
        self.changing("format", folder, before, lambda: format_manifests((package,)))

    def changing(self, name: str, folder: Path, before: Tree, command: Callable[[], int]) -> None:
        self.check_output(name, "text", self.step(name, command))
        after = snapshot(folder)
        for fault in faults_of_change(before, after):
            self.blame(name, fault)
        if after == before:
            return
        self.step(f"{name} again", command)
        for path in differing(after, snapshot(folder)):
            self.blame(f"{name} again", f"changes something: {path!a}")


def lint_options(package: Path, fixing: FixOptions | None = None, **report: Any) -> LintOptions:
    """Return the options of a run of all rules, in this process."""
    return LintOptions(
        paths=(package,),
        jobs="1",
        rules=RuleOptions(pedantic=True, release=True),
        fixing=fixing or FixOptions(),
        report=ReportOptions(**{"traceback": True, "color": "never", **report}),
    )
