"""Write the table of what common modules of Python's standard library have: python -m bench.module_attributes."""

from __future__ import annotations

import importlib
import platform
import textwrap
from datetime import date

from .tables import Origin, Revision, write

MODULES = (
    "argparse collections copy csv datetime functools glob io itertools json logging math os os.path pathlib pickle "
    "queue random re shutil signal socket struct subprocess sys tempfile threading time traceback uuid"
).split()
LATER = {
    "argparse": "BooleanOptionalAction",
    "copy": "replace",
    "datetime": "UTC",
    "glob": "translate",
    "itertools": "batched",
    "json": "tool",
    "math": "fma sumprod",
    "os": "EX_OK process_cpu_count unshare setns listdrives listmounts listvolumes pidfd_open startfile timerfd_create",
    "os.path": "isdevdrive isjunction isreserved splitroot",
    "pathlib": "UnsupportedOperation types",
    "queue": "ShutDown",
    "random": "binomialvariate",
    "shutil": "WindowsError",
    "signal": "CTRL_C_EVENT",
    "sys": "activate_stack_trampoline getwindowsversion last_exc monitoring ps1 ps2 setdlopenflags winver",
    "threading": "setprofile_all_threads settrace_all_threads",
    "uuid": "uuid6 uuid7 uuid8",
}
"""What other versions and platforms have."""


ABOUT = {"module_attributes.txt": "What common modules of Python's standard library have: module, then names."}
ORIGIN = Origin(
    "`dir()` of the modules of CPython, names of later versions and of other platforms",
    "PSF-2.0",
    "bench/module_attributes.py",
)


def main() -> None:
    rows: list[str] = []
    for module in MODULES:
        names = {each for each in dir(importlib.import_module(module)) if each[0] != "_"}
        text = " ".join(sorted(names | set(LATER.get(module, "").split())))
        rows += [f"{module} {line}" for line in textwrap.wrap(text, 110 - len(module), break_on_hyphens=False)]
    for table, about in ABOUT.items():
        write(table, about, rows, ORIGIN, Revision(platform.python_version(), date.today().isoformat()))


if __name__ == "__main__":
    main()
