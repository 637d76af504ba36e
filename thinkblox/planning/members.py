"""The objects of a brief one by one, and what they are like."""

from dataclasses import dataclass, field
from functools import cached_property

from thinkblox.assets import kind_of
from thinkblox.assets.mounting import mount_of
from thinkblox.brief import Brief, Request
from thinkblox.plan import Due, Tie, carries


@dataclass(eq=False)
class Member:
    """One object to be: the `index`-th of its request. Ties are collected here before they become a Target.

    Attributes:
        denied: relations that it must not have.
        waits: ids of what is placed before it besides what its ties name.
    """

    id: str
    request: Request
    index: int
    ties: list[Tie] = field(default_factory=list)
    denied: list[Tie] = field(default_factory=list)
    waits: set[str] = field(default_factory=set)

    @property
    def category(self) -> str:
        """Its category."""
        return self.request.category

    @cached_property
    def mount(self) -> str:
        """What it is placed on."""
        return mount_of(kind_of(self.category), self.request.attributes)

    @cached_property
    def footprint(self) -> float:
        """Area it usually covers [m2]."""
        size = kind_of(self.category).size
        return size[0] * size[1]

    @cached_property
    def flat(self) -> bool:
        """Whether it is walked on."""
        return kind_of(self.category).flat


class Members:
    """All objects of a brief, by request and by id.

    Attributes:
        room: the type of room that they are for.
        due: relations that were asked for and that other ties serve, as one of the two is placed by another thing.
    """

    def __init__(self, brief: Brief) -> None:
        numbers: dict[str, int] = {}
        self.room = brief.room_type
        self.by_request: dict[str, list[Member]] = {}
        self.by_id: dict[str, Member] = {}
        self.due: list[Due] = []
        for request in brief.requests:
            for index in range(request.count):
                numbers[request.category] = numbers.get(request.category, 0) + 1
                member = Member(f"{request.category}_{numbers[request.category]}", request, index)
                self.by_request.setdefault(request.key, []).append(member)
                self.by_id[member.id] = member

    @property
    def all(self) -> list[Member]:
        """Every object, in the order of the prompt."""
        return list(self.by_id.values())

    def of_category(self, category: str) -> list[Member]:
        """The objects of a category."""
        return [member for member in self.by_id.values() if member.category == category]

    def support(self, member: Member) -> "Member | None":
        """What it stands on, if that is another object."""
        on = next((tie for tie in member.ties if carries(tie)), None)
        return self.by_id.get(on.anchors[0]) if on else None

    def owe(self, subject: Member, tie: Tie) -> None:
        """Remember that a relation is to be measured between the very things that it was asked for of."""
        due = Due(subject=subject.id, tie=tie)
        if tie.asked and due not in self.due:
            self.due.append(due)

    def depends(self, member: Member, other: Member) -> bool:
        """Whether `member` has to wait for `other`, be it through others."""
        seen, queue = {member.id}, [member]
        while queue:
            current = queue.pop()
            if current is other:
                return True
            for anchor in ({a for tie in current.ties for a in tie.anchors} | current.waits) - seen:
                if anchor in self.by_id:
                    seen.add(anchor)
                    queue.append(self.by_id[anchor])
        return False
