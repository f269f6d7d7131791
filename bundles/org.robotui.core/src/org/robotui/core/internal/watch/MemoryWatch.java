package org.robotui.core.internal.watch;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.core.internal.watch.Watch.Watched;

/**
 * Looks for a heap that is full even after a collection. Then each thread may fail or stand still at any time, also those that
 * stop a robot: so all robots are stopped while that can still be done. Nobody can say who took the memory.
 */
public final class MemoryWatch implements Watched {
  private static final double FULL = 0.95;

  private final Supplier<List<MemoryUsage>> afterCollection;
  private final Runnable stopAll;
  private final Consumer<String> alert;
  private boolean stopped; // both only on the watch's thread
  private boolean told;

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
    if (usages.stream().noneMatch(MemoryWatch::isFull)) {
      stopped = false;
      told = false;
      return;
    }
    if (!stopped) {
      stopAll.run(); // first of all: saying so needs memory
      stopped = true;
    }
    if (!told) {
      report(usages); // where there is none it throws, and is tried again
      told = true;
    }
  }

  private static boolean isFull(MemoryUsage usage) {
    return usage.getMax() > 0 && usage.getUsed() > FULL * usage.getMax();
  }

  private void report(List<MemoryUsage> usages) {
    long used = usages.stream().filter(MemoryWatch::isFull).mapToLong(MemoryUsage::getUsed).sum();
    long max = usages.stream().filter(MemoryWatch::isFull).mapToLong(MemoryUsage::getMax).sum();
    alert.accept("the memory is used up (" + used / 1_000_000 + " of " + max / 1_000_000
        + " MB): all robots are stopped; close views, or start again with more");
  }
}
