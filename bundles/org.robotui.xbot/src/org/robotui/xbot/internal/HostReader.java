package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.xbot.HostReading;
import org.robotui.xbot.Timing;

/** Reads what a process of plugins writes. It may have written anything, since a plugin may have. */
public final class HostReader {
  private final Layout.Field threads;
  private final Layout.Field plugins;
  private final int count;
  private final int size;
  private final HostDamage damage;
  private final TimingReader timing;
  private final int state;
  private final int cycles;
  private final int last;
  private final int busy;

  /** A reader of hosts of this layout. */
  public HostReader(Layout layout) {
    Map<String, Layout.Field> fields = layout.struct("HostSegment").fields();
    this.threads = fields.get("thread_statistics");
    this.plugins = fields.get("plugins");
    this.count = layout.offset("HostSegment", "threads");
    this.size = layout.size("HostSegment");
    this.damage = new HostDamage(layout);
    this.timing = new TimingReader(layout);
    this.state = layout.offset("PluginStatistics", "state");
    this.cycles = layout.offset("PluginStatistics", "cycles");
    this.last = layout.offset("PluginStatistics", "last_busy_ns");
    this.busy = layout.offset("PluginStatistics", "busy");
  }

  /** What stands there now; of what is damaged only that it is. */
  public HostReading read(Memory memory) {
    ByteBuffer from = memory.copy(0, size);
    return damage.of(from).map(what -> new HostReading(List.of(), Map.of(), what)).orElseGet(() -> reading(from));
  }

  private HostReading reading(ByteBuffer from) {
    List<Timing> all = new ArrayList<>();
    for (int i = 0; i < from.getInt(count); i++) {
      all.add(timing.thread(from, threads.offset() + i * threads.size()));
    }
    return new HostReading(all, plugins(from), "");
  }

  private Map<Integer, HostReading.Plugin> plugins(ByteBuffer from) {
    Map<Integer, HostReading.Plugin> all = new HashMap<>();
    for (int i = 0; i < plugins.count(); i++) {
      int at = plugins.offset() + i * plugins.size();
      if (from.getInt(at + state) != 0) {
        all.put(i, new HostReading.Plugin(from.getLong(at + cycles), from.getLong(at + last),
            timing.buckets(from, at + busy)));
      }
    }
    return all;
  }
}
