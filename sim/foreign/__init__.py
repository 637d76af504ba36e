"""Models that we did not make: looked through before the engine sees them, and measured as they are."""
