package org.robotui.rfic.recording.internal.tool;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
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
 */
record LogCommand(Verb verb, List<Path> from, Optional<Path> to, boolean json, ChunkCompression compression,
    Optional<LogTime> begin, Optional<LogTime> end, List<Pattern> topics, List<Path> types, ExportFormat format) {
  private static final String KNOWN =
      "log knows info FILE, check FILE, repair FILE NEW, convert FILE NEW, cut FILE NEW, merge FILE... NEW"
          + " and export FILE --out FOLDER";

  enum Verb {
    INFO, CHECK, REPAIR, CONVERT, CUT, MERGE, EXPORT;

    boolean writes() {
      return this != INFO && this != CHECK && this != EXPORT;
    }

    boolean takesParts() {
      return this == CUT || this == MERGE || this == EXPORT;
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
    List<String> words = new ArrayList<>(arguments.subList(1, arguments.size()));
    boolean json = (verb == Verb.INFO || verb == Verb.CHECK) && words.remove("--json");
    Optional<String> compression = verb.writes() ? option(words, "--compression") : Optional.empty();
    Optional<String> begin = verb.takesParts() ? option(words, "--from") : Optional.empty();
    Optional<String> end = verb.takesParts() ? option(words, "--to") : Optional.empty();
    Optional<String> topics = verb.takesParts() ? option(words, "--topics") : Optional.empty();
    Optional<String> types = option(words, "--types");
    Optional<String> out = verb == Verb.EXPORT ? option(words, "--out") : Optional.empty();
    Optional<String> format = verb == Verb.EXPORT ? option(words, "--format") : Optional.empty();
    List<Path> files = files(verb, words);
    if (verb == Verb.EXPORT && out.isEmpty()) {
      throw new UsageException("log export needs --out and the folder where files are written");
    }
    int read = verb.writes() ? files.size() - 1 : files.size();
    return new LogCommand(verb, files.subList(0, read),
        out.map(Path::of).or(() -> files.stream().skip(read).findFirst()), json,
        compression(compression), time("--from", begin), time("--to", end), patterns(topics),
        paths(types), format(format));
  }

  private static List<Path> files(Verb verb, List<String> words) throws UsageException {
    for (String word : words) {
      if (word.startsWith("--")) {
        throw new UsageException("log " + verb.word() + " has no option " + word);
      }
    }
    int needed = verb.writes() ? 2 : 1;
    if (verb == Verb.MERGE ? words.size() < needed + 1 : words.size() != needed) {
      throw new UsageException(verb == Verb.MERGE ? "log merge takes two files or more and the name of a new one"
          : "log " + verb.word() + " takes " + (verb.writes() ? "a file and the name of a new one" : "one file"));
    }
    return words.stream().map(Path::of).toList();
  }

  private static Optional<String> option(List<String> words, String name) throws UsageException {
    int at = words.indexOf(name);
    if (at < 0) {
      return Optional.empty();
    }
    if (at + 1 >= words.size()) {
      throw new UsageException(name + " needs a value");
    }
    words.remove(at);
    return Optional.of(words.remove(at));
  }

  private static ChunkCompression compression(Optional<String> word) throws UsageException {
    if (word.isEmpty()) {
      return ChunkCompression.ZSTD;
    }
    return Arrays.stream(ChunkCompression.values())
        .filter(each -> each.name().toLowerCase(Locale.ROOT).equals(word.get())).findFirst()
        .orElseThrow(() -> new UsageException("--compression takes none, lz4 or zstd, not '" + word.get() + "'"));
  }

  private static Optional<LogTime> time(String name, Optional<String> word) throws UsageException {
    return word.isEmpty() ? Optional.empty() : Optional.of(LogTime.of(name, word.get()));
  }

  private static List<Path> paths(Optional<String> words) {
    return words.stream().flatMap(each -> Arrays.stream(each.split(","))).filter(each -> !each.isBlank())
        .map(Path::of).toList();
  }

  private static ExportFormat format(Optional<String> word) throws UsageException {
    return word.isEmpty() ? ExportFormat.CSV
        : ExportFormat.of(word.get())
            .orElseThrow(() -> new UsageException("--format takes csv or jsonl, not '" + word.get() + "'"));
  }

  private static List<Pattern> patterns(Optional<String> words) {
    return words.stream().flatMap(each -> Arrays.stream(each.split(","))).filter(each -> !each.isBlank())
        .map(each -> Pattern.compile(Arrays.stream(each.strip().split("\\*", -1)).map(Pattern::quote)
            .collect(Collectors.joining(".*"))))
        .toList();
  }

  /** The part of recordings that have such a span. */
  RecordingPart part(RecordingInterval span) throws UsageException {
    long start = begin.map(time -> time.in(span)).orElse(Long.MIN_VALUE);
    long stop = end.map(time -> time.in(span)).orElse(Long.MAX_VALUE);
    if (stop < start) {
      throw new UsageException("--to lies before --from");
    }
    Predicate<RecordedChannel> chosen =
        channel -> topics.isEmpty() || topics.stream().anyMatch(each -> each.matcher(channel.topic()).matches());
    return new RecordingPart(new RecordingInterval(start, stop), chosen);
  }
}
