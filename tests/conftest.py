import pytest
from hypothesis import settings

from thinkblox.scene.asset import Asset, Link, Shape

# A busy machine makes an example slow, not wrong.
settings.register_profile("steady", deadline=None)
settings.load_profile("steady")


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
