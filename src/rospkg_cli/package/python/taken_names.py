"""What a package's Python code takes out of modules that are not its own."""

from __future__ import annotations

from ...files import ReaderInput
from ...ros.imports import STANDARD
from .python_imports import PackageImports


def taken_names(reading: ReaderInput) -> frozenset[tuple[str, str]]:
    """Return each module with a name that is taken out of it; "" for a module that is imported as a whole."""
    imports = reading.parts(PackageImports).only
    files = imports.files if imports is not None else ()
    taken = (each for file in files if file.role in ("run", "launch") for each in file.imports if not each.level)
    foreign = (each for each in taken if each.module.partition(".")[0] not in STANDARD)
    return frozenset((each.module, name) for each in foreign for name in each.names or ("",))
