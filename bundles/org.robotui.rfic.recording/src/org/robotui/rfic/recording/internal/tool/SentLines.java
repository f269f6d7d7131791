package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.ScanProgress;
import org.robotui.rfic.recording.internal.file.RecordingFiles;
import org.robotui.rfic.recording.internal.send.RecordingSender;

/** Sends a recording into its framework until it ends or the user ends it, and says so. */
final class SentLines {
  private static final long FAREWELL_SECONDS = 3;
  private static final ThreadFactory THREADS = task -> {
    Thread thread = new Thread(task, "log play");
    thread.setDaemon(true);
    return thread;
  };

  private final PlayCommand command;
  private final PrintStream out;
  private final PrintStream err;

  SentLines(PlayCommand command, PrintStream out, PrintStream err) {
    this.command = command;
    this.out = out;
    this.err = err;
  }

  /** Whether all of it could be read. */
  boolean print(Map<String, String> variables) throws IOException, UsageException {
    CountDownLatch ended = new CountDownLatch(1);
    Thread end = end(Thread.currentThread(), ended);
    Runtime.getRuntime().addShutdownHook(end);
    try (RecordingReader recording = RecordingFiles.openToSend(command.file(), command.types(), ScanProgress.NONE);
        RecordingSender sender =
            RecordingSender.open(recording, part(recording), command.clock(), variables, THREADS)) {
      if (!sender.left().isEmpty()) {
        err.println("robotui: not sent, as messages of " + RecordingSender.FRAMEWORKS + " alone are: "
            + String.join(", ", sender.left()));
      }
      sender.places().forEach(out::println);
      out.println("sending " + command.file() + "; Ctrl+C ends it");
      out.println(sender.send(command.pace()) + " messages were sent");
      recording.damages().forEach(each -> err.println("robotui: " + each));
      return recording.damages().isEmpty();
    } catch (IllegalArgumentException e) {
      throw new UsageException(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("it was interrupted", e);
    } finally {
      ended.countDown();
    }
  }

  /** Where the process is ended, what was announced is taken back first. */
  private static Thread end(Thread sending, CountDownLatch ended) {
    return new Thread(() -> {
      sending.interrupt();
      try {
        ended.await(FAREWELL_SECONDS, TimeUnit.SECONDS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }, "end of log play");
  }

  private RecordingPart part(RecordingReader recording) throws UsageException {
    RecordingInterval span = recording.span().orElse(new RecordingInterval(0, 0));
    RecordingPart part = LogCommand.part(command.part(), span);
    if (recording.channels().stream().noneMatch(part.channels())) {
      throw new UsageException("no topic fits --topics; log info lists them");
    }
    if (part.interval().start() > span.end() || part.interval().end() < span.start()) {
      throw new UsageException("nothing was recorded between --from and --to");
    }
    return part;
  }
}
