package org.robotui.uic.plugins.internal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.robotui.api.port.SourceId;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.ControlPlugins.Plugin;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.data.control.Drives.Drive;
import org.robotui.data.control.Drives.Phase;
import org.robotui.data.control.Drives;
import org.robotui.data.control.Histogram;
import org.robotui.data.control.LoopTiming;
import org.robotui.data.control.LoopTiming.Counts;
import org.robotui.data.control.LoopTiming.Loop;
import org.robotui.data.control.LoopTiming.Schedule;
import org.robotui.testkit.FakeUicContext;

/** Controls for tests and for people to look at. */
public final class Controls {
  public static final SourceId PLUGINS = new SourceId("base", "plugins");
  public static final SourceId TIMING = new SourceId("base", "timing");
  public static final SourceId DRIVES = new SourceId("base", "drives");
  public static final SourceId VERBS = new SourceId("base", "plugin_verbs");
  public static final long MILLI = 1_000_000;

  private static final String OVER_VOLTAGE = "0x3210 (DC link over-voltage)";
  private static final int BUCKETS = 96;
  private static final List<Long> LOWER =
      IntStream.range(0, BUCKETS).mapToObj(i -> i == 0 ? 0L : Math.round(100 * Math.pow(2, i / 4.0))).toList();
  private static final String ERROR = """
      the library libcartesian.so could not be loaded
      /opt/plugins/libcartesian.so: undefined symbol: _ZN7robotui2rt5Model6updateEv
      it was built against version 3 of the plugin interface, this host has version 4
      remedy: build it again with this version's headers, then reload""";

  private Controls() {}

  /** Durations around one, with a long tail to another, as a real loop has them. */
  public static Histogram durations(long count, double typical, double longest) {
    double middle = Math.log(typical);
    double[] weights =
        LOWER.stream().mapToDouble(l -> Math.exp(-Math.pow((Math.log(Math.max(50, l)) - middle) / 0.35, 2))
            + (l > typical && l < longest ? 2e-4 / (1 + 4 * Math.log(l / typical)) : 0)).toArray();
    double all = Arrays.stream(weights).sum();
    List<Long> counts =
        new ArrayList<>(IntStream.range(0, BUCKETS).mapToObj(i -> Math.round(count * weights[i] / all)).toList());
    int last = (int) LOWER.stream().filter(l -> l <= longest).count() - 1;
    counts.set(last, counts.get(last) + 1);
    return new Histogram(counts, LOWER, (long) longest);
  }

  /** Nothing was measured. */
  public static Histogram nothing() {
    return new Histogram(LongStream.range(0, BUCKETS).mapToObj(i -> 0L).toList(), LOWER, 0);
  }

  public static Plugin plugin(String name, String process, String thread, State state, String status, String error,
      Histogram busy) {
    return new Plugin(name, "lib" + name + ".so", process, thread, state, status, error, state == State.FAILED ? 3 : 0,
        MILLI, busy.count(), busy);
  }

  /** An arm's control at 1 kHz: one host with two threads. */
  public static ControlPlugins arm() {
    return new ControlPlugins(List.of(
        plugin("homing", "motion", "fast", State.RUNNING, "62 % of the way", "", durations(120_000, 21_000, 88_000)),
        plugin("gravity", "motion", "fast", State.RUNNING, "7 joints, KDL", "", durations(120_000, 64_000, 210_000)),
        plugin("sine", "motion", "fast", State.STOPPED, "", "", nothing()),
        plugin("cartesian", "motion", "slow", State.FAILED, "", ERROR, nothing()),
        plugin("logging", "motion", "slow", State.RUNNING, "arm-2026-11-21.mcap, 14 MB", "",
            durations(12_000, 6_000, 61_000)),
        plugin("communication", "links", "io", State.STARTING, "", "", durations(400, 9_000, 22_000))));
  }

  public static LoopTiming timing(boolean realTime) {
    return new LoopTiming(realTime, List.of(
        new Loop("hal", "HAL", new Schedule(MILLI, realTime ? 90 : 0, 1), new Counts(120_431, 0, 2, 0, 0),
            durations(120_431, 4_200, 41_000),
            durations(120_431, 180_000, 390_000)),
        new Loop("fast", "motion", new Schedule(MILLI, realTime ? 70 : 0, 1), new Counts(120_400, 0, 0, 0, 0),
            durations(120_400, 9_800, 92_000),
            durations(120_400, 110_000, 340_000)),
        new Loop("slow", "motion", new Schedule(10 * MILLI, realTime ? 60 : 0, -1), new Counts(12_040, 3, 0, 17, 2),
            durations(12_040, 14_000, 2_300_000),
            durations(12_040, 60_000, 11_700_000))));
  }

  /** Three drives in these phases. */
  public static Drives drives(Phase first, Phase second, Phase third) {
    return new Drives(List.of(new Drive("shoulder", first, first == Phase.FAULT ? OVER_VOLTAGE : "operation enabled"),
        new Drive("elbow", second, "operation enabled"), new Drive("wrist", third, "operation enabled")));
  }

  /** Puts a control into the inputs. */
  public static void put(FakeUicContext context, ControlPlugins plugins, LoopTiming timing) {
    context.input(PluginsPorts.PLUGINS).put(PLUGINS, plugins, 0, Optional.empty());
    context.input(PluginsPorts.TIMING).put(TIMING, timing, 0, Optional.empty());
  }
}
