"""Edits of generated rooms: do they what was said, leave all else as it was, pass, and how long does it take?

python -m tests.bench.edits [--rooms N] [--fill FILL] [--keep DIR] [--verify-every N] [--out FILE]

The instructions are those of `edit_checks`, with what each room has; what was done is told by geometry of its own.
"""

import argparse
import json
import statistics
import sys
import time
from collections import defaultdict
from pathlib import Path
from typing import get_args

import msgspec

from tests.bench.edit_checks import Case, Plain, cases
from thinkblox import Scene, edit_room, generate_room, load_scene, save_room, verify
from thinkblox.editing import Edit
from thinkblox.editing.edit import Made
from thinkblox.errors import InputError
from thinkblox.fills import Fill
from thinkblox.value import to_json

PROMPTS = Path(__file__).with_name("edit_prompts.txt").read_text(encoding="utf-8").splitlines()


ROOMY = 40
"""How long edits take is told of rooms of so many objects and more."""


def room(number: int, keep: Path | None, fill: Fill) -> tuple[Scene, Made | Path]:
    """A generated room, made anew or as it was kept, and what is edited: that with its report, or its folder."""
    folder = keep / f"room_{number:02d}" if keep is not None else None
    if folder is not None and folder.is_dir():
        return load_scene(folder), folder
    made = generate_room(PROMPTS[number], seed=number, fill=fill)
    if folder is not None:
        save_room(made, folder, pictures=False, formats=())
    return made.scene, folder or made


def alike(before: Plain, after: Plain, case: Case) -> bool:
    """Whether every placement and asset that the instruction does not let change has the same bytes."""
    for id, old in before.placements.items():
        if id in case.may_change:
            continue
        new = after.placements.get(id)
        if new is None or json.dumps(old) != json.dumps(new):
            return False
        if json.dumps(before.assets[old["asset"]]) != json.dumps(after.assets[new["asset"]]):
            return False
    return True


def main() -> int:
    """Edit every room by every instruction and print the shares."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rooms", type=int, default=len(PROMPTS))
    parser.add_argument("--fill", choices=get_args(Fill), default="essentials", help="how full the rooms are")
    parser.add_argument("--keep", type=Path, help="keep the generated rooms here, and take them from here")
    parser.add_argument("--verify-every", type=int, default=6, help="hold every n-th report against a whole verify()")
    parser.add_argument("--out", type=Path, help="write what became of each edit as JSON")
    arguments = parser.parse_args()
    rows: list[dict[str, object]] = []
    for number in range(arguments.rooms):
        scene, source = room(number, arguments.keep, arguments.fill)
        before = Plain(to_json(scene))
        for case in cases(before):
            every = arguments.verify_every
            row = edited(source, before, case, whole=bool(every) and len(rows) % every == 0)
            rows.append({"room": number, "objects": len(scene.placements), **row})
            good = row["done"] and row["alike"] and row["honest"]
            print(f"{number:2d} {'ok ' if good else 'BAD'} {row['cpu']:5.2f} s {case.text}", flush=True)
            if not good:
                print(f"      {row['says']}", flush=True)
    tell(rows)
    if arguments.out is not None:
        arguments.out.write_bytes(msgspec.json.format(msgspec.json.encode(rows)))
    return 0


def edited(source: Made | Path, before: Plain, case: Case, *, whole: bool) -> dict[str, object]:
    """What became of one edit."""
    start, cpu = time.perf_counter(), time.process_time()
    result: Edit | None
    try:
        result, says = edit_room(source, case.text), ""
    except InputError as error:
        result, says = None, str(error)
    took = {"seconds": round(time.perf_counter() - start, 3), "cpu": round(time.process_time() - cpu, 3)}
    row: dict[str, object] = {"kind": case.kind, "text": case.text, **took}
    if result is None:
        return {**row, "done": False, "alike": True, "honest": True, "says": says}
    after = Plain(to_json(result.scene))
    valid = verify(result.scene).valid if whole else result.report.valid
    honest = valid == result.report.valid and (valid or any(not v.valid for v in result.report.objects))
    done = not result.failed and case.check(before, after)
    says = "; ".join((*result.failed, *result.done, *(str(v) for v in result.report.objects if not v.valid)))
    return {**row, "done": done, "alike": alike(before, after, case), "honest": honest, "valid": valid, "says": says}


def tell(rows: list[dict[str, object]]) -> None:
    """Print the shares, of all and by kind."""
    kinds: dict[str, list[dict[str, object]]] = defaultdict(list)
    for row in rows:
        kinds[str(row["kind"])].append(row)
    print(f"{'kind':9} edits  done  alike  honest  median CPU s  median s")
    for kind, some in (*kinds.items(), ("all", rows)):
        shares = [sum(bool(row[key]) for row in some) / len(some) for key in ("done", "alike", "honest")]
        cpu, seconds = (statistics.median(float(str(row[key])) for row in some) for key in ("cpu", "seconds"))
        done, same, honest = shares
        print(f"{kind:9} {len(some):5} {done:5.0%} {same:6.0%} {honest:7.0%} {cpu:13.2f} {seconds:9.2f}")
    roomy = [float(str(row["cpu"])) for row in rows if int(str(row["objects"])) >= ROOMY]
    if roomy:
        middle, worst = statistics.median(roomy), max(roomy)
        under = f"{sum(cpu < 1.0 for cpu in roomy)} of {len(roomy)} under 1 s"
        print(f"{ROOMY} objects and more: median {middle:.2f} CPU s, worst {worst:.2f}, {under}")


if __name__ == "__main__":
    sys.exit(main())
