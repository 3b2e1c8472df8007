"""What was written for a package under another name, as it reads under the name of today."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

from ..light_dataclasses import dataclass
from .answers_record import AnswersRecord
from .line_digests import digest, digests, lines_of
from .write import is_there


@dataclass(frozen=True)
class RenamedRecord:
    """A record with the name that its package has today; where that is the old one, everything is as it was."""

    record: AnswersRecord
    name: str

    @property
    def old_name(self) -> str:
        return self.record.request.name or self.name

    def paths(self) -> dict[str, tuple[str, ...]]:
        """Return the digests of each file, by its path under the name of today."""
        old = as_word(self.old_name)
        return {old.sub(self.name, path): lines for path, lines in self.record.lines.items()}

    def moves(self, package: Path, paths: Iterable[str]) -> dict[str, str]:
        """Return where files are that still have the old name, as `rospkg rename` leaves it to launch files."""
        wanted, old, found = set(paths), as_word(self.old_name), dict[str, str]()
        for path in self.record.lines:
            target = old.sub(self.name, path)
            if target in wanted and target != path and is_there(package / path) and not is_there(package / target):
                found[target] = path
        return found

    def lines(self, written: Sequence[str], yours: bytes, new: bytes) -> tuple[str, ...]:
        """Return the digests of a file as its lines read today; a line that still has the old name stays as it was."""
        if self.old_name == self.name:
            return tuple(written)
        word, now = as_word(self.name), dict[str, str]()
        for line in (*lines_of(yours), *lines_of(new)):
            text = line.decode("utf-8", "surrogateescape")
            now[digest(word.sub(self.old_name, text).encode("utf-8", "surrogateescape"))] = digest(line)
        left = set(digests(yours))
        return tuple(each if each in left else now.get(each, each) for each in written)


def as_word(name: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![A-Za-z0-9_]){re.escape(name)}(?![A-Za-z0-9_])")
