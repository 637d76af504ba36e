"""Opening and measuring whatever a path holds: one of our scenes, a model, or the layout of another generator."""
