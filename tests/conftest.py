from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from thinkblox.scene.asset import Asset, Link, Shape

# On a busy machine an example takes as long as it takes; what matters is what comes out.
settings.register_profile("whatever the load", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("whatever the load")


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


@pytest.fixture(scope="session")
def tiny_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a random vision-language model; do not write into it."""
    torch = pytest.importorskip("torch")
    # Threads that wait for each other make so small a model slow wherever the processor is shared.
    torch.set_num_threads(1)
    from thinkblox.policies.tiny import build_tiny

    return build_tiny(tmp_path_factory.mktemp("tiny") / "model")
