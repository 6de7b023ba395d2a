"""The parts of a campaign: which are there, and which are missing. sil/studies/campaign/campaign_part.hpp writes them."""

import re
import tomllib
import typing

from campaign_error import CampaignError

HEAD = re.compile(rb"# part of a campaign by rsi-sil: first (\d+), count (\d+), fingerprint (\S+)$")
LONGEST_HEAD = 200


class Part(typing.NamedTuple):
    first: int
    count: int

    def file_name(self):
        return f"part-{self.first:09}-{self.count:07}.csv"


def head_of(path):
    """The part and its fingerprint; None for a file that is no part."""
    with path.open("rb") as file:
        found = HEAD.match(file.read(LONGEST_HEAD).split(b"\n")[0])
    return found and (Part(int(found[1]), int(found[2])), found[3].decode())


def described(folder):
    """Content of campaign.toml."""
    with (folder / "campaign.toml").open("rb") as file:
        return tomllib.load(file)


def files_of(folder):
    """The files of the parts in a folder, with the parts, in their order."""
    heads = ((path, head_of(path)) for path in folder.glob("*.csv"))
    return sorted(((path, *head) for path, head in heads if head), key=lambda found: found[1])


def there(folder):
    """The parts in a folder, in their order. Raises CampaignError for one of another campaign than campaign.toml's."""
    wanted = described(folder)["made_with"]["parts"]
    for path, _, fingerprint in files_of(folder):
        if fingerprint != wanted:
            raise CampaignError(f"{path} is of another campaign than campaign.toml beside it: {fingerprint}, not {wanted}; move "
                                "it to another folder, or remove it")
    return [part for _, part, _ in files_of(folder)]


def missing(parts, runs, part_runs):
    """Runs that are in none of `parts`, in pieces of at most `part_runs`. Cuts are at multiples of it, so that a later call with the
    same number names the same files."""
    pieces, begin = [], 0
    for part in [*parts, Part(runs, 0)]:
        while begin < part.first:
            end = min(part.first, (begin // part_runs + 1) * part_runs)
            pieces.append(Part(begin, end - begin))
            begin = end
        begin = max(begin, part.first + part.count)
    return pieces
