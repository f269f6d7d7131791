package org.robotui.xbot;

import java.util.List;

/**
 * How well a periodic thread keeps its time, since it began. Times are nanoseconds.
 *
 * @param name of the thread
 * @param period between two cycles
 * @param priority of SCHED_FIFO, 0 is not real time, 100 is SCHED_DEADLINE
 * @param core the processor it is bound to, -1 is any
 * @param cycles how often it ran
 * @param overruns points in time at which it could not begin, since the cycle before was not done
 * @param missed commands that did not come in time; 0 for threads that command
 * @param allocations of memory in its cycles, where the counter is built in
 * @param pageFaults in its cycles
 * @param wakeUp how late it woke
 * @param busy how long a cycle took
 */
public record Timing(
    String name,
    long period,
    int priority,
    int core,
    long cycles,
    long overruns,
    long missed,
    long allocations,
    long pageFaults,
    Buckets wakeUp,
    Buckets busy) {
  /**
   * How often durations occurred; {@link #lower} says where a bucket begins.
   *
   * @param counts by bucket
   * @param max the longest
   */
  public record Buckets(List<Long> counts, long max) {
    private static final int PER_OCTAVE = 4;
    private static final int FIRST_SHIFT = 4;

    /**
     * Copies the list.
     *
     * @param counts by bucket
     * @param max the longest
     */
    public Buckets {
      counts = List.copyOf(counts);
    }

    /**
     * Where a bucket begins; it ends where the next begins.
     *
     * @param bucket from 0; the first has all that is shorter, too
     * @return nanoseconds
     */
    public static long lower(int bucket) {
      return (PER_OCTAVE + (long) (bucket % PER_OCTAVE)) << (FIRST_SHIFT + bucket / PER_OCTAVE);
    }
  }
}
