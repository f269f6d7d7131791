package org.robotui.recording.internal.tool;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.robotui.recording.ChunkCompression;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordingCopy;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.WriterOptions;

/** The commands of {@code robotui log}: what is in a recording, whether it is whole, and a whole copy of it. */
public final class LogTool {

  private static final int WHOLE = 0;
  private static final int DAMAGED = 1;
  private static final int REFUSED = 2;

  private final PrintStream out;
  private final PrintStream err;

  LogTool(PrintStream out, PrintStream err) {
    this.out = out;
    this.err = err;
  }

  /**
   * @param arguments {@code info|check [--json] FILE} or {@code repair|convert [--compression WORD] FILE NEW}
   */
  public static void main(String[] arguments) {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    System.exit(new LogTool(out, System.err).run(List.of(arguments)));
  }

  /** 0 if all is well, 1 if something in the recording is damaged, 2 if nothing could be done. */
  int run(List<String> arguments) {
    Optional<LogCommand> command = LogCommand.of(arguments);
    if (command.isEmpty()) {
      err.println("robotui: log knows info FILE, check FILE, repair FILE NEW, convert FILE NEW; --json with info and"
          + " check, --compression none, lz4 or zstd with repair and convert");
      return REFUSED;
    }
    try (RecordingReader recording = Recordings.open(command.get().file(), ScanProgress.NONE)) {
      return switch (command.get().verb()) {
        case INFO -> info(recording, command.get().json());
        case CHECK -> check(recording, command.get().json());
        case REPAIR, CONVERT -> copy(recording, command.get());
      };
    } catch (RecordingException e) {
      err.println("robotui: " + e.getMessage());
      return REFUSED;
    }
  }

  private int info(RecordingReader recording, boolean json) {
    out.print(json ? RecordingReport.json(recording, Optional.empty()) : RecordingReport.text(recording));
    return WHOLE;
  }

  private int check(RecordingReader recording, boolean json) throws RecordingException {
    RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
    long read = 0;
    while (cursor.next().isPresent()) {
      read++;
    }
    boolean files = recording.attachments().stream().filter(file -> !isReadable(recording, file)).count() == 0;
    if (json) {
      out.print(RecordingReport.json(recording, Optional.of(read)));
    } else {
      out.println(read + " messages can be read");
      recording.damages().forEach(out::println);
    }
    return files && recording.damages().isEmpty() ? WHOLE : DAMAGED;
  }

  private boolean isReadable(RecordingReader recording, RecordedAttachment file) {
    try {
      recording.content(file);
      return true;
    } catch (RecordingException e) {
      err.println("robotui: " + e.getMessage());
      return false;
    }
  }

  /**
   * A repaired file is as good as one that never was damaged: that something is missing in it is said, and is no
   * failure.
   */
  private int copy(RecordingReader recording, LogCommand command) throws RecordingException {
    Path to = command.to().orElseThrow();
    if (Files.exists(to)) {
      err.println("robotui: " + to + " is there already: name a file that is new");
      return REFUSED;
    }
    RecordingCopy.Outcome outcome = RecordingCopy.copy(recording, to,
        WriterOptions.defaults().withCompression(command.compression()).withProfile(profile(recording)));
    out.println(outcome.messages() + " messages were written to " + to);
    outcome.damages().forEach(out::println);
    return outcome.damages().isEmpty() || command.verb() == LogCommand.Verb.REPAIR ? WHOLE : DAMAGED;
  }

  private static String profile(RecordingReader recording) {
    Set<String> encodings = RecordingReport.encodings(recording);
    return encodings.equals(Set.of("ros1")) ? "ros1" : encodings.equals(Set.of("cdr")) ? "ros2" : "";
  }

  /** What a word on the command line stands for. */
  static Optional<ChunkCompression> compression(String word) {
    try {
      return Optional.of(ChunkCompression.valueOf(word.toUpperCase(Locale.ROOT)));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }
}
