"""Pictures of scenes and assets by ray casting: no display, no GL; the same picture on every run."""

from thinkblox.sim.render.preview import render_preview

__all__ = ["render_preview"]
