package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.align.OffsetFinder;
import org.robotui.rfic.recording.internal.session.RecordedHistory;

/** Prints how far the clocks of two recordings are apart. */
final class OffsetLine {
  private final LogCommand command;
  private final PrintStream out;

  OffsetLine(LogCommand command, PrintStream out) {
    this.command = command;
    this.out = out;
  }

  /** Whether it could be told. */
  boolean print(List<RecordingReader> recordings) throws IOException {
    PayloadFormats formats = LogTool.formats();
    RecordedHistory reference = RecordedHistory.of(recordings.getFirst(), formats, LogTool.INSTANCE);
    RecordedHistory moved = RecordedHistory.of(recordings.getLast(), formats, LogTool.INSTANCE);
    try {
      Optional<OffsetEstimate> found = OffsetFinder.offset(reference, moved);
      out.println(command.json() ? json(found)
          : found.map(this::text).orElse(OffsetEstimate.NONE));
      return found.isPresent();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private String text(OffsetEstimate found) {
    return "add " + LogTime.seconds(found.offset()) + " s to the times of " + command.from().getLast()
        + ", with a deviation of " + LogTime.seconds(found.deviation()) + " s: " + found.basis();
  }

  private static String json(Optional<OffsetEstimate> found) {
    JsonLine line = new JsonLine().open('{');
    found.ifPresent(each -> line.name("offset").text(Long.toString(each.offset())).name("deviation")
        .text(Long.toString(each.deviation())).name("basis").text(each.basis()));
    return line.close('}').toString();
  }
}
