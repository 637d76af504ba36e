import base64
import hashlib
import io
import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
import shapely
from msgspec import structs
from PIL import Image

from tests.foreign_models import crate, opened, reported
from tests.sim_rooms import asset, put, scene, table, vase, wardrobe
from thinkblox.errors import InputError
from thinkblox.page import page_of, write_page
from thinkblox.page.markup import VOID, element
from thinkblox.page.tables import MOST_FINDINGS
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.drawn import FaultPicture, Mark
from thinkblox.sim.render.fault_pictures import fault_pictures
from thinkblox.sim.render.model_soup import add_model
from thinkblox.sim.render.sights import Scenery, from_above, scenery_of
from thinkblox.sim.render.soup import ROOM, Soup
from thinkblox.sim.subject import subject_of
from thinkblox.sim.verdict.verify import verify
from thinkblox.suite import Criterion, Finding, SuiteResult
from thinkblox.verdict import Absence, Access, MendingMove, Push, Reason, RelationResult, Report, Swing, Verdict

CRATE = asset("crate", (0.5, 0.5, 0.5), mass=30.0)
HEAVY = asset("safe", (0.6, 0.6, 0.8), mass=80.0)
PICTURE = asset("picture", (0.03, 0.6, 0.4), mount="wall", mass=2.0)
DOOR = Opening(id="door_1", kind="door", wall=0, offset=1.0, width=0.9, height=2.05)
SIZE = 300
NASTY = "<script>alert(1)</script> \"'&\x07"


