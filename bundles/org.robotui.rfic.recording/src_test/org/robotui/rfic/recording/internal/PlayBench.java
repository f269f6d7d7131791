package org.robotui.rfic.recording.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.robotui.api.Rfic;
import org.robotui.api.config.Placed;
import org.robotui.api.link.LinkState;
import org.robotui.api.replay.TimelineState;
import org.robotui.data.navigation.Odometry;
import org.robotui.rfic.recording.internal.time.SharedTimeline;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.FakeRficContext.Published;
import org.robotui.testkit.FakeSettings;

/** Recordings on a timeline whose clock is moved by hand. */
final class PlayBench implements AutoCloseable {
  private static final long PATIENCE_NANOS = 60_000_000_000L;

  private static final long TURN_NANOS = 50_000_000;

  final AtomicLong real = new AtomicLong(5_000_000_000L);
  final SharedTimeline timeline = new SharedTimeline(real::get);
  private final RecordingRficType type = new RecordingRficType(timeline);
  private final List<Rfic> open = new ArrayList<>();

  /** Opens a recording and waits until it is connected. */
  FakeRficContext open(Path file, Map<String, Object> settings) {
    FakeRficContext context = new FakeRficContext();
    start(context, file, settings);
    await(() -> "no link: " + context.links, () -> !context.links.isEmpty()
        && (context.links.getLast() instanceof LinkState.Connected
            || context.links.getLast() instanceof LinkState.Degraded));
    return context;
  }

  void start(FakeRficContext context, Path file, Map<String, Object> settings) {
    FakeSettings written = new FakeSettings(type.schema());
    written.set("file", Placed.nowhere(file.toString()));
    settings.forEach(written::set);
    Rfic rfic = type.create(context, written.current());
    open.add(rfic);
    rfic.start();
  }

  /** Lets real time pass, slowly enough that nobody is late, and waits until the timeline is there. */
  void pass(double seconds, double expected) {
    await(() -> "it is on its way to " + state(), timeline::isThere);
    long left = Math.round(seconds * 1e9);
    while (left > 0) {
      long turn = Math.min(left, TURN_NANOS);
      TimelineState before = state();
      real.addAndGet(turn);
      left -= turn;
      await(() -> "it does not pass " + state(), () -> !state().playing()
          || state().position() >= before.position() + (long) (turn * before.speed()));
    }
    at(expected);
  }

  /** Waits until the timeline is somewhere, with all that holds there. */
  void at(double seconds) {
    await(() -> "it is at " + (state().position() - SmallRecording.BEGIN) / 1e9 + " s, not at " + seconds,
        () -> state().position() == SmallRecording.time(seconds) && timeline.isThere());
  }

  void seek(double seconds) {
    timeline.seek(SmallRecording.time(seconds));
    at(seconds);
  }

  TimelineState state() {
    return timeline.state();
  }

  /** Waits for where the robot was last. */
  static void awaitX(FakeRficContext context, String port, double x) {
    await(() -> "last of " + port + ": " + last(context, port), () -> {
      Deque<Published> all = context.published.get(port);
      return all != null && !all.isEmpty() && ((Odometry) all.getLast().value()).pose().translation().x() == x;
    });
  }

  static String last(FakeRficContext context, String port) {
    Deque<Published> all = context.published.get(port);
    return all == null || all.isEmpty() ? "nothing" : all.getLast().value().toString();
  }

  static void await(Supplier<String> otherwise, BooleanSupplier condition) {
    long deadline = System.nanoTime() + PATIENCE_NANOS;
    while (!condition.getAsBoolean() && System.nanoTime() - deadline < 0) {
      try {
        Thread.sleep(2);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
    assertTrue(condition.getAsBoolean(), otherwise);
  }

  @Override
  public void close() {
    open.forEach(Rfic::close);
  }
}
