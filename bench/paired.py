"""Run commands in turn, so that what else the machine does falls on all of them alike."""

from __future__ import annotations

import os
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Command:
    name: str
    words: tuple[str, ...]
    cwd: Path
    environment: Mapping[str, str] = field(default_factory=dict)
    before: Callable[[], object] | None = None
    """What is done before each run, and not measured."""


@dataclass
class Figures:
    """Of one command: CPU and wall seconds of each round, and the peak of memory in MiB of its largest process."""

    cpu: list[float] = field(default_factory=list)
    wall: list[float] = field(default_factory=list)
    peak: float = 0.0

    @property
    def median(self) -> float:
        return statistics.median(self.cpu)


def run_in_turn(commands: list[Command], rounds: int) -> dict[str, Figures]:
    """Run each command once without a look at it (so that bytecode is written), then `rounds` times in turn."""
    found = {command.name: Figures() for command in commands}
    for number in range(rounds + 1):
        for command in commands:
            if command.before:
                command.before()
            cpu, wall, peak = measured(command)
            figures = found[command.name]
            if number:
                figures.cpu.append(cpu)
                figures.wall.append(wall)
                figures.peak = max(figures.peak, peak)
    return found


def measured(command: Command) -> tuple[float, float, float]:
    """Return the CPU seconds of all processes of a command, its wall seconds and the peak of its memory."""
    environment = {**os.environ, **command.environment}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # each start would compile anew what has no bytecode
    began = time.perf_counter()
    running = subprocess.Popen(
        command.words, cwd=command.cwd, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    )
    error = running.stderr.read() if running.stderr else b""
    _, status, used = os.wait4(running.pid, 0)
    running.returncode = os.waitstatus_to_exitcode(status)
    if running.returncode not in (0, 1):
        sys.exit(f"{' '.join(command.words)}: {error.decode(errors='replace')}")
    return used.ru_utime + used.ru_stime, time.perf_counter() - began, peak_of(used)


def peak_of(used: resource.struct_rusage) -> float:
    return used.ru_maxrss / (1024 if sys.platform != "darwin" else 1024 * 1024)
