"""A report as one HTML page, with pictures in which the faults are drawn."""

from thinkblox.page.document import page_of, write_page

__all__ = ["page_of", "write_page"]
