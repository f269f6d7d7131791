package org.robotui.core.internal.facts;

import java.lang.management.BufferPoolMXBean;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryUsage;
import java.lang.management.RuntimeMXBean;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;

/** The virtual machine of this process: which it is, how it was started, and what its memory is used for. */
final class JavaFacts {
  private static final int MEGA = 20;

  private JavaFacts() {}

  static List<String> lines() {
    RuntimeMXBean runtime = ManagementFactory.getRuntimeMXBean();
    List<String> lines = new ArrayList<>();
    lines.add("Java " + System.getProperty("java.version") + " of " + System.getProperty("java.vendor") + " in "
        + System.getProperty("java.home"));
    lines.add(runtime.getVmName() + " " + runtime.getVmVersion());
    lines.add("started " + Instant.ofEpochMilli(runtime.getStartTime()) + ", runs for " + runtime.getUptime() / 1000
        + " s, on " + Runtime.getRuntime().availableProcessors() + " processors");
    runtime.getInputArguments().forEach(argument -> lines.add("argument " + argument));
    return lines;
  }

  static List<String> memory() {
    List<String> lines = new ArrayList<>();
    lines.add("heap: " + words(ManagementFactory.getMemoryMXBean().getHeapMemoryUsage()));
    lines.add("beside the heap: " + words(ManagementFactory.getMemoryMXBean().getNonHeapMemoryUsage()));
    for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
      lines.add("  " + pool.getName() + ": " + words(pool.getUsage()));
    }
    for (BufferPoolMXBean pool : ManagementFactory.getPlatformMXBeans(BufferPoolMXBean.class)) {
      lines.add("buffers, " + pool.getName() + ": " + pool.getCount() + " with " + mega(pool.getMemoryUsed()));
    }
    for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
      lines.add(collector.getName() + ": " + collector.getCollectionCount() + " times, "
          + collector.getCollectionTime() + " ms");
    }
    lines.add(ManagementFactory.getClassLoadingMXBean().getLoadedClassCount() + " classes are loaded");
    return lines;
  }

  private static String words(MemoryUsage usage) {
    return mega(usage.getUsed()) + " used of " + mega(usage.getCommitted())
        + (usage.getMax() < 0 ? "" : ", at most " + mega(usage.getMax()));
  }

  private static String mega(long bytes) {
    return (bytes >> MEGA) + " MB";
  }
}
