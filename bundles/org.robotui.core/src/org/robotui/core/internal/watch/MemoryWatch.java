package org.robotui.core.internal.watch;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.core.internal.fence.HeapBound;
import org.robotui.core.internal.watch.Watch.Watched;

/**
 * Looks how full the heap is even after a collection. Where it soon will not be enough, that is said. Where it is full,
 * each thread may fail or stand still at any time, also those that stop a robot: so all robots are stopped while that
 * can still be done. Where all is taken to the last byte between two looks, that is tried, but not promised. Nobody can
 * say who took the memory.
 */
public final class MemoryWatch implements Watched {
  private static final double FULL = 0.95;
  private static final double NEARLY_FULL = 0.8;
  /**
   * Below this there is room again. Between the two nothing is said: what wavers around one bound would be said for
   * ever.
   */
  private static final double ROOMY = 0.7;

  private final Supplier<List<MemoryUsage>> afterCollection;
  private final Runnable stopAll;
  private final Consumer<String> alert;
  private boolean stopped; // both only on the watch's thread
  private boolean told;
  private boolean warned;

  /**
   * A watch.
   *
   * @param afterCollection how full the parts of the heap were after their last collection
   * @param stopAll stops all robots
   * @param alert is told a sentence
   */
  public MemoryWatch(Supplier<List<MemoryUsage>> afterCollection, Runnable stopAll, Consumer<String> alert) {
    this.afterCollection = afterCollection;
    this.stopAll = stopAll;
    this.alert = alert;
    usedUp(afterCollection.get()); // linked now, as there is no memory for that when it is said
  }

  /** The old part of this machine's heap. */
  public static Supplier<List<MemoryUsage>> heap() {
    List<MemoryPoolMXBean> pools = ManagementFactory.getMemoryPoolMXBeans().stream()
        .filter(p -> p.getType() == MemoryType.HEAP && p.isUsageThresholdSupported()).toList();
    return () -> pools.stream().map(MemoryPoolMXBean::getCollectionUsage).toList();
  }

  @Override
  public void check(long now) {
    List<MemoryUsage> usages = afterCollection.get();
    if (holdsMoreThan(FULL, usages)) {
      stop(usages);
      return;
    }
    stopped = false;
    told = false;
    if (!holdsMoreThan(ROOMY, usages)) {
      warned = false;
    } else if (!warned && holdsMoreThan(NEARLY_FULL, usages)) {
      alert.accept("RobotUI holds " + share(NEARLY_FULL, usages)
          + " MB of memory, and stops all robots when they are used up: " + remedy());
      warned = true;
    }
  }

  private void stop(List<MemoryUsage> usages) {
    if (!stopped) {
      stopAll.run(); // first of all: saying so needs memory
      stopped = true;
    }
    if (!told) {
      // Where there is none it throws, and is tried again.
      alert.accept(usedUp(usages));
      told = true;
      warned = true;
    }
  }

  private static String usedUp(List<MemoryUsage> usages) {
    return "the memory is used up (" + share(FULL, usages) + " MB): all robots are stopped; " + remedy();
  }

  private static boolean holdsMoreThan(double share, List<MemoryUsage> usages) {
    return usages.stream().anyMatch(usage -> isAbove(share, usage));
  }

  private static boolean isAbove(double share, MemoryUsage usage) {
    return usage.getMax() > 0 && usage.getUsed() > share * usage.getMax();
  }

  /** How much of how much. */
  private static String share(double least, List<MemoryUsage> usages) {
    List<MemoryUsage> meant = usages.stream().filter(usage -> isAbove(least, usage)).toList();
    long used = meant.stream().mapToLong(MemoryUsage::getUsed).sum();
    long max = meant.stream().mapToLong(MemoryUsage::getMax).sum();
    return HeapBound.megabytes(used) + " of " + HeapBound.megabytes(max);
  }

  private static String remedy() {
    return "close views or robots, or start it with more, as by " + HeapBound.remedy(HeapBound.bytes());
  }
}
