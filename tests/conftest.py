import pytest
from hypothesis import settings

from thinkblox.scene.asset import Asset, Link, Shape

# How long an example takes says more of what else the machine does than of the code.
settings.register_profile("unhurried", deadline=None)
settings.load_profile("unhurried")


def unit_box() -> Asset:
    shape = Shape(kind="box", size=(1.0, 1.0, 1.0), position=(0.0, 0.0, 0.5))
    return Asset(
        id="box-0",
        category="box",
        description="a box",
        size=(1.0, 1.0, 1.0),
        mass=10.0,
        friction=0.6,
        mount="floor",
        links=(Link(name="body", shapes=(shape,)),),
    )


@pytest.fixture
def box_asset() -> Asset:
    return unit_box()
