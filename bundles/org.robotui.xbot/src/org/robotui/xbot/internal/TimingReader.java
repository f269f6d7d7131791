package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.robotui.xbot.Timing;
import org.robotui.xbot.Timing.Buckets;

/**
 * Reads how threads keep their time. Counters are read one by one while they run: one may be a cycle behind another.
 */
final class TimingReader {
  private final Layout layout;
  private final Layout.Field buckets;
  private final int longest;

  TimingReader(Layout layout) {
    this.layout = layout;
    this.buckets = layout.struct("Histogram").fields().get("buckets");
    this.longest = layout.offset("Histogram", "max_ns");
  }

  Buckets buckets(ByteBuffer from, int at) {
    List<Long> counts = new ArrayList<>(buckets.count());
    for (int i = 0; i < buckets.count(); i++) {
      counts.add(Integer.toUnsignedLong(from.getInt(at + buckets.offset() + i * buckets.size())));
    }
    return new Buckets(counts, from.getLong(at + longest));
  }

  /** The loop at the hardware. */
  Timing loop(ByteBuffer from) {
    return new Timing("HAL", number(from, 0, "LoopStatistics", "period_ns"),
        from.getInt(layout.offset("LoopStatistics", "priority")),
        from.getInt(layout.offset("LoopStatistics", "core")),
        number(from, 0, "LoopStatistics", "cycles"),
        number(from, 0, "LoopStatistics", "overruns"),
        number(from, 0, "LoopStatistics", "missed_commands"),
        number(from, 0, "LoopStatistics", "allocations"),
        number(from, 0, "LoopStatistics", "page_faults"),
        buckets(from, layout.offset("LoopStatistics", "wake_up")),
        buckets(from, layout.offset("LoopStatistics", "busy")));
  }

  Timing thread(ByteBuffer from, int at) {
    String struct = "ThreadStatistics";
    return new Timing(
        Memory.text(from, at + layout.offset(struct, "name"), layout.size("Name")),
        number(from, at, struct, "period_ns"),
        from.getInt(at + layout.offset(struct, "priority")),
        from.getInt(at + layout.offset(struct, "core")),
        number(from, at, struct, "cycles"),
        number(from, at, struct, "overruns"),
        0,
        number(from, at, struct, "allocations"),
        number(from, at, struct, "page_faults"),
        buckets(from, at + layout.offset(struct, "wake_up")),
        buckets(from, at + layout.offset(struct, "busy")));
  }

  private long number(ByteBuffer from, int at, String struct, String field) {
    return from.getLong(at + layout.offset(struct, field));
  }
}
