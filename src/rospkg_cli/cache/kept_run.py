"""A whole run: what it printed, its exit status, and every question that it asked of the disk."""

from __future__ import annotations

import os
from zlib import crc32

from .. import disk_trace
from .folder import cache_folder, is_safe, make_folder
from .kept_file import load, save
from .own_code import HERE, code_digest, code_signature, installed_in, search_path
from .recheck import Question, recheck
from .run_key import file_name, run_key

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


class RunToKeep:
    """A run that begins: kept at its end, unless something speaks against it."""

    def __init__(self, key: list[str]) -> None:
        self.key = key
        self.code = code_signature()
        self.digest = "" if self.code else code_digest()
        """Of the sources before they are imported."""
        self.text: str | None = None
        """What it printed; None where it can't be kept."""
        self.installed = {f"p{folder}": installed_in(folder) for folder in search_path()}
        self.start()

    def start(self) -> None:
        """Begin anew with what is asked of the disk; what rospkg and its surroundings are stays as it was loaded."""
        self.trace = disk_trace.start_trace()
        self.trace.answers |= self.installed

    def code_digest(self, folder: str) -> str:
        """Return the digest of the sources that this process was started with; "" where they changed since."""
        return self.digest or digest_of(self.code, folder)

    def keep(self, status: int) -> None:
        """Keep the run with its exit status, where it ended as it should."""
        is_traced = disk_trace.current_trace() is self.trace
        disk_trace.stop_trace()
        folder = cache_folder(os.environ)
        if status not in (0, 1) or self.text is None or not is_traced or not self.trace.is_whole:
            return
        if not make_folder(folder):
            return
        code = self.code_digest(folder)
        if not code:
            return
        known = self.trace.signatures
        asked = [(question, answer, known.get(question, "")) for question, answer in self.trace.answers.items()]
        path = os.path.join(folder, file_name(self.key))
        write_run(path, self.key, status, self.text, [(f"o{HERE}", code, self.code), *asked])
        from .prune import prune_sometimes

        prune_sometimes(folder)


def kept_run(arguments: Sequence[str]) -> tuple[int, str] | RunToKeep | None:
    """Return the status and the output of a run that would end as one before did.

    Else the run that begins, and is to be kept; None where it must not be.
    """
    key, folder = run_key(arguments), cache_folder(os.environ)
    if key is None or not folder:
        return None
    path = os.path.join(folder, file_name(key))
    found = read_run(path, key) if is_safe(folder) else None
    if found is not None:
        status, text, before = found
        now = recheck(before)
        if now is not None:
            if now != before or is_old(path):
                write_run(path, key, status, text, now)
            return status, text
    return RunToKeep(key)


def is_old(path: str) -> bool:
    """Return whether a file was written more than a day ago: one that is served is as good as new."""
    from time import time

    try:
        return time() - os.stat(path).st_mtime > 86_400
    except OSError:
        return False


def read_run(path: str, key: list[str]) -> tuple[int, str, list[Question]] | None:
    """Return what is kept of a run; None where nothing is, or the file is damaged."""
    fields = load(path)
    start = 1 + len(key)
    if fields is None or len(fields) < start + 2 or (len(fields) - start) % 3 != 2:
        return None
    if fields[0] != str(len(key)) or fields[1:start] != key or not fields[start].isdecimal():
        return None
    rest = iter(fields[start + 2 :])
    return int(fields[start]), fields[start + 1], list(zip(rest, rest, rest, strict=True))


def write_run(path: str, key: list[str], status: int, text: str, questions: Sequence[Question]) -> None:
    save(path, [str(len(key)), *key, str(status), text, *(part for each in questions for part in each)])


def digest_of(signature: str, folder: str) -> str:
    """Return a digest of rospkg's sources, "" where they are no longer those of a signature.

    It is remembered: reading all sources takes longer than linting a small package.
    """
    path = os.path.join(folder, f"code-{crc32(os.fsencode(HERE)):08x}")
    known = load(path)
    if known is not None and len(known) == 3 and known[:2] == [HERE, signature]:
        return known[2]
    digest = code_digest()
    if code_signature() != signature:
        return ""
    save(path, [HERE, signature, digest])
    return digest


_run: RunToKeep | None = None


def set_run(run: RunToKeep | None) -> None:
    """Say which run this process was started for."""
    global _run
    _run = run


def run_to_keep() -> RunToKeep | None:
    """Return the run that this process was started for; None where nothing is to be kept."""
    return _run
