"""Moving what fails by the least that mends it."""
