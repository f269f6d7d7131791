package org.robotui.recorder.internal.file;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.host.Host;
import org.robotui.api.record.RecordingPlan;
import org.robotui.api.record.RecordingStatus;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.recorder.internal.capture.Captured;
import org.robotui.recorder.internal.capture.Collector;
import org.robotui.recorder.internal.capture.StreamHead;
import org.robotui.recorder.internal.capture.WallTime;
import org.robotui.recording.RecordingException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A recording that is being made. Two threads: one takes what robots send, one writes. */
public final class RunningRecording {
  private static final Logger LOG = LoggerFactory.getLogger(RunningRecording.class);
  private static final long LEAST_WAITING = 64L << 20;
  /** At 300 MB/s more than a second, for which systems now and then let nobody write. */
  private static final long MOST_WAITING = 512L << 20;
  private static final long POLL_MILLIS = 100;
  private static final long LOOK_NANOS = 1_000_000_000L;
  private static final Duration END = Duration.ofMinutes(1);

  /**
   * What recordings need.
   *
   * @param host has the robots
   * @param disk where they lie
   * @param maker makes writers
   * @param extras what each file has beside its messages
   */
  record Needs(Host host, Disk disk, FileSeries.Maker maker, FileSeries.Extras extras) {}

  private final Disk disk;
  private final FileSeries series;
  private final Instant since = Instant.now();
  private final ByteQueue queue = new ByteQueue(waiting());
  private final Collector collector;
  private final Runnable changed;
  private final Consumer<String> ended;
  private final Thread writer = Thread.ofPlatform().daemon().name("robotui-recorder-disk").unstarted(this::write);
  private volatile long left;
  private volatile String shortage = "";
  private volatile String failure = "";
  private long toldDrops;

  private RunningRecording(Needs needs, RecordingPlan plan, FileSeries series, WallTime time, Runnable changed,
      Consumer<String> ended) {
    this.disk = needs.disk();
    this.series = series;
    this.changed = changed;
    this.ended = ended;
    this.left = leftNow();
    this.collector = new Collector(needs.host(), plan.choice(), time, this::take);
    writer.start();
  }

  /**
   * Begins one.
   *
   * @param needs what it needs
   * @param plan how it is made
   * @param base its file
   * @param changed is told of a new file or problem
   * @param ended is told the reason where it ends by itself, on the thread that writes
   */
  static RunningRecording begin(Needs needs, RecordingPlan plan, Path base, Runnable changed, Consumer<String> ended)
      throws RecordingException {
    FileSeries series = new FileSeries(plan, base, needs.maker(), needs.extras());
    WallTime time = WallTime.begin();
    series.begin(time.startTime());
    return new RunningRecording(needs, plan, series, time, changed, ended);
  }

  private static long waiting() {
    return Math.clamp(Runtime.getRuntime().maxMemory() / 4, LEAST_WAITING, MOST_WAITING);
  }

  private void take(Captured message) {
    if (!queue.offer(message)) {
      message.head().dropped(1);
    }
  }

  private void write() {
    long look = System.nanoTime();
    try {
      while (!queue.isOver()) {
        Optional<Captured> next = queue.poll(POLL_MILLIS);
        if (next.isPresent() && series.write(next.get())) {
          changed.run();
        }
        if (System.nanoTime() - look >= 0) {
          look = System.nanoTime() + LOOK_NANOS;
          lookAround();
        }
      }
      series.end();
    } catch (RecordingException e) {
      LOG.warn("the recording ends", e);
      fail(e.getMessage());
    } catch (InterruptedException e) {
      fail("RobotUI has interrupted it"); // nobody does
    }
  }

  private void lookAround() throws RecordingException {
    left = leftNow();
    if (left < Disk.LEAST_TO_GO_ON) {
      throw new RecordingException(series.files().getLast(), series.bytes(),
          "the disk is nearly full (" + Disk.size(left) + " left): the recording ends");
    }
    String before = shortage;
    shortage = left < Disk.LITTLE
        ? "only " + Disk.size(left) + " are left on the disk; the recording ends at " + Disk.size(Disk.LEAST_TO_GO_ON)
        : "";
    if (before.isEmpty() != shortage.isEmpty()) {
      changed.run();
    }
    tellDrops();
  }

  /** Drops stand in the file where they happened, as far as that can be written. */
  private void tellDrops() {
    long now = dropped();
    if (now > toldDrops) {
      collector.events().say("drops", "", "", Long.toString(now - toldDrops),
          "messages that could not be taken in time");
      toldDrops = now;
      changed.run();
    }
  }

  private long leftNow() {
    try {
      return disk.left(series.files().getLast().getParent());
    } catch (IOException e) {
      LOG.debug("the disk cannot be looked at", e);
      return Long.MAX_VALUE;
    }
  }

  private void fail(String reason) {
    failure = reason;
    queue.end();
    collector.close();
    try {
      series.end();
    } catch (RecordingException e) {
      LOG.info("the last file has no index; ./robotui log repair makes one: {}", e.getMessage());
    }
    ended.accept(reason);
  }

  /** Ends it and waits until its files are whole, for a disk that hangs no longer than a minute. */
  void stop() {
    collector.close();
    queue.end();
    if (Thread.currentThread() != writer) {
      Uninterruptibles.await(System.nanoTime() + END.toNanos(), nanos -> writer.join(Duration.ofNanos(nanos)));
    }
  }

  private long dropped() {
    return collector.heads().stream().mapToLong(StreamHead::dropped).sum();
  }

  String failure() {
    return failure;
  }

  RecordingStatus status() {
    List<String> problems = new ArrayList<>();
    long dropped = dropped();
    if (!failure.isEmpty()) {
      problems.add(failure);
    }
    if (!shortage.isEmpty()) {
      problems.add(shortage);
    }
    if (dropped > 0) {
      problems.add(dropped + " messages could not be taken in time; choose fewer ports, or a faster disk");
    }
    return new RecordingStatus(series.files(), since, series.bytes(), series.messages(), dropped,
        channels(), left, problems, collector.leftOut());
  }

  /** Senders of one topic are apart in the file, and one for who looks how it is going. */
  private List<RecordingStatus.Channel> channels() {
    Map<List<String>, RecordingStatus.Channel> topics = new LinkedHashMap<>();
    collector.heads().stream().map(StreamHead::status).filter(c -> c.messages() > 0 || c.dropped() > 0)
        .forEach(c -> topics.merge(List.of(c.robot(), c.topic(), c.type()), c, RunningRecording::sum));
    return List.copyOf(topics.values());
  }

  private static RecordingStatus.Channel sum(RecordingStatus.Channel one, RecordingStatus.Channel other) {
    return new RecordingStatus.Channel(one.robot(), one.topic(), one.type(), one.messages() + other.messages(),
        one.bytes() + other.bytes(), one.dropped() + other.dropped());
  }
}
