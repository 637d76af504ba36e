"""Relations that must not hold: what has them in the brief is placed after what it is to keep away from."""

from collections.abc import Iterable

from thinkblox.brief import Relation
from thinkblox.plan import Tie
from thinkblox.planning.members import Member, Members


def deny(relations: Iterable[Relation], members: Members) -> None:
    """Give every object of a negated relation the ties that it must not have."""
    for relation in relations:
        keys = [anchor for anchor in relation.anchors if anchor in members.by_request]
        others = [member for key in keys for member in members.by_request[key]]
        for subject in members.by_request.get(relation.subject, []):
            ids = tuple(other.id for other in others if other is not subject)
            anchors = ids if keys else relation.anchors
            if anchors or not relation.anchors:
                subject.denied.append(Tie(kind=relation.kind, anchors=anchors, rows=relation.rows, asked=True))
            _wait(members, subject, [other for other in others if other is not subject])


def _wait(members: Members, subject: Member, others: Iterable[Member]) -> None:
    for other in others:
        if not members.depends(other, subject):
            subject.waits.add(other.id)
