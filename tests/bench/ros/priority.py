"""All that is measured goes before other programs, each alike: what else the machine does is no property of a subscriber."""
import os
import pathlib

NICE = -15


def prefer(programs):
    """Whether this user may. Linux weighs whole sessions (autogroups) against each other or, without those, processes."""
    try:
        for program in programs:
            os.setpriority(os.PRIO_PGRP, program.process.pid, NICE)
            group = pathlib.Path(f"/proc/{program.process.pid}/autogroup")
            if group.exists():
                group.write_text(str(NICE))
    except OSError:
        return False
    return True
