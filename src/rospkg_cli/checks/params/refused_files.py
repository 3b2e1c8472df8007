"""Whether rcl refuses a parameter file as a whole: then no node reads what else is wrong in it."""

from __future__ import annotations

from collections.abc import Iterator

from ..fault import Fault
from .parameter_file_use import ParameterFileUse
from .rcl_validation import rcl_faults
from .rcl_values import EMPTY_LIST
from .ros_parameters_key import key_faults


def is_refused(use: ParameterFileUse) -> bool:
    """Return whether a file that a launch file gives to nodes has what rcl stops at; what YAML 1.1 reads goes on."""
    return use.is_handed and not use.is_parsed_by_launch and any(True for _ in refused(use))


def refused(use: ParameterFileUse) -> Iterator[Fault]:
    """Yield what stops every node that is given the file; an empty list stops the nodes of its block alone."""
    yield from key_faults(use.file, is_parsed_by_launch=False)
    for fault in rcl_faults(use.file):
        if fault.level is None and not fault.message.startswith(EMPTY_LIST) and not use.is_rewritten(fault.span):
            yield fault
