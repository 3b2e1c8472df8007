"""Regular expressions that are compiled when they are first used: a run uses some of the three hundred that we have."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    regex = re.compile
else:

    class regex:
        """Has what an `re.Pattern` has; from its first use on its methods are those of the pattern itself."""

        def __init__(self, text, flags=0):
            self._text, self._flags = text, flags

        def __getattr__(self, name):
            if name.startswith("__"):
                raise AttributeError(name)
            compiled = re.compile(self._text, self._flags)
            self.search, self.match, self.fullmatch = compiled.search, compiled.match, compiled.fullmatch
            self.finditer, self.findall, self.split = compiled.finditer, compiled.findall, compiled.split
            self.sub, self.subn = compiled.sub, compiled.subn
            self.pattern, self.flags = compiled.pattern, compiled.flags
            self.groups, self.groupindex = compiled.groups, compiled.groupindex
            return getattr(compiled, name)
