"""What the verbs have in common that change packages: add, remove and their like."""
