"""All that is measured goes before other programs, each alike: what else the machine does is no property of what is measured."""
import os
import pathlib

NICE = -15


def prefer(processes):
    """Whether this user may, for processes that lead groups and sessions. Linux weighs whole sessions (autogroups) against each other or, without those, processes."""
    try:
        for process in processes:
            os.setpriority(os.PRIO_PGRP, process.pid, NICE)
            group = pathlib.Path(f"/proc/{process.pid}/autogroup")
            if group.exists():
                group.write_text(str(NICE))
    except OSError:
        return False
    return True
