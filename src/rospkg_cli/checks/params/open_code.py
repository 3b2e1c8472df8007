"""Code whose nodes may have parameters that it does not declare by name: a value for one is not surely dropped."""

from __future__ import annotations

import re
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.params.cpp_parameters import has_computed_cpp_names
from ...package.params.python_parameters import has_computed_names
from .parameter_reads import ParameterReads, allows_any

GETS_ALL = regex(
    r"\b(?:get_parameter_overrides|list_parameters|get_parameters_by_prefix|_parameter_overrides|ParameterEventHandler)\b"
)
"""How code gets values under names that it does not hold."""
DIGITS = regex(r"\d")


@dataclass(frozen=True)
class OpenCode:
    reads: ParameterReads

    def may_read(self, name: str, intended: str) -> bool:
        """Return whether code of the package may read a parameter that it does not declare, and that is like another.

        Its name stands in the code, it differs by a number, or names are made when the code runs.
        """
        last = name.rpartition(".")[2]
        is_numbered = DIGITS.sub("", last) == DIGITS.sub("", intended.rpartition(".")[2])
        word = re.compile(rf"(?<!\w){re.escape(last)}(?!\w)")
        return is_numbered or self.is_open or any(map(word.search, self.texts))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        cpp = (file.source.text for file in self.reads.cpp)
        return (*cpp, *(file.source.text for file in self.reads.run_files))

    @cached_property
    def is_open(self) -> bool:
        """Whether nodes take undeclared parameters, or names are known at run time alone."""
        sources = (*(each.source for each in self.reads.cpp), *(each.source for each in self.reads.run_files))
        if any(map(allows_any, sources)) or any(map(GETS_ALL.search, self.texts)):
            return True
        is_computed = any(map(has_computed_cpp_names, self.reads.cpp))
        is_computed = is_computed or any(map(has_computed_names, self.reads.run_files))
        return is_computed or self.reads.own.is_handed_out or self.reads.own.has_foreign_base
