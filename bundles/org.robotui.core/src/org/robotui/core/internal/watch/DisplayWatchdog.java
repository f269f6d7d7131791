package org.robotui.core.internal.watch;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.robotui.core.internal.command.DisplayWatch;
import org.robotui.core.internal.watch.Watch.Watched;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Looks for a display thread that hangs. It cannot be ended in Java; so its stack is logged, once per silence, and the bundle
 * that holds it up is named. Only one that holds it up for so long that no busy machine explains it is remembered, if it can be
 * left out: the next start asks about it. What moves has been stopped by then by the arbiters.
 */
public final class DisplayWatchdog implements Watched {
  private static final Logger LOG = LoggerFactory.getLogger(DisplayWatchdog.class);
  private static final long HANGS_NANOS = 2_000_000_000L;
  private static final long HOPELESS_NANOS = 10_000_000_000L;

  private final DisplayWatch display;
  private final BundleNames names;
  private final SuspectFile suspects;
  private final Executor files;
  private final Consumer<String> alert;
  private boolean reported; // both only on the watch's thread
  private boolean remembered;

  /**
   * A watchdog.
   *
   * @param display what is known of the display thread
   * @param names of bundles
   * @param suspects remembers
   * @param files does the writing
   * @param alert is told a sentence
   */
  public DisplayWatchdog(
      DisplayWatch display, BundleNames names, SuspectFile suspects, Executor files, Consumer<String> alert) {
    this.display = display;
    this.names = names;
    this.suspects = suspects;
    this.files = files;
    this.alert = alert;
  }

  @Override
  public void check(long now) {
    long silence = display.silenceNanos();
    boolean hangs = silence > HANGS_NANOS;
    boolean hopeless = silence > HOPELESS_NANOS;
    if (hangs && !reported) {
      display.thread().ifPresent(t -> report(t, silence));
    }
    if (hopeless && !remembered) {
      display.thread().flatMap(t -> Blame.of(t.getStackTrace(), names)).ifPresent(this::remember);
    }
    reported = hangs;
    remembered = hopeless;
  }

  private void report(Thread thread, long silence) {
    StackTraceElement[] stack = thread.getStackTrace();
    Optional<Blame> blame = Blame.of(stack, names);
    String who = blame.map(b -> "bundle " + b.bundle() + " holds it up at " + b.frame()).orElse("no bundle is to blame");
    String message = String.format(Locale.ROOT, "the display has not answered for %.1f s; %s", silence * 1e-9, who);
    LOG.error("{}\n{}", message, Arrays.stream(stack).map(f -> "    at " + f).collect(Collectors.joining("\n")));
    alert.accept(message);
  }

  private void remember(Blame blame) {
    if (blame.canBeLeftOut()) {
      files.execute(() -> suspects.add(blame.bundle()));
    }
  }
}
