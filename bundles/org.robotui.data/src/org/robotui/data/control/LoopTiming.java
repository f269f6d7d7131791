package org.robotui.data.control;

import java.util.List;
import org.robotui.data.Data;

/**
 * How well the periodic threads of a robot's control keep their time, since they began.
 *
 * @param realTime false where the control runs without real-time rights, so that no time is guaranteed
 * @param loops the one that speaks to the hardware first
 */
public record LoopTiming(boolean realTime, List<Loop> loops) implements Data {
  /**
   * One thread.
   *
   * @param name of the thread
   * @param process the process it lives in
   * @param schedule when it runs
   * @param counts what it did
   * @param wakeUp how late it woke
   * @param busy how long one cycle took
   */
  public record Loop(String name, String process, Schedule schedule, Counts counts, Histogram wakeUp, Histogram busy) {}

  /**
   * When a thread runs.
   *
   * @param period nanoseconds
   * @param priority of the real-time scheduler; 0 is not real time, 100 is by deadline in place of a priority
   * @param core the processor it is bound to; -1 is any
   */
  public record Schedule(long period, int priority, int core) {}

  /**
   * What a thread did.
   *
   * @param cycles how often it ran
   * @param overruns how often it was not ready before its next cycle
   * @param missed commands that did not come in time; only the loop at the hardware knows
   * @param allocations of memory in its cycles, where that is counted
   * @param pageFaults in its cycles
   */
  public record Counts(long cycles, long overruns, long missed, long allocations, long pageFaults) {}

  /**
   * Copies the list.
   *
   * @param realTime whether time is guaranteed
   * @param loops the threads
   */
  public LoopTiming {
    loops = List.copyOf(loops);
  }
}
