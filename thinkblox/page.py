"""A report as one HTML page, with a picture in which the faults are drawn."""