class Page(HTMLParser):
    """What a page is made of; feeding it checks that every element is closed where it should be."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[str] = []
        self._open: list[str] = []
        self.feed(text)
        self.close()
        assert self._open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert len(dict(attrs)) == len(attrs), f"an attribute twice in {tag}"
        self.elements.append((tag, dict(attrs)))
        self._open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert tag in VOID
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self._open and self._open[-1] not in ("script", "style"):
            self.texts.append(data)

    def all(self, tag: str, **wanted: str) -> list[dict[str, str | None]]:
        found = [a for name, a in self.elements if name == tag]
        return [
            a for a in found if all(value in (a.get(key.rstrip("_")) or "").split() for key, value in wanted.items())
        ]

    @property
    def text(self) -> str:
        return " ".join(self.texts)


def page_for(where: Scene, report: Report | None = None, title: str = "A room") -> Page:
    return Page(page_of(report or verify(where), subject_of(where), title=title, size=SIZE))


def failed(id: str, *reasons: Reason, **more: object) -> Verdict:
    return structs.replace(Verdict(id=id, valid=False, reasons=reasons), **more)


def pictured(where: Scene, report: Report) -> tuple[FaultPicture, FaultPicture, Scenery]:
    numbers = {v.id: n for n, v in enumerate([v for v in report.objects if not v.valid], 1)}
    subject = subject_of(where)
    return *fault_pictures(report, subject, numbers, size=SIZE), scenery_of(subject)


def marks(picture: FaultPicture, kind: str) -> list[Mark]:
    return [mark for mark in picture.marks if mark.kind == kind]


def metres(scenery: Scenery) -> float:
    """Size of a pixel of the plan [m]."""
    return 2 * from_above(scenery).camera.reach / SIZE


@pytest.fixture(scope="module")
def faulty() -> Scene:
    return scene(
        rectangle(4.0, 4.0, openings=(DOOR,)), (put(table(), 2.5, 2.5), table()),
        (put(vase(), 2.5, 2.5, 0.747, on="table_1"), vase()), (put(CRATE, 0.15, 3.0), CRATE),
        (put(CRATE, 1.4, 0.5, id="crate_2"), CRATE), (put(CRATE, 3.5, 0.5, 0.4, id="crate_3"), CRATE),
        (put(PICTURE, 3.0, 3.9, 1.5, yaw=270.0, on="north_wall"), PICTURE), (put(HEAVY, 3.6, 1.6), HEAVY),
    )  # fmt: skip


@pytest.fixture(scope="module")
def page(faulty: Scene) -> Page:
    return page_for(faulty)


def test_the_page_is_whole_and_needs_nothing_else(page: Page) -> None:
    ids = [a["id"] for _, a in page.elements if "id" in a]
    assert len(ids) == len(set(ids))
    for tag, attributes in page.elements:
        for name in ("src", "href", "xlink:href", "data", "action", "poster", "srcset"):
            value = attributes.get(name)
            assert value is None or value.startswith(("data:image/jpeg;base64,", "#")), (tag, name, value)
        assert not [name for name in attributes if name.startswith("on") or name == "style"]
    targets = {a["href"] for a in page.all("a")}
    assert targets <= {f"#{id}" for id in ids}
    assert not page.all("link")
    assert page.all("html")[0]["lang"] == "en"


def test_tables_have_headings_and_pictures_have_words(page: Page, faulty: Scene) -> None:
    assert len(page.all("img")) == 2
    for image in page.all("img"):
        alt = image["alt"] or ""
        assert len(alt) > 40
        assert "1 vase_1" in alt or "1 table_1" in alt
    assert all(a.get("scope") in ("col", "row") for a in page.all("th"))
    assert len(page.all("th", scope="row")) >= len(faulty.placements)
    assert len(page.all("caption")) == len(page.all("table"))


def test_the_policy_allows_only_what_the_page_brings(faulty: Scene) -> None:
    text = page_of(verify(faulty), subject_of(faulty), title="x", size=SIZE)
    policy = (
        Page(text).all("meta", http_equiv="")[0]["content"]
        if False
        else re.findall(r'content="(default[^"]*)"', text)[0]
    )
    assert policy.startswith("default-src &#x27;none&#x27;")
    for tag in ("style", "script"):
        inside = re.findall(f"<{tag}>(.*?)</{tag}>", text, re.DOTALL)
        assert len(inside) == 1
        assert base64.b64encode(hashlib.sha256(inside[0].encode()).digest()).decode() in policy


def test_the_outcome_comes_first_and_every_number_is_there(page: Page) -> None:
    words = " ".join(page.text.split())
    assert words.index("6 of 7 objects fail") < words.index("What was read") < words.index("Verdict")
    for expected in (
        "3.0",
        "door_1",
        "reaches 100.0 mm outside the room",
        "nothing supports it",
        "carried by",
        "4.00 m by",
    ):
        assert expected.lower() in words.lower(), expected
    assert len(page.all("tr", id="object-1")) == 1
    assert len(page.all("span", class_="disc")) == len(page.all("g", class_="badge")) / 2


def test_a_row_and_its_object_share_a_number(page: Page) -> None:
    rows = {a["data-n"] for a in page.all("tr") if "data-n" in a}
    assert rows == {str(n) for n in range(1, 8)}
    assert {a["data-n"] for a in page.all("g") if "data-n" in a} == rows


def test_every_sign_is_explained(page: Page) -> None:
    drawn = set()
    for kind in ("overlap", "outside", "zone"):
        drawn |= {kind for a in page.all("path", class_=kind)}
    assert drawn == {"overlap", "outside", "zone"}
    for says in ("what two objects both fill", "outside the room", "should be free", "hangs free"):
        assert says in page.text


def test_a_faultless_room_has_nothing_drawn() -> None:
    page = page_for(scene(None, (put(CRATE, 2.0, 2.0), CRATE)))
    assert "All of it passes" in page.text
    assert not page.all("g", class_="badge")
    assert not page.all("ul")
    assert page.all("div", class_="passes")


def test_an_empty_room_is_a_page_too() -> None:
    page = page_for(scene())
    assert "There is nothing in it" in page.text
    assert len(page.all("img")) == 2


def test_names_from_outside_are_text(tmp_path: Path) -> None:
    name = NASTY.replace("\x07", "").replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    subject = opened(
        tmp_path, f"<mujoco><worldbody>{crate(name, '0 0 0.1')}{crate('b', '0.15 0 0.1')}</worldbody></mujoco>"
    )
    id = subject.things[0].id
    assert "<script>" in id
    suite = SuiteResult(suite=NASTY, source=NASTY, passed=False, notes=(NASTY,), criteria=(
        Criterion(name=NASTY, says=NASTY, unit=NASTY, limit=1.0, value=2.0, passed=False, note=NASTY,
                  findings=(Finding(object=NASTY, value=1.0, passed=False, note=NASTY),)),))  # fmt: skip
    report = Report(
        valid=False, prompt=NASTY, versions={NASTY: NASTY}, source=NASTY, unusual=(NASTY,), substituted=(NASTY,),
        notes=(NASTY,), unknown=(NASTY,), suites=(suite,),
        absent=(Absence(id=NASTY, category=NASTY, asked=True, reason=NASTY),),
        relations=(RelationResult(kind=NASTY, subject=NASTY, anchors=(NASTY,), holds=False, measured=NASTY),),
        walker=Access(width=0.5, reach=1.0, unreachable=(id, NASTY)),
        moves=(MendingMove(id=NASTY, by=(0.0, 0.0, 0.0), turn=0.0, distance=0.0, why=("drop",), mended=False),),
        objects=(failed(id, "error", message=NASTY), failed(NASTY, "collision", blocked=(NASTY,))),
    )  # fmt: skip
    text = page_of(report, subject, title=NASTY, size=SIZE)
    page = Page(text)
    assert text.count("<script") == 1
    assert "\x07" not in text
    assert page.text.count("<script>alert(1)</script>") > 15
    assert id in [t for t in page.texts if "alert" in t]


def test_elements_escape_what_is_not_markup() -> None:
    assert element("p", "<b>", element("i", "&"), title='"x"') == '<p title="&quot;x&quot;">&lt;b&gt;<i>&amp;</i></p>'
    assert element("img", src="a", hidden=True, alt=None, width=2.5) == '<img src="a" hidden width="2.5"/>'


def test_the_part_outside_is_drawn_to_scale() -> None:
    where = scene(rectangle(4.0, 4.0), (put(HEAVY, 0.1, 2.0), HEAVY))
    _, plan, scenery = pictured(where, verify(where))
    (mark,) = marks(plan, "outside")
    assert mark.arrow is not None
    (x0, y0), (x1, y1) = mark.arrow
    assert np.hypot(x1 - x0, y1 - y0) * metres(scenery) == pytest.approx(max(0.2, 20 * metres(scenery)), abs=0.01)
    assert x1 < x0
    assert abs(y1 - y0) < 0.2
    area = shapely.Polygon(mark.rings[0]).area * metres(scenery) ** 2
    assert area == pytest.approx(0.2 * 0.6, rel=0.05)


def test_an_overlap_is_drawn_once_where_it_is() -> None:
    where = scene(rectangle(4.0, 4.0), (put(HEAVY, 2.0, 2.0), HEAVY), (put(CRATE, 2.45, 2.0), CRATE))
    view, plan, scenery = pictured(where, verify(where))
    assert len(marks(view, "overlap")) == len(marks(plan, "overlap")) == 1
    (mark,) = marks(plan, "overlap")
    shared = shapely.Polygon(mark.rings[0])
    assert shared.area * metres(scenery) ** 2 == pytest.approx(0.1 * 0.5, rel=0.1)
    expected = from_above(scenery).camera.project(np.array([[2.25, 2.0, 0.3]]), SIZE)[0]
    assert (shared.centroid.x, shared.centroid.y) == pytest.approx(tuple(expected), abs=1.5)
    assert mark.text == "100 mm deep" if mark.text else True


def test_a_speck_of_an_overlap_gets_a_ring(faulty: Scene) -> None:
    view, _, _ = pictured(faulty, verify(faulty))
    (mark,) = marks(view, "overlap")
    assert mark.rings or mark.circles


def test_outlines_are_as_large_as_what_is_seen() -> None:
    where = scene(rectangle(4.0, 4.0), (put(CRATE, 2.0, 2.0, yaw=30.0), CRATE))
    _, plan, scenery = pictured(where, verify(where))
    (outline,) = plan.outlines
    seen = shapely.Polygon(outline.rings[0]).area * metres(scenery) ** 2
    assert seen == pytest.approx(0.25, rel=0.05)
    assert not outline.hidden


def test_what_is_covered_is_outlined_all_the_same() -> None:
    where = scene(rectangle(4.0, 4.0), (put(table(), 2.0, 2.0), table()), (put(CRATE, 2.0, 2.0), CRATE))
    _, plan, _ = pictured(where, verify(where))
    outline = next(o for o in plan.outlines if o.id == "crate_1")
    assert outline.hidden
    assert len(outline.hull) >= 4


def test_what_hangs_free_has_lines_down_to_what_is_below() -> None:
    where = scene(
        rectangle(4.0, 4.0), (put(table(), 2.0, 2.0), table()), (put(vase(), 2.0, 2.0, 1.15, on="table_1"), vase())
    )
    view, _, _ = pictured(where, verify(where))
    (mark,) = marks(view, "gap")
    assert len(mark.dashes) == 4
    assert mark.text in ("400 mm above", "")
    assert mark.arrow is not None
    assert mark.arrow[1][1] > mark.arrow[0][1]


def test_where_things_end_up_is_found_by_the_engine() -> None:
    where = scene(
        rectangle(4.0, 4.0), (put(table(), 2.0, 2.0), table()), (put(vase(), 2.62, 2.0, 0.75, on="table_1"), vase())
    )
    view, plan, _ = pictured(where, verify(where))
    (mark,) = marks(plan, "rest")
    assert mark.arrow is not None
    assert mark.arrow[1][0] > mark.arrow[0][0] + 5.0
    assert marks(view, "rest")


def test_doors_of_furniture_pushes_and_cut_off_things_are_marked() -> None:
    where = scene(rectangle(4.0, 4.0), (put(wardrobe(), 0.31, 2.5), wardrobe()), (put(CRATE, 3.0, 1.0), CRATE))
    swings = tuple(
        Swing(of="wardrobe_1", link=f"door_{side}", opens=0.3, hits=("crate_1",)) for side in ("left", "right")
    )
    report = Report(
        valid=False,
        objects=(
            failed("wardrobe_1", "blocks_opening", swings=swings),
            failed("crate_1", "pushes", pushed=(Push(other="wardrobe_1", distance=0.02),)),
        ),
        walker=Access(width=0.5, reach=0.5, unreachable=("crate_1", "door_9")),
        moves=(MendingMove(id="crate_1", by=(0.5, 0.0, 0.0), turn=0.0, distance=0.5, why=("drop",), mended=True),),
    )
    _, plan, scenery = pictured(where, report)
    swept = marks(plan, "swing")
    assert len(swept) == 2
    width = 0.5 / metres(scenery)
    for mark in swept:
        x0, y0, x1, y1 = shapely.Polygon(mark.rings[0]).bounds
        assert x1 - x0 == pytest.approx(width, rel=0.15)
        assert y1 - y0 > width
    assert len(marks(plan, "push")) == len(marks(plan, "unreachable")) == 1
    (moved,) = marks(plan, "move")
    assert moved.arrow is not None
    assert (moved.arrow[1][0] - moved.arrow[0][0]) * metres(scenery) == pytest.approx(0.5, rel=0.02)


def test_what_is_far_away_is_named_and_does_not_shrink_the_room() -> None:
    where = scene(rectangle(4.0, 4.0), (put(CRATE, 900.0, 2.0), CRATE), (put(CRATE, 2.0, 2.0, id="crate_2"), CRATE))
    _, plan, scenery = pictured(where, verify(where))
    assert [o.id for o in plan.outlines] == ["crate_2"]
    assert metres(scenery) * SIZE < 6.0
    assert "Too far out to be in the pictures: crate_1" in page_for(where).text


def test_numbers_and_texts_do_not_lie_on_each_other(faulty: Scene) -> None:
    report = verify(faulty)
    numbers = {v.id: n for n, v in enumerate([v for v in report.objects if not v.valid], 1)}
    for picture in fault_pictures(report, subject_of(faulty), numbers, size=600):
        assert [badge.number for badge in picture.badges] == list(range(1, len(numbers) + 1))
        places = [np.array(badge.at) for badge in picture.badges]
        assert all(np.linalg.norm(a - b) > 12.0 for i, a in enumerate(places) for b in places[:i])
        left, top, right, bottom = picture.box
        assert all(left < x < right and top < y < bottom for x, y in places)


MODEL = """
<asset><texture name="t" type="2d" builtin="flat" width="4" height="4" rgb1="1 0 0"/><material name="m" texture="t"/>
<mesh name="wedge" vertex="0 0 0  1 0 0  0 1 0  0 0 1"/><hfield name="h" nrow="3" ncol="3" size="1 1 0.5 0.1"/></asset>
"""
EVERY = """
<geom name="north" type="box" size="2 0.05 1.2" pos="0 2.05 1.2"/>
<geom name="south" type="box" size="2 0.05 1.2" pos="0 -2.05 1.2"/>
<geom name="west" type="box" size="0.05 2 1.2" pos="-2.05 0 1.2"/>
<geom name="east" type="box" size="0.05 2 1.2" pos="2.05 0 1.2"/>
<geom name="ceiling" type="box" size="2 2 0.05" pos="0 0 2.45"/><geom name="ground" type="plane" size="0 0 1"/>
<geom type="hfield" hfield="h" pos="0 0 -2"/>
<body name="ball" pos="1 1 0.1"><freejoint/><geom type="sphere" size="0.1" rgba="1 0 0 1"/></body>
<body name="pill" pos="0 1 0.2"><freejoint/><geom type="capsule" size="0.1 0.1"/></body>
<body name="egg" pos="-1 1 0.2"><freejoint/><geom type="ellipsoid" size="0.1 0.1 0.2"/></body>
<body name="can" pos="1 0 0.2"><freejoint/><geom type="cylinder" size="0.1 0.2"/></body>
<body name="wedge" pos="0 0 0"><freejoint/><geom type="mesh" mesh="wedge" material="m"/></body>
<body name="pair" pos="-1 0 0.2"><freejoint/><geom type="box" size="0.2 0.2 0.2" group="3"/>
  <geom type="box" size="0.1 0.1 0.2" group="2" contype="0" conaffinity="0" rgba="0 0 1 1"/></body>
