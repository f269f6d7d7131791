package org.robotui.workbench.internal.measure;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.swt.widgets.Widget;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.PortKind;
import org.robotui.workbench.internal.dock.RuicSurface;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Measures how the window does for its user, and writes it down every second and at the end: when the first live
 * picture was painted, how long the display thread lets a task wait, what it did in the slowest turns, what each
 * robot's views had painted, when each view was seen first, and how soon the search answered. Once the start is over, a
 * thread of its own asks the display for a sign a hundred times a second, each time anew after the last one came; where
 * that takes long, it looks at the stack. It does neither before: that took a quarter of a second of a processor from
 * the start it measured.
 */
public final class Measurement implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Measurement.class);
  private static final long PERIOD_NANOS = Duration.ofMillis(10).toNanos();
  private static final double NANOS_PER_MILLI = 1e6;
  /** A frame of a screen takes this long: a turn that takes more than half of it is looked at. */
  private static final long LONG_NANOS = Duration.ofMillis(8).toNanos();
  private static final long LOOKING_NANOS = Duration.ofMillis(4).toNanos();
  private static final long WRITING_NANOS = Duration.ofSeconds(1).toNanos();
  /** Making the views is part of the start, which is measured apart. */
  private static final long SETTLING_NANOS = Duration.ofSeconds(5).toNanos();

  private final Host host;
  private final Display display;
  private final Path file;
  private final Latencies latencies = new Latencies();
  private final SlowTurns slow = new SlowTurns();
  private final AnswerTimes answers;
  private final long begun = System.nanoTime();
  private final Map<String, AtomicLong> frames = new ConcurrentSkipListMap<>();
  private final AtomicBoolean dataCame = new AtomicBoolean();
  private final Listener painted = this::painted;
  private final Host.Subscription subscription;
  private final Thread prober;
  private final Thread thread;
  /** Whether the views have been asked to show data; display thread only. */
  private boolean shown;
  private volatile long answeredNanos;
  private volatile long firstPictureMillis;
  private volatile long firstPictureCpuMillis;
  private volatile long firstPictureNanos;
  private volatile boolean closed;

  /**
   * Begins to measure.
   *
   * @param host the core
   * @param display the display; called on its thread
   * @param file where to write, as JSON
   */
  public Measurement(Host host, Display display, Path file) {
    this.host = host;
    this.display = display;
    this.thread = display.getThread();
    this.file = file;
    answers = new AnswerTimes(display);
    display.addFilter(SWT.Paint, painted);
    subscription = host.listen(new HostListener() {
      @Override
      public void frameReady(String ruic, String uic) {
        frames.computeIfAbsent(ruic, r -> new AtomicLong()).incrementAndGet();
        frameCame(ruic);
      }
    });
    prober = Thread.ofPlatform().daemon().name("robotui-measure").start(this::probe);
  }

  /**
   * The first frame with data behind it. The window heard of it before us, and its task for the display comes before
   * ours: what is painted after ours shows the data.
   */
  private void frameCame(String ruic) {
    if (!dataCame.get() && host.ruics().stream().anyMatch(r -> r.name().equals(ruic) && hasData(r))
        && dataCame.compareAndSet(false, true) && !display.isDisposed()) {
      display.asyncExec(() -> shown = true);
    }
  }

  private static boolean hasData(Ruic ruic) {
    return ruic.snapshot().ports().stream().anyMatch(p -> p.kind() == PortKind.STREAM && p.count() > 0);
  }

  /** A picture is live when a view was painted after it had been asked to show a robot's data. */
  private void painted(Event event) {
    if (shown && isOfView(event.widget)) {
      firstPictureNanos = System.nanoTime();
      firstPictureMillis = System.currentTimeMillis();
      firstPictureCpuMillis = ProcessHandle.current().info().totalCpuDuration().map(Duration::toMillis).orElse(0L);
      display.removeFilter(SWT.Paint, painted);
    }
  }

  private static boolean isOfView(Widget widget) {
    Control control = widget instanceof Control c ? c : null;
    while (control != null && !(control instanceof RuicSurface)) {
      control = control.getParent();
    }
    return control != null;
  }

  private void probe() {
    long writtenAt = System.nanoTime();
    while (!closed) {
      long asked = System.nanoTime();
      if (asked - writtenAt > WRITING_NANOS) {
        writtenAt = asked;
        write();
      }
      if (isSettled(asked) && !display.isDisposed()) {
        ask(asked);
      }
      LockSupport.parkNanos(Math.max(1, asked + PERIOD_NANOS - System.nanoTime()));
    }
  }

  private boolean isSettled(long nanos) {
    return firstPictureNanos != 0 && nanos - firstPictureNanos > SETTLING_NANOS;
  }

  private void ask(long asked) {
    Thread me = Thread.currentThread();
    answeredNanos = 0;
    display.asyncExec(() -> {
      answeredNanos = System.nanoTime();
      LockSupport.unpark(me);
    });
    LockSupport.parkNanos(this, LONG_NANOS);
    while (answeredNanos == 0 && !closed) {
      slow.look(thread.getStackTrace());
      LockSupport.parkNanos(this, LOOKING_NANOS);
    }
    long waited = answeredNanos - asked;
    if (answeredNanos != 0) {
      latencies.add(waited);
      slow.over(waited / NANOS_PER_MILLI, (answeredNanos - begun) * 1e-9);
    } else {
      slow.forget();
    }
  }

  @Override
  public void close() {
    closed = true;
    subscription.close();
    answers.close();
    LockSupport.unpark(prober);
    write();
  }

  /** Whoever reads it meanwhile finds one whole. */
  private synchronized void write() {
    try {
      AtomicFile.write(file, json());
    } catch (IOException e) {
      LOG.error("{} could not be written: {}", file, e.toString());
    }
  }

  private String json() {
    return String.format(Locale.ROOT,
        "{\"first_picture_epoch_ms\": %d, \"first_picture_cpu_ms\": %d, \"display_ms\": %s, "
            + "\"slowest\": [%s], \"frames\": {%s}, \"seen_epoch_ms\": {%s}, \"search_ms\": {\"opening\": %s, \"answering\": %s}}%n",
        firstPictureMillis, firstPictureCpuMillis, json(latencies),
        slow.worst().stream().map(Measurement::json).collect(Collectors.joining(", ")), json(frames),
        json(answers.seen()), json(answers.opening()), json(answers.answering()));
  }

  private static String json(Map<String, ? extends Number> numbers) {
    return numbers.entrySet().stream().map(e -> quoted(e.getKey()) + ": " + e.getValue())
        .collect(Collectors.joining(", "));
  }

  private static String json(Latencies times) {
    return String.format(Locale.ROOT, "{\"count\": %d, \"p50\": %.3f, \"p99\": %.3f, \"max\": %.3f}", times.count(),
        times.percentile(0.5), times.percentile(0.99), times.percentile(1));
  }

  private static String json(SlowTurns.Turn turn) {
    return String.format(Locale.ROOT, "{\"ms\": %.1f, \"after_s\": %.1f, \"view\": %s, \"at\": %s}",
        turn.millis(), turn.afterSeconds(), quoted(turn.view()), quoted(turn.at()));
  }

  private static String quoted(String text) {
    return "\"" + text.replaceAll("[\\\\\"\\p{Cntrl}]", "_") + "\"";
  }
}
