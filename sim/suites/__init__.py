"""Suites of published criteria, each named after its source."""
