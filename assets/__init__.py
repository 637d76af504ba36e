"""What can be placed: procedural furniture and its properties."""

from thinkblox.assets.catalogue import CATALOGUE
from thinkblox.assets.category import Category
from thinkblox.assets.make import category_of, fit_asset, make_asset

__all__ = ["CATALOGUE", "Category", "category_of", "fit_asset", "make_asset"]
