"""Measured tables of the documents: what they are, how docs/measure makes them, and where their data are."""
