package org.robotui.core.internal.watch;

import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.robotui.core.internal.command.DisplayWatch;
import org.robotui.core.internal.watch.Watch.Watched;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Looks for a display thread that hangs. It cannot be ended in Java; so, once per silence, the bundle that holds it up
 * is named and its stack is logged. A short silence is only told of where it has stopped something: a window that is
 * being made, or a machine that is busy, is no news to who looks at it. Only one that holds it up for so long that no
 * busy machine explains it is remembered, if it can be left out: the next start asks about it.
 */
public final class DisplayWatchdog implements Watched {
  private static final Logger LOG = LoggerFactory.getLogger(DisplayWatchdog.class);
  private static final long HANGS_NANOS = 5_000_000_000L;
  private static final long HOPELESS_NANOS = 10_000_000_000L;
  private static final int LOOKS = 100;

  private final DisplayWatch display;
  private final BundleNames names;
  private final SuspectFile suspects;
  private final Executor files;
  private final Consumer<String> notice;
  private Silence silence = Silence.NONE; // only on the watch's thread

  /** What was done about the silence that goes on, and whom each look at it found. */
  private record Silence(boolean reported, boolean remembered, List<String> found) {
    private static final Silence NONE = new Silence(false, false, List.of());

    Silence with(boolean report, boolean remember, Optional<String> bundle) {
      List<String> all = Stream.concat(found.stream(), bundle.stream()).toList();
      return new Silence(reported || report, remembered || remember,
          all.subList(Math.max(0, all.size() - LOOKS), all.size()));
    }

    /** The one that was found most often: a single look may find one that was just about to end. */
    String culprit() {
      return found.stream().max(Comparator.comparingInt(b -> Collections.frequency(found, b)))
          .map(b -> "; bundle " + b + " held it up").orElse("");
    }
  }

  /**
   * What the display did at one moment. Telling of it takes time, in which it may go on: so all that is told is from
   * one look.
   */
  private record Look(StackOf stack, Optional<Blame> blame) {}

  /**
   * A watchdog.
   *
   * @param display what is known of the display thread
   * @param names of bundles
   * @param suspects remembers
   * @param files does the writing
   * @param notice is told a sentence
   */
  public DisplayWatchdog(
      DisplayWatch display, BundleNames names, SuspectFile suspects, Executor files, Consumer<String> notice) {
    this.display = display;
    this.names = names;
    this.suspects = suspects;
    this.files = files;
    this.notice = notice;
  }

  @Override
  public void check(long now) {
    long nanos = display.silenceNanos();
    boolean stopped = display.takeStopped();
    if (nanos > DisplayWatch.SILENCE_NANOS) {
      display.thread().map(this::look).ifPresent(look -> goesOn(nanos, stopped, look));
    } else {
      over(stopped, display.takeLongestSilenceNanos());
    }
  }

  private Look look(Thread thread) {
    StackTraceElement[] stack = thread.getStackTrace();
    return new Look(new StackOf(thread, stack), Blame.of(stack, names));
  }

  private void goesOn(long nanos, boolean stopped, Look look) {
    boolean report = !silence.reported() && (stopped || nanos > HANGS_NANOS);
    boolean remember = !silence.remembered() && nanos > HOPELESS_NANOS;
    silence = silence.with(report, remember, look.blame().map(Blame::bundle));
    if (report) {
      report(look, nanos, stopped);
    }
    if (remember) {
      look.blame().ifPresent(this::remember);
    }
  }

  private void over(boolean stopped, long nanos) {
    if (silence.reported()) {
      notice.accept(
          String.format(Locale.ROOT, "the display answers again, after %.1f s%s", nanos * 1e-9, silence.culprit()));
    } else if (stopped) {
      notice.accept("the display did not answer for a moment: what its windows moved was stopped");
    }
    silence = Silence.NONE;
  }

  private void report(Look look, long nanos, boolean stopped) {
    String who =
        look.blame().map(b -> "bundle " + b.bundle() + " holds it up at " + b.frame()).orElse("no bundle is to blame");
    String done = stopped ? "what its windows moved is stopped" : "its windows can move no robot until it does";
    String message =
        String.format(Locale.ROOT, "the display has not answered for %.1f s; %s; %s", nanos * 1e-9, who, done);
    notice.accept(message);
    LOG.info("What the display does", look.stack());
  }

  private void remember(Blame blame) {
    if (blame.canBeLeftOut()) {
      files.execute(() -> suspects.add(blame.bundle()));
    }
  }
}
