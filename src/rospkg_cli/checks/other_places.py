"""The sentence about a file that is installed, but not where it is looked for."""

from __future__ import annotations


def goes_elsewhere(package: str, path: str, destination: str) -> str:
    """Return where a file goes: the path to write, or, outside of the share directory, the one below the prefix."""
    inside = path_in_share(package, destination)
    if inside is not None:
        return f"`{package}` installs `{path}` as `{inside}`"
    return f"`{package}` installs `{path}` to `{destination}`, not into its share directory"


def how_to_find_it(package: str, path: str, destination: str) -> str:
    inside = path_in_share(package, destination)
    return f"write `{inside}`" if inside is not None else f"install it to `share/{package}/{path}`"


def path_in_share(package: str, destination: str) -> str | None:
    """Return the path in the package's share directory; None where a file goes elsewhere."""
    share = f"share/{package}/"
    return destination.removeprefix(share) if destination.startswith(share) else None
