package org.robotui.headless.internal;

import java.io.PrintStream;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.api.record.Recorder;
import org.robotui.api.record.RecorderState.Ended;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingStatus;

/** Records until it is stopped or the time is over, and says how it goes. */
final class RecordRun {
  private static final long LOOK_MILLIS = 100;
  private static final long LINE_NANOS = 1_000_000_000L;
  /** Lines of text are for people. */
  private static final int SELDOM = 5;

  private final Recorder recorder;
  private final PrintStream out;
  private final PrintStream err;
  private final CountDownLatch stop;
  private String told = "";
  private List<String> left = List.of();

  RecordRun(Recorder recorder, PrintStream out, PrintStream err, CountDownLatch stop) {
    this.recorder = recorder;
    this.out = out;
    this.err = err;
    this.stop = stop;
  }

  /** Answers how it ended. */
  Exit run(RecordArguments wanted) throws InterruptedException {
    RecordingOutcome begun = recorder.start(wanted.plan());
    if (begun instanceof RecordingOutcome.Refused refused) {
      err.println(refused.sentence());
      return Exit.RECORDING;
    }
    boolean json = wanted.rest().json();
    if (!json) {
      out.println(begun.sentence());
      out.flush();
    }
    watch(wanted.rest().limit(), json);
    recorder.stop();
    return end(json);
  }

  private void watch(Optional<Duration> limit, boolean json) throws InterruptedException {
    long begun = System.nanoTime();
    long line = begun;
    Optional<RecordingStatus> now = recorder.state().recording();
    while (now.isPresent() && limit.filter(most -> System.nanoTime() - begun >= most.toNanos()).isEmpty()
        && !stop.await(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
      now = recorder.state().recording();
      if (now.isPresent() && System.nanoTime() - line >= 0) {
        line += json ? LINE_NANOS : LINE_NANOS * SELDOM;
        say(now.get(), json);
      }
    }
  }

  private void say(RecordingStatus status, boolean json) {
    out.println(json ? json(status, false) : text(status));
    out.flush();
    String problem = String.join("; ", status.problems());
    if (!problem.isEmpty() && !problem.equals(told)) {
      err.println(problem);
      err.flush();
    }
    told = problem;
    if (!json) {
      sayLeftOut(status);
    }
  }

  private void sayLeftOut(RecordingStatus status) {
    if (!status.leftOut().equals(left)) {
      left = status.leftOut();
      out.println("left out, as it is recorded on request alone: " + String.join(", ", left)
          + " (--ports names what is recorded; --ports '*' is everything)");
      out.flush();
    }
  }

  private static String text(RecordingStatus status) {
    return String.format(Locale.ROOT, "%5d s  %8.1f MB  %d messages on %d channels%s",
        Duration.between(status.since(), Instant.now()).toSeconds(), status.bytes() / 1e6, status.messages(),
        status.channels().size(), status.dropped() == 0 ? "" : "  " + status.dropped() + " dropped");
  }

  private static String json(RecordingStatus status, boolean ended) {
    return new Json()
        .put("file", status.file().toString())
        .put("files", status.files().size())
        .put("seconds", Duration.between(status.since(), Instant.now()).toMillis() / 1000.0, 1)
        .put("bytes", status.bytes())
        .put("messages", status.messages())
        .put("dropped", status.dropped())
        .put("channels", status.channels().size())
        .put("disk_left", status.diskLeft())
        .put("ended", ended ? 1 : 0)
        .put("problem", String.join("; ", status.problems()))
        .put("left_out", String.join(", ", status.leftOut()))
        .end();
  }

  /** Somebody else may have ended it: the framework where the process is stopped, a disk that is full. */
  private Exit end(boolean json) {
    Optional<Ended> ended = recorder.state().ended();
    if (ended.isEmpty()) {
      err.println("the recording has not ended in order");
      return Exit.RECORDING;
    }
    RecordingStatus status = ended.get().status();
    if (json) {
      out.println(json(status, true));
    } else {
      status.channels().forEach(channel -> out.println(String.format(Locale.ROOT, "  %9d  %s (%s)%s",
          channel.messages(), channel.topic(), channel.type().isEmpty() ? channel.robot() : channel.type(),
          channel.dropped() == 0 ? "" : ", " + channel.dropped() + " dropped")));
      sayLeftOut(status);
      status.files().forEach(file -> out.println(file));
    }
    if (!ended.get().reason().isEmpty()) {
      err.println(ended.get().reason());
      return Exit.RECORDING;
    }
    return Exit.FINE;
  }
}