"""


def test_a_foreign_model_is_pictured_by_what_it_shows(tmp_path: Path) -> None:
    subject = opened(tmp_path, f"<mujoco>{MODEL}<worldbody>{EVERY}</worldbody></mujoco>")
    soup = Soup()
    add_model(soup, subject.model, subject.data(), subject.things)
    extents = {}
    for number, thing in enumerate(subject.things):
        mine = [m.vertices for m, p in zip(soup.meshes, soup.patches, strict=True) if p.owner == number]
        extents[thing.id] = np.ptp(np.concatenate(mine), axis=0)
    assert extents["ball"] == pytest.approx([0.2, 0.2, 0.2], abs=0.003)
    assert extents["pill"] == pytest.approx([0.2, 0.2, 0.4], abs=0.003)
    assert extents["egg"] == pytest.approx([0.2, 0.2, 0.4], abs=0.003)
    assert extents["can"] == pytest.approx([0.2, 0.2, 0.4], abs=0.003)
    assert extents["wedge"] == pytest.approx([1.0, 1.0, 1.0], abs=0.003)
    assert extents["pair"] == pytest.approx([0.2, 0.2, 0.4], abs=0.003)
    colours = {subject.things[p.owner].id: p.colour for p in soup.patches if p.owner != ROOM}
    assert colours["wedge"][0] > 0.9
    assert max(colours["wedge"][1:]) < 0.1


def test_walls_and_ceiling_of_a_foreign_model_do_not_hide_its_objects(tmp_path: Path) -> None:
    subject = opened(tmp_path, f"<mujoco>{MODEL}<worldbody>{EVERY}</worldbody></mujoco>")
    report = Report(
        valid=False, objects=(failed("ball", "drop", settled=True), failed("can", "drift", settled=True, drift=0.02))
    )
    view, plan = fault_pictures(report, subject, {"ball": 1, "can": 2}, size=SIZE)
    for picture in (view, plan):
        outlines = {o.id: o for o in picture.outlines}
        assert set(outlines) == {"ball", "pill", "egg", "can", "wedge", "pair"}
        assert not [o.id for o in outlines.values() if o.hidden and o.id != "ball"]
    assert Page(page_of(report, subject, title="model", size=SIZE)).all("img")


def test_a_foreign_collision_is_marked_where_it_is(tmp_path: Path) -> None:
    world = crate("a", "0 0 0.1") + crate("b", "0.19 0 0.1")
    subject = opened(tmp_path, f'<mujoco><worldbody><geom type="plane" size="2 2 1"/>{world}</worldbody></mujoco>')
    report = reported(tmp_path, f'<mujoco><worldbody><geom type="plane" size="2 2 1"/>{world}</worldbody></mujoco>')
    assert {v.id for v in report.objects if not v.valid} == {"a", "b"}
    view, plan = fault_pictures(report, subject, {"a": 1, "b": 2}, size=SIZE)
    assert len(marks(plan, "overlap")) == 1
    assert marks(view, "overlap")


@pytest.mark.parametrize("world", ["", '<geom type="plane" size="0 0 1"/>', '<body name="bare" pos="0 0 1"/>'])
def test_next_to_nothing_is_pictured_too(tmp_path: Path, world: str) -> None:
    subject = opened(tmp_path, f"<mujoco><worldbody>{world}{crate('a', '0 0 0.1')}</worldbody></mujoco>")
    assert len(Page(page_of(Report(valid=True), subject, title="x", size=SIZE)).all("img")) == 2


def test_suites_moves_and_findings_are_listed_with_what_fails_first() -> None:
    findings = tuple(Finding(object=f"o{n}", value=float(n), passed=n != 700) for n in range(MOST_FINDINGS + 300))
    criterion = Criterion(
        name="no_drift", says="at most 2 cm", unit="m", limit=0.02, value=0.5, passed=False, findings=findings
    )
    absent = Criterion(
        name="doors", says="open", unit="share", limit=None, value=None, passed=None, note="it has no doors"
    )
    suite = SuiteResult(suite="somebody", source="Somebody, 2026", passed=False, criteria=(criterion, absent))
    where = scene(None, (put(CRATE, 2.0, 2.0), CRATE))
    page = page_for(where, structs.replace(verify(where), suites=(suite,)))
    words = " ".join(page.text.split())
    assert f"{len(findings)} measured, 1 fail, {MOST_FINDINGS} listed" in words
    assert words.index("o700") < words.index("o0 ")
    assert "it has no doors" in words
    assert "Suites failed: somebody" in words
    assert page.all("div", class_="fails")


def test_the_page_is_written_whole_or_not_at_all(faulty: Scene, tmp_path: Path) -> None:
    report, subject = verify(faulty), subject_of(faulty)
    first, second = tmp_path / "first.html", tmp_path / "second.html"
    write_page(report, subject, first, title="room", size=SIZE)
    write_page(report, subject, second, title="room", size=SIZE)
    assert first.read_bytes() == second.read_bytes()
    assert 10_000 < first.stat().st_size < 3_000_000
    assert sorted(p.name for p in tmp_path.iterdir()) == ["first.html", "second.html"]
    with pytest.raises(InputError, match="cannot be written"):
        write_page(report, subject, tmp_path / "no" / "page.html")
    with pytest.raises(InputError, match="cannot be written"):
        write_page(report, subject, tmp_path)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["first.html", "second.html"]


def test_pictures_are_pictures(page: Page) -> None:
    for image in page.all("img"):
        data = base64.b64decode((image["src"] or "").split(",", 1)[1])
        picture = Image.open(io.BytesIO(data))
        picture.load()
        assert picture.size == (int(image["width"] or 0), int(image["height"] or 0))
        assert np.asarray(picture).std() > 5.0
