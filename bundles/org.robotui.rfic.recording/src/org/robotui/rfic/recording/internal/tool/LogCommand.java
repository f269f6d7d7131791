package org.robotui.rfic.recording.internal.tool;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.robotui.condition.TimedCondition;
import org.robotui.recording.ChunkCompression;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.rfic.recording.internal.export.ExportFormat;

/**
 * What was asked for on the command line.
 *
 * @param verb what is done
 * @param from the files that are read
 * @param to the file or folder that is written, where one is
 * @param json whether it is said to a program
 * @param compression of what is written
 * @param begin of the part that is written
 * @param end of it
 * @param topics patterns of the topics in it; none for all
 * @param types where types of LCM are declared
 * @param format of what is exported
 * @param where the condition that is searched for; empty for none
 * @param video the video that is written in place of files of messages
 * @param rate its pictures a second
 */
record LogCommand(Verb verb, List<Path> from, Optional<Path> to, boolean json, ChunkCompression compression,
    Optional<LogTime> begin, Optional<LogTime> end, List<Pattern> topics, List<Path> types, ExportFormat format,
    String where, Optional<Path> video, Optional<Double> rate) {
  private static final String KNOWN =
      "log knows info FILE, check FILE, repair FILE NEW, convert FILE NEW, cut FILE NEW, merge FILE... NEW"
          + ", export FILE --out FOLDER, export FILE --video FILE.mp4, report FILE --out PAGE.html, find FILE... --where CONDITION, offset FILE FILE, compare FILE FILE --topic TOPIC and play FILE";

  private static final double MOST_PICTURES = 120;

  enum Verb {
    INFO, CHECK, REPAIR, CONVERT, CUT, MERGE, EXPORT, REPORT, OFFSET, FIND;

    boolean writes() {
      return this == REPAIR || this == CONVERT || this == CUT || this == MERGE;
    }

    boolean takesParts() {
      return this == CUT || this == MERGE || this == EXPORT || this == REPORT || this == FIND;
    }

    boolean tellsPrograms() {
      return this == INFO || this == CHECK || this == OFFSET || this == FIND;
    }

    boolean takesTopics() {
      return takesParts() && this != FIND && this != REPORT;
    }

    String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  static LogCommand of(List<String> arguments) throws UsageException {
    if (arguments.isEmpty()) {
      throw new UsageException(KNOWN);
    }
    Verb verb = Arrays.stream(Verb.values()).filter(each -> each.word().equals(arguments.getFirst())).findFirst()
        .orElseThrow(() -> new UsageException(KNOWN));
    LogOptions words = new LogOptions(verb.word(), arguments.subList(1, arguments.size()));
    boolean json = verb.tellsPrograms() && words.flag("--json");
    Optional<String> compression = verb.writes() ? words.value("--compression") : Optional.empty();
    Optional<LogTime> begin = verb.takesParts() ? words.time("--from") : Optional.empty();
    Optional<LogTime> end = verb.takesParts() ? words.time("--to") : Optional.empty();
    List<Pattern> topics = verb.takesTopics() ? words.patterns("--topics") : List.of();
    List<Path> types = words.paths("--types");
    Optional<String> out = verb == Verb.EXPORT || verb == Verb.REPORT ? words.value("--out") : Optional.empty();
    Optional<String> format = verb == Verb.EXPORT ? words.value("--format") : Optional.empty();
    Optional<String> video = verb == Verb.EXPORT ? words.value("--video") : Optional.empty();
    Optional<Double> rate = video.isPresent() ? words.number("--rate", 1, MOST_PICTURES) : Optional.empty();
    Optional<String> where = verb == Verb.FIND ? words.value("--where") : Optional.empty();
    List<Path> files = files(verb, words.files());
    if (verb == Verb.EXPORT && out.isPresent() == video.isPresent()) {
      throw new UsageException("log export needs --out and the folder where files are written, or --video and the file"
          + " of a video, such as --video front.mp4");
    }
    if (verb == Verb.REPORT && out.isEmpty()) {
      throw new UsageException("log report needs --out and the page that is written, such as --out run.html");
    }
    if (verb == Verb.FIND && where.isEmpty()) {
      throw new UsageException(
          "log find needs --where and a condition, such as --where \"battery charge < 0.2 for 5 s\"");
    }
    check(where);
    int read = verb.writes() ? files.size() - 1 : files.size();
    return new LogCommand(verb, files.subList(0, read),
        out.map(Path::of).or(() -> files.stream().skip(read).findFirst()), json,
        compression(compression), begin, end, topics, types, format(format), where.orElse(""), video.map(Path::of),
        rate);
  }

  private static void check(Optional<String> where) throws UsageException {
    try {
      where.ifPresent(text -> TimedCondition.parse(text, 0));
    } catch (IllegalArgumentException e) {
      throw new UsageException("--where: " + e.getMessage());
    }
  }

  private static List<Path> files(Verb verb, List<Path> files) throws UsageException {
    int needed = verb.writes() ? 2 : 1;
    if (verb == Verb.FIND && !files.isEmpty() || verb == Verb.OFFSET && files.size() == 2) {
      return files;
    }
    if (verb == Verb.OFFSET) {
      throw new UsageException("log offset takes two files: the one whose times stay, and the one that is moved");
    }
    if (verb == Verb.MERGE ? files.size() < needed + 1 : files.size() != needed) {
      throw new UsageException(verb == Verb.MERGE ? "log merge takes two files or more and the name of a new one"
          : "log " + verb.word() + " takes " + (verb.writes() ? "a file and the name of a new one" : "one file"));
    }
    return files;
  }

  private static ChunkCompression compression(Optional<String> word) throws UsageException {
    if (word.isEmpty()) {
      return ChunkCompression.ZSTD;
    }
    return Arrays.stream(ChunkCompression.values())
        .filter(each -> each.name().toLowerCase(Locale.ROOT).equals(word.get())).findFirst()
        .orElseThrow(() -> new UsageException("--compression takes none, lz4 or zstd, not '" + word.get() + "'"));
  }

  private static ExportFormat format(Optional<String> word) throws UsageException {
    return word.isEmpty() ? ExportFormat.CSV
        : ExportFormat.of(word.get())
            .orElseThrow(() -> new UsageException("--format takes csv or jsonl, not '" + word.get() + "'"));
  }

  /** The part of recordings that have such a span. */
  RecordingPart part(RecordingInterval span) throws UsageException {
    return part(new PlayCommand.Part(begin, end, topics), span);
  }

  static RecordingPart part(PlayCommand.Part wanted, RecordingInterval span) throws UsageException {
    long start = wanted.begin().map(time -> time.in(span)).orElse(Long.MIN_VALUE);
    long stop = wanted.end().map(time -> time.in(span)).orElse(Long.MAX_VALUE);
    if (stop < start) {
      throw new UsageException("--to lies before --from");
    }
    Predicate<RecordedChannel> chosen = channel -> wanted.topics().isEmpty()
        || wanted.topics().stream().anyMatch(each -> each.matcher(channel.topic()).matches());
    return new RecordingPart(new RecordingInterval(start, stop), chosen);
  }
}
