package org.robotui.xbot;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.xbot.internal.CycleMemory;

/**
 * Reads every cycle of a control, one after the other; the control does not know of it. The memory holds the last 1024,
 * a second at 1 kHz. Who reads less often misses some, which are counted. For one thread; never waits.
 */
public final class CycleReader {
  private final Supplier<? extends CycleMemory> memory;
  private long last;
  private long lost;

  CycleReader(Supplier<? extends CycleMemory> memory) {
    this.memory = memory;
  }

  /**
   * The cycle after the one read last, or the oldest that there is where that was written over. The first one is the
   * newest there is; where the process at the hardware was replaced, its cycles follow from its first.
   *
   * @return none where there is no new one yet
   */
  public Optional<StateFrame> next() {
    CycleMemory now = memory.get();
    long newest = now.newestCycle();
    if (newest == 0 || newest == last) {
      return Optional.empty();
    }
    boolean anew = newest < last;
    long cycle = last == 0 ? newest : Math.max(anew ? 1 : last + 1, now.oldestCycle(newest));
    Optional<StateFrame> found = now.state(cycle);
    if (found.isPresent()) {
      lost += last == 0 || anew ? 0 : cycle - last - 1;
      last = cycle;
    }
    return found;
  }

  /**
   * How many cycles were missed since the first one that was read.
   *
   * @return their number
   */
  public long lost() {
    return lost;
  }
}
