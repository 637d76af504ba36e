"""Some of several: "two armchairs, one by the window and the other by the door", "two chairs here and one there"."""

from dataclasses import replace

from thinkblox.reading.attach import FLANKS
from thinkblox.reading.draft import Mention
from thinkblox.reading.lists import Lists
from thinkblox.reading.memory import Waiting
from thinkblox.reading.phrases import Connective, Phrase


class Parts(Lists):
    """Reads "one", "two" and "the other" where they stand for things named before."""

    def _ones(self, phrase: Phrase) -> bool:
        """Read a number that something is said of; whether it was one."""
        following = self.next_item()
        whole = self._whole_of_parts()
        if whole is None or not phrase.count or not isinstance(following, Connective):
            return False
        if following.kind not in ("relation", "adverb", "having") or following.value == "for":
            return False
        if following.value in FLANKS and not self._is_placed(whole):
            whole.count = 2 * phrase.count
            self.items[self.at + 1] = Connective(following.kind, FLANKS[0])
            self.mention(whole)
        elif self._is_placed(whole) and whole is not self.parted:
            self._take(self._copy(whole, phrase.count))
        else:
            self._set_apart(whole, phrase.count)
        return True

    def _other(self, phrase: Phrase) -> None:
        """Read "the other": what is left of several, or one more of what was just mentioned."""
        following = self.next_item()
        said = isinstance(following, Connective) and following.kind in ("relation", "adverb", "having")
        whole = self.parted or self.current
        if whole is None or not said:
            return
        if whole is self.parted:
            self.parted = None
            self.mention(whole)
        else:
            self._take(self._copy(whole, 1))

    def _one_of(self, waiting: Waiting, phrase: Phrase) -> None:
        """Read "a printer on one and a plant on the other": each goes to one of several, not to all of them."""
        subject = waiting.subject
        self.draft.bonds = [b for b in self.draft.bonds if b.subject is not subject or not b.implied]
        kind, anchors = self.resolve(phrase, waiting)
        whole = self.parted or next((a for a in anchors if isinstance(a, Mention)), None)
        if whole is None:
            return
        if phrase.kind == "number" and whole.many:
            self._set_apart(whole, 1)
        else:
            self.parted = None
            self.mention(whole)
        if self.current is not None:
            self.attach(kind, (self.current,), subject=subject, pronoun=True)

    def _parted_by_looks(self, phrase: Phrase) -> bool:
        """Read "one red and three blue"; whether there is something it can be about."""
        whole = self._whole_of_parts()
        if whole is None or not phrase.count:
            return False
        self._set_apart(whole, phrase.count)
        if self.current is not None:
            self.current.attributes += phrase.attributes
        return True

    def _whole_of_parts(self) -> Mention | None:
        """The several things that a number now parts."""
        recent = [self.current, *reversed(self.run), *reversed(self.references.mentions[-3:])]
        return self.parted or next((t for t in recent if t is not None and t.many and t in self.draft.things), None)

    def _is_placed(self, thing: Mention) -> bool:
        return any(not bond.implied for bond in self.draft.bonds_of(thing))

    def _set_apart(self, whole: Mention, count: int) -> None:
        """Set so many of `whole` apart; the last of them stay `whole` itself."""
        left = (whole.count or 2 * count) - count
        if left <= 0:
            self.parted = None
            self.mention(whole)
            return
        self.parted, whole.count = whole, left
        part = self._copy(whole, count)
        self.draft.bonds += [replace(bond, subject=part) for bond in self.draft.bonds_of(whole)]
        self._take(part)

    def _copy(self, thing: Mention, count: int) -> Mention:
        return replace(thing, count=count, plural=False, attributes=[*thing.attributes])

    def _take(self, thing: Mention) -> None:
        self.draft.things.append(thing)
        self.run.append(thing)
        self.mention(thing)
