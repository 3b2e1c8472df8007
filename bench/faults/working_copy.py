"""A copy of a repository whose files are shared with it until they change."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from bench.faults.fault import PutFault


class WorkingCopy:
    """The files are hard links: one that changes is written anew, never into."""

    def __init__(self, original: Path, folder: Path) -> None:
        self.original, self.folder = original, folder
        shutil.copytree(original, folder, symlinks=True, copy_function=link_or_copy)

    @contextmanager
    def with_fault(self, fault: PutFault) -> Iterator[None]:
        try:
            for path, data in fault.files.items():
                self.put(path, data, path in fault.not_executable)
            yield
        finally:
            for path in fault.files:
                self.restore(path)

    def put(self, path: str, data: bytes | None, is_executable_no_more: bool = False) -> None:
        target = self.folder / path
        mode = target.stat().st_mode if target.exists() else 0o644
        target.unlink(missing_ok=True)
        if data is not None:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
            target.chmod(0o644 if is_executable_no_more else mode)

    def restore(self, path: str) -> None:
        target = self.folder / path
        target.unlink(missing_ok=True)
        if (self.original / path).exists():
            link_or_copy(str(self.original / path), str(target))
        else:
            for parent in target.parents:
                if parent == self.folder or any(parent.iterdir()):
                    break
                parent.rmdir()


def link_or_copy(source: str, target: str) -> None:
    try:
        os.link(source, target, follow_symlinks=False)
    except OSError:
        shutil.copy2(source, target)
