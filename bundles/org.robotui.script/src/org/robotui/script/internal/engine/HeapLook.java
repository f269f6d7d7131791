package org.robotui.script.internal.engine;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.List;

/**
 * Whether the memory is used up by what is still needed: as it was after the last collection, so that garbage is none.
 */
class HeapLook {
  private static final double FULL = 0.9;

  private final List<MemoryPoolMXBean> pools = ManagementFactory.getMemoryPoolMXBeans().stream()
      .filter(pool -> pool.getType() == MemoryType.HEAP && pool.isUsageThresholdSupported()).toList();

  boolean isFull() {
    return pools.stream().anyMatch(HeapLook::isFull);
  }

  private static boolean isFull(MemoryPoolMXBean pool) {
    return pool.getCollectionUsage() instanceof MemoryUsage kept && kept.getMax() > 0
        && kept.getUsed() > FULL * kept.getMax();
  }
}
