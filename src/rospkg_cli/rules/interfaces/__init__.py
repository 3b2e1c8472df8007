"""Rules of messages, services and actions (IDL)."""
