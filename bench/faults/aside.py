"""Kinds of faults that count only in what is built and run."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import wraps

from bench.faults.fault import PutFault
from bench.faults.kinds import Places, kind
from bench.faults.source_package import SourcePackage
from rospkg_cli.package.file_role import role_of

ON_PURPOSE = "what lies with tests or documents may be wrong on purpose, and nothing may read it"


def used_kind(family: str, *, is_seen_outside: bool = False) -> Callable[[Places], Places]:
    """Register a kind whose faults are excluded in folders of tests and documents."""

    def register(places: Places) -> Places:
        @wraps(places)
        def weighed(package: SourcePackage) -> Iterator[PutFault]:
            for fault in places(package):
                path = fault.path.removeprefix(f"{package.folder}/")
                yield fault.known(role_of(path) not in ("test", "aside"), ON_PURPOSE)

        return kind(family, is_seen_outside=is_seen_outside)(weighed)

    return register
