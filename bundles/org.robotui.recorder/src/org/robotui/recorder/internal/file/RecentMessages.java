package org.robotui.recorder.internal.file;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.api.host.Host;
import org.robotui.api.record.RecorderState.Recent;
import org.robotui.api.record.RecordingChoice;
import org.robotui.recorder.internal.capture.Captured;
import org.robotui.recorder.internal.capture.Collector;
import org.robotui.recorder.internal.capture.WallTime;

/** The last seconds of what robots send, in memory, bounded by time and size. */
final class RecentMessages implements AutoCloseable {
  private final Duration limit;
  private final long most;
  private final WallTime time = WallTime.begin();
  private final Deque<Captured> messages = new ArrayDeque<>();
  private final HeldMessages held = new HeldMessages();
  private final Collector collector;
  private long bytes;
  private long cutAt = Long.MIN_VALUE;

  RecentMessages(Host host, Duration limit, RecordingChoice choice, long most) {
    this.limit = limit;
    this.most = most;
    this.collector = new Collector(host, choice, time, this::take);
  }

  /** Messages come nearly in the order of their times; those few that do not go a moment later. */
  private synchronized void take(Captured message) {
    messages.add(message);
    bytes += message.weight();
    while (messages.size() > 1 && (bytes > most || isOld(messages.peek(), message.logTime()))) {
      Captured gone = messages.poll();
      cutAt = isOld(gone, message.logTime()) ? cutAt : message.logTime();
      bytes -= gone.weight();
      held.note(gone);
    }
  }

  private boolean isOld(Captured message, long now) {
    return now - message.logTime() > limit.toNanos();
  }

  /** What held when the last seconds began, then they themselves. */
  synchronized List<Captured> all() {
    long now = time.now();
    List<Captured> recent = messages.stream().filter(message -> !isOld(message, now)).toList();
    long start = recent.isEmpty() ? now : recent.getFirst().logTime();
    messages.stream().filter(message -> isOld(message, now)).forEach(held::note);
    return Stream.concat(held.all().stream().map(message -> message.at(start)), recent.stream()).toList();
  }

  synchronized Recent state() {
    long now = time.now();
    long kept = messages.isEmpty() ? 0 : Math.min(limit.toNanos(), now - messages.peek().logTime());
    boolean cut = cutAt != Long.MIN_VALUE && now - cutAt < limit.toNanos();
    return new Recent(limit, Duration.ofNanos(Math.max(0, kept)), bytes, messages.size(), cut);
  }

  @Override
  public void close() {
    collector.close();
  }
}
