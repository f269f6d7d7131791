package org.robotui.rfic.lcm.internal.session;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import org.robotui.api.link.LinkState;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmStatistics;

/**
 * Says how it stands with the link: it is good only while messages come and none are lost. For one thread, but for
 * {@link #heard}.
 */
final class LinkWatch {
  private static final long SILENCE_NANOS = Duration.ofSeconds(5).toNanos();
  private static final long MEMORY_NANOS = Duration.ofSeconds(10).toNanos();
  private static final double SECOND = 1e9;

  private final String peer;
  private final boolean writesLog;
  private final Deque<Losses> recent = new ArrayDeque<>();
  private final long since;
  private volatile long heardAt;
  private volatile boolean heard;

  /** What was lost until a time. */
  private record Losses(long atNanos, long lost, long incomplete, long damaged, long dropped) {
    static Losses of(long now, LcmStatistics s) {
      return new Losses(now, s.lost(), s.incomplete(), s.damaged(), s.dropped());
    }

    /** A message that was given up is missing in its sender's numbers only where none of its fragments came. */
    Losses minus(Losses before) {
      return new Losses(atNanos, Math.max(0, lost - before.lost), incomplete - before.incomplete,
          damaged - before.damaged, dropped - before.dropped);
    }

    boolean any() {
      return lost > 0 || incomplete > 0 || damaged > 0 || dropped > 0;
    }
  }

  LinkWatch(String peer, boolean writesLog, long nowNanos) {
    this.peer = peer;
    this.writesLog = writesLog;
    this.since = nowNanos;
  }

  /** A message came. Called by the thread that takes messages. */
  void heard(long nowNanos) {
    heardAt = nowNanos;
    heard = true;
  }

  /** How it stands now. */
  LinkState state(LcmState connection, LcmStatistics statistics, String problem, long nowNanos) {
    return switch (connection) {
      case LcmState.Connecting c -> new LinkState.Connecting(peer);
      case LcmState.Failed f -> new LinkState.Failed(f.reason(), f.retryAfter());
      case LcmState.Ended e -> new LinkState.Degraded(peer, e.reason());
      case LcmState.Closed c -> new LinkState.Disconnected();
      case LcmState.Connected c -> connected(statistics, problem, nowNanos);
    };
  }

  private LinkState connected(LcmStatistics statistics, String problem, long nowNanos) {
    List<String> reasons = new ArrayList<>();
    long silent = nowNanos - (heard ? heardAt : since);
    if (!writesLog && silent > SILENCE_NANOS) {
      reasons.add(silence(silent));
    } else if (!heard && !writesLog) {
      return new LinkState.Connecting(peer);
    }
    losses(statistics, nowNanos, reasons);
    if (!problem.isEmpty()) {
      reasons.add(problem);
    }
    return reasons.isEmpty() ? new LinkState.Connected(peer) : new LinkState.Degraded(peer, String.join("; ", reasons));
  }

  private String silence(long nanos) {
    return heard ? String.format(Locale.ROOT, "no message for %.0f s", nanos / SECOND)
        : "nobody has sent anything yet: does the robot run, and do its programs use this LCM URL?";
  }

  private void losses(LcmStatistics statistics, long nowNanos, List<String> reasons) {
    Losses now = Losses.of(nowNanos, statistics);
    recent.addLast(now);
    while (nowNanos - recent.getFirst().atNanos() > MEMORY_NANOS) {
      recent.removeFirst();
    }
    Losses lately = now.minus(recent.getFirst());
    if (!lately.any()) {
      return;
    }
    List<String> parts = new ArrayList<>();
    part(parts, lately.lost(), "never came");
    part(parts, lately.incomplete(), "came in part");
    part(parts, lately.damaged(), "were damaged (" + statistics.lastDamage() + ")");
    part(parts, lately.dropped(), "were dropped here, as they came faster than they could be read");
    String remedy = lately.lost() + lately.incomplete() > 0 ? bufferRemedy(statistics) : "";
    reasons.add("of the messages of the last " + MEMORY_NANOS / Duration.ofSeconds(1).toNanos() + " s, "
        + String.join(", ", parts)
        + (remedy.isEmpty() ? "" : "; " + remedy));
  }

  private static void part(List<String> parts, long count, String what) {
    if (count > 0) {
      parts.add(count + " " + what);
    }
  }

  /** What to do about a receive buffer that is smaller than we asked for; empty where it is not. */
  static String bufferRemedy(LcmStatistics s) {
    return s.receiveBuffer() >= s.receiveBufferWanted() ? ""
        : String.format(Locale.ROOT,
            "the kernel gives a receive buffer of %d kB where %d kB were asked for: run sysctl -w net.core.rmem_max=%d",
            s.receiveBuffer() >> 10, s.receiveBufferWanted() >> 10, s.receiveBufferWanted());
  }
}
