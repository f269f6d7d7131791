package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.replay.TimeRange;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.report.ReportPage;
import org.robotui.rfic.recording.internal.report.ReportedFile;
import org.robotui.rfic.recording.internal.session.RecordedHistory;

/** Writes a report of a recording to a file that is new. */
final class WrittenReport {
  private final LogCommand command;
  private final PrintStream out;

  WrittenReport(LogCommand command, PrintStream out) {
    this.command = command;
    this.out = out;
  }

  /** Whether nothing in the recording is damaged. */
  boolean write(RecordingReader recording) throws IOException, UsageException {
    Path to = command.to().orElseThrow();
    if (Files.exists(to)) {
      throw new UsageException(to + " is there already: name a file that is new");
    }
    RecordedHistory history =
        RecordedHistory.of(recording, LogTool.formats(), LogTool.INSTANCE);
    TimeRange range = LogTool.range(command, recording, history.span()).orElseThrow(
        () -> new UsageException(recording.file() + " has no message in that time"));
    write(to, page(recording, history, range));
    out.println("the report was written to " + to);
    recording.damages().forEach(out::println);
    return recording.damages().isEmpty();
  }

  private static String page(RecordingReader recording, RecordedHistory history, TimeRange range) throws IOException {
    try {
      ReportedFile file = new ReportedFile(recording.file().getFileName().toString(),
          recording.damages().stream().map(RecordingDamage::toString).toList());
      return ReportPage.of(file, history, range);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private static void write(Path to, String page) throws IOException {
    try {
      AtomicFile.write(to, page);
    } catch (IOException e) {
      throw new IOException(to + " could not be written: " + WriteFailure.reason(e), e);
    }
  }
}
