"""English, read with an open vocabulary: noun phrases, clauses, what they refer to, and what became of every word."""
