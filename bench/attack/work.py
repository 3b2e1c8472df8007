"""Processes that run inputs, and the watch over them: one that hangs or dies is a find, and the others go on."""

from __future__ import annotations

import faulthandler
import gc
import multiprocessing
import os
import signal
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any

from .case import make_case
from .corpus import Corpus
from .limits import SECONDS, limit_memory, place_of
from .steps import Attempt

Row = dict[str, Any]
CHUNK = 40
"""Inputs that one process runs: then it is replaced, so that what it has cached does not count as an input's memory."""
PATIENCE = 20 * SECONDS
"""CPU seconds that one input may take altogether before its process is ended."""
STILL = 20.0
"""Wall seconds without any CPU time after which a process is believed to wait for good."""
TICK = 1 / os.sysconf("SC_CLK_TCK")


@dataclass
class Plan:
    """What every process needs to know."""

    corpus: Corpus
    seed: int
    room: Path
    """A folder for the trees of the inputs; one in memory is best."""


def run_case(plan: Plan, number: int) -> Row:
    """Run one input in this process and return its row."""
    case = make_case(plan.corpus, plan.seed, number)
    outcome = Attempt(case, plan.room / f"{os.getpid()}_{number}").run()
    return {"case": number, "kind": case.kind, "how": case.how, **asdict(outcome)}


def work(plan: Plan, numbers: Sequence[int], pipe: Connection, trace: Path) -> None:
    """Run inputs and send the rows of each; before each its number."""
    limit_memory()
    os.nice(10)
    with trace.open("w") as stream:
        faulthandler.register(signal.SIGUSR1, stream, all_threads=False)
        for number in numbers:
            pipe.send(number)
            pipe.send(run_case(plan, number))
    pipe.close()


@dataclass
class Worker:
    """A process, the inputs it has still to do, and since when it is at one."""

    plan: Plan
    left: list[int]
    trace: Path
    began: float = 0.0
    used: float = 0.0
    """CPU seconds when it was looked at last."""
    start: float = 0.0
    """CPU seconds when it began with its input."""
    current: int | None = None
    process: BaseProcess = field(init=False)
    pipe: Connection = field(init=False)

    def __post_init__(self) -> None:
        context = multiprocessing.get_context("fork")
        self.pipe, theirs = context.Pipe(duplex=False)
        self.process = context.Process(target=work, args=(self.plan, tuple(self.left), theirs, self.trace))
        self.process.start()
        theirs.close()

    def cpu(self) -> float:
        try:
            parts = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        except OSError:
            return self.used
        return (int(parts[11]) + int(parts[12])) * TICK

    def receive(self) -> Row | None:
        """Return the row that has come, if it is one; raises EOFError when the process is gone."""
        found = self.pipe.recv()
        self.began, self.used = time.monotonic(), self.cpu()
        if isinstance(found, int):
            self.current, self.start = found, self.used
            return None
        self.left.remove(found["case"])
        self.current = None
        row: Row = found
        return row

    def is_stuck(self) -> str:
        """Return why the process must be ended; empty where it need not."""
        if self.current is None:
            return ""
        now = self.cpu()
        if now - self.start > PATIENCE:
            return f"hangs: {now - self.start:.0f} s of CPU"
        if now - self.used > 0.1:
            self.began, self.used = time.monotonic(), now
        return "waits for good" if time.monotonic() - self.began > STILL else ""

    def end(self, why: str) -> Row:
        """End the process and return the row of what it was at."""
        assert self.process.pid is not None
        assert self.current is not None
        if why:
            os.kill(self.process.pid, signal.SIGUSR1)
            time.sleep(0.5)
            self.process.kill()
        self.process.join()
        number, code = self.current, self.process.exitcode
        self.left.remove(number)
        case = make_case(self.plan.corpus, self.plan.seed, number)
        text = self.trace.read_text() if self.trace.exists() else ""
        frames = "\n".join(reversed(text.splitlines()))  # the newest call comes first there
        what = why or f"the process died of {code}"
        fault = {"step": "?", "what": what, "where": place_of(frames), "detail": ""}
        return {
            "case": number,
            "kind": case.kind,
            "how": case.how,
            "faults": [fault],
            "statuses": {},
            "seconds": {},
            "memory": 0,
        }


def run_all(plan: Plan, numbers: Sequence[int], jobs: int) -> Iterator[Row]:
    """Yield the row of every input, as they are done."""
    gc.freeze()  # what was read before is shared by the processes
    chunks = [list(numbers[at : at + CHUNK]) for at in range(0, len(numbers), CHUNK)]
    workers: list[Worker] = []
    count = 0
    while chunks or workers:
        while chunks and len(workers) < jobs:
            count += 1
            workers.append(Worker(plan, chunks.pop(0), plan.room / f"trace_{count}"))
        ready = wait([worker.pipe for worker in workers], 1.0)
        for worker in list(workers):
            row, gone = None, False
            if worker.pipe in ready:
                try:
                    row = worker.receive()
                except EOFError:
                    gone = True
            why = "" if gone else worker.is_stuck()
            if why or gone:
                workers.remove(worker)
                if worker.current is not None:
                    row = worker.end(why)
                    chunks[:0] = [worker.left] if worker.left else []
                worker.process.join()
            if row is not None:
                yield row
