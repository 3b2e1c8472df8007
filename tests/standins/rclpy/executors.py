class ExternalShutdownException(Exception):
    """Raised by `spin` when somebody else shut the context down."""


class MultiThreadedExecutor:
    """Only a name here: `spin` runs goals in threads of their own anyway."""
