package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import org.robotui.xbot.Board.PluginState;

/**
 * Whether the memory of a host is what a host writes, as {@code damageOf} of the native side judges it: a plugin can
 * write wildly into it, and only there. Not all damage can be seen: a counter may have any value.
 */
final class HostDamage {
  private static final int KIND = 3;
  private static final long LONGEST = Duration.ofDays(1).toNanos();
  private static final long LONGEST_PERIOD = Duration.ofSeconds(1000).toNanos();
  private static final int LAST_STATE = PluginState.values().length - 1;
  /** Stands for threads by deadline, which go before all priorities. */
  private static final int HIGHEST_PRIORITY = 100;
  private static final int MOST_CORES = 8192;
  /** The sum is read before what it sums up, which goes on meanwhile. */
  private static final long MEANWHILE = 1000;
  private static final long SHORT_BUCKETS = 0xffffffffL;

  private final Layout layout;
  private final Layout.Field threads;
  private final Layout.Field plugins;
  private final Layout.Field buckets;

  HostDamage(Layout layout) {
    this.layout = layout;
    this.threads = layout.struct("HostSegment").fields().get("thread_statistics");
    this.plugins = layout.struct("HostSegment").fields().get("plugins");
    this.buckets = layout.struct("Histogram").fields().get("buckets");
  }

  /** What cannot be so, as words such as "its head is overwritten"; none where all can be. */
  Optional<String> of(ByteBuffer host) {
    if (!isHead(host)) {
      return Optional.of("its head is overwritten");
    }
    int count = host.getInt(layout.offset("HostSegment", "threads"));
    if (count < 0 || count > threads.count()) {
      return Optional.of("the number of its threads is overwritten");
    }
    for (int i = 0; i < threads.count(); i++) {
      if (!isThread(host, threads.offset() + i * threads.size())) {
        return Optional.of("what it says of its threads is overwritten");
      }
    }
    for (int i = 0; i < plugins.count(); i++) {
      if (!isPlugin(host, plugins.offset() + i * plugins.size())) {
        return Optional.of("what it says of its plugins is overwritten");
      }
    }
    return Optional.empty();
  }

  private boolean isHead(ByteBuffer host) {
    return host.getInt(layout.offset("HostSegment", "header.magic")) == layout.number("magic")
        && host.getInt(layout.offset("HostSegment", "header.version")) == layout.number("version")
        && host.getInt(layout.offset("HostSegment", "header.segment")) == KIND
        && host.getInt(layout.offset("HostSegment", "header.size")) == layout.size("HostSegment");
  }

  private boolean isThread(ByteBuffer host, int at) {
    String struct = "ThreadStatistics";
    int inside = host.getInt(at + layout.offset(struct, "inside"));
    int core = host.getInt(at + layout.offset(struct, "core"));
    int priority = host.getInt(at + layout.offset(struct, "priority"));
    return isName(host, at + layout.offset(struct, "name"))
        && isWithin(host.getLong(at + layout.offset(struct, "period_ns")), LONGEST_PERIOD)
        && isWithin(priority, HIGHEST_PRIORITY) && core >= -1 && core <= MOST_CORES
        && (inside == layout.number("nobody") || isWithin(inside, plugins.count() - 1L))
        && isHistogram(host, at + layout.offset(struct, "wake_up"))
        && isHistogram(host, at + layout.offset(struct, "busy"));
  }

  private boolean isPlugin(ByteBuffer host, int at) {
    String struct = "PluginStatistics";
    return isWithin(host.getInt(at + layout.offset(struct, "state")), LAST_STATE)
        && isWithin(host.getInt(at + layout.offset(struct, "thread")), threads.count() - 1L)
        && isWithin(host.getLong(at + layout.offset(struct, "last_busy_ns")), LONGEST)
        && isHistogram(host, at + layout.offset(struct, "busy"));
  }

  private boolean isName(ByteBuffer host, int at) {
    int room = layout.size("Name");
    String name = Memory.text(host, at, room);
    return host.get(at + room - 1) == 0 && name.chars().noneMatch(Character::isISOControl);
  }

  private boolean isHistogram(ByteBuffer host, int at) {
    long count = host.getLong(at + layout.offset("Histogram", "count"));
    long sum = 0;
    for (int i = 0; i < buckets.count(); i++) {
      sum += Integer.toUnsignedLong(host.getInt(at + buckets.offset() + i * buckets.size()));
    }
    boolean wrapped = Long.compareUnsigned(count, SHORT_BUCKETS) > 0;
    return isWithin(host.getLong(at + layout.offset("Histogram", "max_ns")), LONGEST)
        && (wrapped || Math.abs(sum - count) <= MEANWHILE);
  }

  private static boolean isWithin(long value, long most) {
    return value >= 0 && value <= most;
  }
}
