package org.robotui.uic.plot.internal.model;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.joint.JointState;
import org.robotui.testkit.FakeClock;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeSettings;
import org.robotui.testkit.KeptTimeline;
import org.robotui.uic.plot.internal.trace.Sketch;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * How long ten series of an hour at 1 kHz take from decoded values to what a screen shows, and how long each paint then
 * takes to thin them: {@code WholeBench [MESSAGES]} prints seconds, those that went by and those of the processor. What
 * decoding takes is a matter of the recording.
 */
final class WholeBench {
  private static final int JOINTS = 10;
  private static final long EVERY = 1_000_000L;
  private static final SourceId SOURCE = new SourceId("arm", "/joint_states");

  private WholeBench() {}

  public static void main(String[] arguments) {
    int messages = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 3_600_000;
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    List<Data> values = IntStream.range(0, 1000).<Data>mapToObj(WholeBench::joints).toList();
    FakeInput<Data> input = new FakeInput<>();
    input.candidates(List.of(new Input.Candidate(SOURCE, "JointState")));
    input.history(SOURCE, new Hour(values, messages));
    FakeSettings settings = new FakeSettings(PlotOptions.schema());
    settings.set(PlotOptions.AXES, List.of(Map.of("traces",
        IntStream.range(0, JOINTS).mapToObj(i -> SOURCE + ":joints[" + i + "].position").toList())));
    for (int round = 0; round < 3; round++) {
      PlotEngine engine = new PlotEngine(input, new FakeClock(), settings,
          new WholeSeries(input, Runnable::run, 10L * messages));
      long begun = System.nanoTime();
      long cpu = threads.getCurrentThreadCpuTime();
      PlotScene scene = engine.tick(System.nanoTime());
      double taken = (System.nanoTime() - begun) * 1e-9;
      double work = (threads.getCurrentThreadCpuTime() - cpu) * 1e-9;
      begun = System.nanoTime();
      TimeSpan all = scene.extent().orElseThrow();
      Sketch sketch = new Sketch();
      scene.traces().forEach(t -> t.series().orElseThrow().sketch(all, 1400, sketch));
      System.out.printf(Locale.ROOT,
          "%d samples in each of %d series: %.2f s, of the processor %.2f s; sketched in %.1f ms%n",
          scene.axes().getFirst().getFirst().series().orElseThrow().size(), scene.traces().count(), taken, work,
          (System.nanoTime() - begun) * 1e-6);
    }
  }

  private static JointState joints(int phase) {
    List<JointState.Joint> joints = new ArrayList<>();
    for (int i = 0; i < JOINTS; i++) {
      joints.add(new JointState.Joint("joint" + i, Math.sin(phase * 0.01 + i), 0, 0));
    }
    return new JointState(joints);
  }

  /** An hour of the same values again and again. */
  private record Hour(List<Data> values, int messages) implements StreamHistory {
    @Override
    public Timeline timeline() {
      return new KeptTimeline();
    }

    @Override
    public TimeRange span() {
      return new TimeRange(0, messages * EVERY);
    }

    @Override
    public long offset() {
      return 0;
    }

    @Override
    public long count(String port) {
      return messages;
    }

    @Override
    public void read(Set<String> ports, TimeRange range, HistoryTaker taker) {
      for (int i = 0; i < messages; i++) {
        if (i % 4096 == 0) {
          taker.reached(i * EVERY);
        }
        taker.take(new RecordedValue(SOURCE.port(), values.get(i % values.size()), i * EVERY,
            Optional.of(new Stamp(i * EVERY, ClockKind.SIMULATED)), Optional.empty()));
      }
    }
  }
}
