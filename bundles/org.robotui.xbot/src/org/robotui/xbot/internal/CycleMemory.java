package org.robotui.xbot.internal;

import java.util.Optional;
import org.robotui.xbot.StateFrame;

/** Where the last cycles of a control lie. */
public interface CycleMemory {
  /** The number of the newest cycle, 0 before the first. */
  long newestCycle();

  /** The oldest cycle that can be read while this is the newest one. */
  long oldestCycle(long newest);

  /** The state of a cycle; none where it was written over. */
  Optional<StateFrame> state(long cycle);
}
