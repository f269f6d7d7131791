package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.replay.TimeRange;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordingCopy;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.WriterOptions;
import org.robotui.rfic.recording.internal.export.ExportedFile;
import org.robotui.rfic.recording.internal.export.TopicExport;
import org.robotui.rfic.recording.internal.file.ChannelFormats;
import org.robotui.rfic.recording.internal.file.RecordingFiles;

/**
 * The commands of {@code robotui log}: what is in a recording, whether it is whole, copies of all or a part of it, and
 * files of its messages for programs of others.
 */
public final class LogTool {
  /** What the robot interface of a recording is called where it is opened in a window. */
  static final String INSTANCE = "recording";

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
   * @param arguments {@code info|check [--json] FILE}, {@code repair|convert|cut FILE NEW}, {@code merge FILE... NEW},
   * {@code export FILE --out FOLDER}, {@code export FILE --video FILE.mp4 --rate N}, {@code report FILE --out PAGE},
   * {@code offset [--json]
   * FILE FILE}, {@code find [--json] FILE... --where CONDITION} or what {@link CompareCommand} says; those that write
   * recordings with {@code --compression WORD}, the last five with {@code --from} and {@code --to}, {@code cut},
   * {@code merge} and {@code export} with {@code --topics}, {@code export} with {@code --format csv|jsonl}, all with
   * {@code --types}
   */
  public static void main(String[] arguments) {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    System.exit(new LogTool(out, System.err).run(List.of(arguments)));
  }

  /** 0 if all is well, 1 if something in the recording is damaged, 2 if nothing could be done. */
  int run(List<String> arguments) {
    String verb = arguments.isEmpty() ? "" : arguments.getFirst();
    try {
      return switch (verb) {
        case CompareCommand.VERB -> compare(CompareCommand.of(arguments.subList(1, arguments.size())));
        case PlayCommand.VERB -> play(PlayCommand.of(arguments.subList(1, arguments.size())));
        default -> run(LogCommand.of(arguments));
      };
    } catch (IOException | UsageException e) {
      err.println("robotui: " + e.getMessage());
      return REFUSED;
    }
  }

  private int run(LogCommand command) throws IOException, UsageException {
    List<RecordingReader> recordings = new ArrayList<>();
    try {
      for (Path file : command.from()) {
        recordings.add(RecordingFiles.open(file, command.types(), ScanProgress.NONE));
      }
      return switch (command.verb()) {
        case INFO -> info(recordings.getFirst(), command.json());
        case CHECK -> check(recordings.getFirst(), command.json());
        case REPAIR, CONVERT, CUT, MERGE -> copy(recordings, command);
        case EXPORT -> command.video().isEmpty() ? export(recordings.getFirst(), command)
            : new WrittenVideo(command, command.video().get(), out).write(recordings.getFirst()) ? WHOLE : DAMAGED;
        case REPORT -> new WrittenReport(command, out).write(recordings.getFirst()) ? WHOLE : DAMAGED;
        case OFFSET -> new OffsetLine(command, out).print(recordings) ? WHOLE : DAMAGED;
        case FIND -> new FoundLines(command, out, err).print(recordings) ? WHOLE : DAMAGED;
      };
    } finally {
      recordings.forEach(RecordingReader::close);
    }
  }

  private int compare(CompareCommand command) throws IOException, UsageException {
    return new ComparedLines(command, out, err).print() ? WHOLE : DAMAGED;
  }

  private int play(PlayCommand command) throws IOException, UsageException {
    return new SentLines(command, out, err).print(System.getenv()) ? WHOLE : DAMAGED;
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
  private int copy(List<RecordingReader> recordings, LogCommand command) throws IOException, UsageException {
    Path to = command.to().orElseThrow();
    if (Files.exists(to)) {
      err.println("robotui: " + to + " is there already: name a file that is new");
      return REFUSED;
    }
    RecordingPart part = part(recordings, command);
    WriterOptions options =
        WriterOptions.defaults().withCompression(command.compression()).withProfile(profile(recordings));
    RecordingCopy.Outcome outcome = WrittenBag.isAsked(to) ? new WrittenBag(out).write(recordings, part, to, options)
        : RecordingCopy.copy(recordings, part, to, options);
    out.println(outcome.messages() + " messages were written to " + to);
    outcome.damages().forEach(out::println);
    return outcome.damages().isEmpty() || command.verb() == LogCommand.Verb.REPAIR ? WHOLE : DAMAGED;
  }

  private static RecordingPart part(List<RecordingReader> recordings, LogCommand command) throws UsageException {
    RecordingPart part = command.part(span(recordings));
    if (!command.topics().isEmpty()
        && recordings.stream().flatMap(each -> each.channels().stream()).noneMatch(part.channels())) {
      throw new UsageException("no topic fits --topics; log info lists them");
    }
    return part;
  }

  private int export(RecordingReader recording, LogCommand command) throws IOException, UsageException {
    TopicExport export = new TopicExport(recording, part(List.of(recording), command), command.to().orElseThrow(),
        command.format());
    List<ExportedFile> files =
        export.run(new ChannelFormats(formats()));
    files.forEach(out::println);
    recording.damages().forEach(out::println);
    if (files.isEmpty()) {
      err.println("robotui: there is no message to export");
    }
    return files.stream().allMatch(ExportedFile::isWhole) && recording.damages().isEmpty() ? WHOLE : DAMAGED;
  }

  /** What is known of encodings, with the definitions that the environment names. */
  static PayloadFormats formats() {
    return new PayloadFormats(new RosDefinitions(System.getenv()));
  }

  /** The part of a recording that is looked at; none where it lies elsewhere. */
  static Optional<TimeRange> range(LogCommand command, RecordingReader recording, TimeRange span)
      throws UsageException {
    RecordingInterval wanted = command.part(new RecordingInterval(span.start(), span.end())).interval();
    long start = Math.max(wanted.start(), span.start());
    long end = Math.min(wanted.end(), span.end());
    return recording.span().isEmpty() || end < start ? Optional.empty() : Optional.of(new TimeRange(start, end));
  }

  private static RecordingInterval span(List<RecordingReader> recordings) {
    return recordings.stream().flatMap(each -> each.span().stream())
        .reduce((a, b) -> new RecordingInterval(Math.min(a.start(), b.start()), Math.max(a.end(), b.end())))
        .orElse(new RecordingInterval(0, 0));
  }

  private static String profile(List<RecordingReader> recordings) {
    Set<String> encodings = recordings.stream().flatMap(each -> RecordingReport.encodings(each).stream())
        .collect(Collectors.toSet());
    return encodings.equals(Set.of("ros1")) ? "ros1" : encodings.equals(Set.of("cdr")) ? "ros2" : "";
  }
}
