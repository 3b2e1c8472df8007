class ExternalShutdownException(Exception):
    """Raised by `spin` when somebody else shut the context down."""
