"""What PLG005 says of a loader whose package does not exist, with its fix."""

from __future__ import annotations

from ..checks.plugins.unmatched_loaders import UnmatchedLoader
from ..finding import Edit, Fix, Hit, Safety
from .plain_names import only_plain_names


def at_loader(found: UnmatchedLoader) -> Hit:
    package, base = found.loader.names
    argument = found.loader.package
    message = f"`{package}` is no known package: the loader of `{base}` throws when it is created"
    if found.suggestion is None:
        return Hit(found.loader.path, argument.inner, f"{message}; name the package of the base class")
    fix = Fix(
        f"write `{found.suggestion}`", (Edit(found.loader.path, argument.inner, found.suggestion),), Safety.UNSAFE
    )
    return Hit(
        found.loader.path,
        argument.inner,
        f"{message}; write `{found.suggestion}`, to which its plugins are exported",
        fix=only_plain_names(fix, found.suggestion),
    )
