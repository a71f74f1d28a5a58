"""Whether a folder is the user's own and nobody else's to write: what is unpickled from it runs as that user.

On POSIX every step of the way to it counts, symbolic links included: who may write a folder may swap what is
in it. Each step belongs to the user or to root, and nobody else may write it; a sticky folder like ``/tmp``
lets everybody add to it, but only an owner replace what is there. An access list shows in the group's bits. A
group that has the user's name and no other members is nobody else. Root trusts root alone.

On Windows the mode says nothing; there the profile of the user, which Windows opens to no other user, is the
user's own, and every other folder is not.
"""

import os
import stat
import sys
from collections import deque
from collections.abc import Iterator
from pathlib import Path

_MOST_LINKS = 40

if sys.platform == "win32":

    def owned(folder: Path) -> bool:
        """Whether only this user can have put there what lies in ``folder``."""
        try:
            return folder.resolve(strict=True).is_relative_to(Path.home().resolve())
        except (OSError, RuntimeError):
            return False

    def sealed(folder: Path) -> bool:
        """Whether a folder within an owned one lets nobody else in, and holds nothing of anybody else."""
        return folder.is_dir()

else:
    import grp
    import pwd

    def owned(folder: Path) -> bool:
        """Whether only this user can have put there what lies in ``folder``."""
        try:
            *above, last = _way(folder.absolute())
        except OSError:
            return False
        return (
            stat.S_ISDIR(last.st_mode)
            and last.st_uid == os.geteuid()
            and not _others_write(last)
            and all(_holds(step) for step in above)
        )

    def sealed(folder: Path) -> bool:
        """Whether a folder within an owned one lets nobody else in, and holds nothing of anybody else."""
        try:
            status = folder.lstat()
        except OSError:
            return False
        closed = stat.S_ISDIR(status.st_mode) and not status.st_mode & (stat.S_IRWXG | stat.S_IRWXO)
        return closed and status.st_uid == os.geteuid() and all(map(_ours, _within(folder)))

    def _within(folder: Path) -> Iterator[Path]:
        for each, folders, files in os.walk(folder):
            yield from (Path(each, name) for name in (*folders, *files))

    def _ours(path: Path) -> bool:
        """Whether it is the user's, and no link; what is gone meanwhile will not be read."""
        try:
            status = path.lstat()
        except FileNotFoundError:
            return True
        return status.st_uid == os.geteuid() and not stat.S_ISLNK(status.st_mode)

    def _way(path: Path) -> Iterator[os.stat_result]:
        """The status of each folder and link that is passed on the way to a path, its own last."""
        here, links = Path(path.anchor), 0
        yield here.lstat()
        ahead = deque(path.parts[1:])
        while ahead:
            step = here / ahead.popleft()
            if step.name == "..":
                here = here.parent
                yield here.lstat()
                continue
            status = step.lstat()
            yield status
            if not stat.S_ISLNK(status.st_mode):
                here = step
                continue
            links += 1
            if links > _MOST_LINKS:
                raise OSError(f"{path}: too many links")
            target = step.readlink()
            if target.is_absolute():
                here = Path(target.anchor)
            ahead.extendleft(reversed(target.parts[target.is_absolute() :]))

    def _holds(step: os.stat_result) -> bool:
        """Whether nobody else can swap this step, or what lies in it."""
        if step.st_uid not in (os.geteuid(), 0):
            return False
        closed = stat.S_ISLNK(step.st_mode) or step.st_mode & stat.S_ISVTX
        return bool(closed) or not _others_write(step)

    def _others_write(status: os.stat_result) -> bool:
        if status.st_mode & stat.S_IWOTH:
            return True
        return bool(status.st_mode & stat.S_IWGRP) and not _of_user_alone(status.st_gid)

    def _of_user_alone(group: int) -> bool:
        try:
            named, user = grp.getgrgid(group), pwd.getpwuid(os.geteuid())
        except KeyError:
            return False
        alone = set(named.gr_mem) <= {user.pw_name}
        return user.pw_uid != 0 and group == user.pw_gid and named.gr_name == user.pw_name and alone
