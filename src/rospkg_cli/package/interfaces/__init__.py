"""Messages, services and actions: their text, their fields, and which a package generates."""
