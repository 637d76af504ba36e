"""What can be placed: procedural furniture and its properties."""
