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
    this.timing = new TimingReader(layout);
    this.state = layout.offset("PluginStatistics", "state");
    this.cycles = layout.offset("PluginStatistics", "cycles");
    this.last = layout.offset("PluginStatistics", "last_busy_ns");
    this.busy = layout.offset("PluginStatistics", "busy");
  }

  /** What stands there now. */
  public HostReading read(Memory memory) {
    int there = Math.clamp(memory.copy(count, Integer.BYTES).getInt(0), 0, threads.count());
    ByteBuffer from = memory.copy(threads.offset(), there * threads.size());
    List<Timing> all = new ArrayList<>();
    for (int i = 0; i < there; i++) {
      all.add(timing.thread(from, i * threads.size()));
    }
    return new HostReading(all, plugins(memory.copy(plugins.offset(), plugins.count() * plugins.size())));
  }

  private Map<Integer, HostReading.Plugin> plugins(ByteBuffer from) {
    Map<Integer, HostReading.Plugin> all = new HashMap<>();
    for (int i = 0; i < plugins.count(); i++) {
      int at = i * plugins.size();
      if (from.getInt(at + state) != 0) {
        all.put(i, new HostReading.Plugin(from.getLong(at + cycles), from.getLong(at + last),
            timing.buckets(from, at + busy)));
      }
    }
    return all;
  }
}
