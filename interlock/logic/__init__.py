"""Control logic and physics in one expression language."""
