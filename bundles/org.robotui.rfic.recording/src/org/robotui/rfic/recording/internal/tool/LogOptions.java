package org.robotui.rfic.recording.internal.tool;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The words of a command line, of which options are taken until names of files are left. */
final class LogOptions {
  private final String verb;
  private final List<String> words;

  LogOptions(String verb, List<String> words) {
    this.verb = verb;
    this.words = new ArrayList<>(words);
  }

  boolean flag(String name) {
    return words.remove(name);
  }

  Optional<String> value(String name) throws UsageException {
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

  /** All values of an option that may be written several times. */
  List<String> values(String name) throws UsageException {
    List<String> all = new ArrayList<>();
    for (Optional<String> next = value(name); next.isPresent(); next = value(name)) {
      all.add(next.get());
    }
    return all;
  }

  /** Files and folders, with commas between them. */
  List<Path> paths(String name) throws UsageException {
    return value(name).stream().flatMap(each -> Arrays.stream(each.split(","))).filter(each -> !each.isBlank())
        .map(Path::of).toList();
  }

  /** Names with commas between them, in which a star stands for any letters. */
  List<Pattern> patterns(String name) throws UsageException {
    return value(name).stream().flatMap(each -> Arrays.stream(each.split(","))).filter(each -> !each.isBlank())
        .map(each -> Pattern.compile(Arrays.stream(each.strip().split("\\*", -1)).map(Pattern::quote)
            .collect(Collectors.joining(".*"))))
        .toList();
  }

  Optional<LogTime> time(String name) throws UsageException {
    Optional<String> word = value(name);
    return word.isEmpty() ? Optional.empty() : Optional.of(LogTime.of(name, word.get()));
  }

  /** Seconds, such as {@code 0.25} or {@code -3}. */
  Optional<Double> number(String name, double least, double most) throws UsageException {
    Optional<String> word = value(name);
    if (word.isEmpty()) {
      return Optional.empty();
    }
    try {
      double number = Double.parseDouble(word.get());
      if (number >= least && number <= most) {
        return Optional.of(number);
      }
    } catch (NumberFormatException e) {
      // said below
    }
    throw new UsageException(name + " takes a number from " + least + " to " + most + ", not '" + word.get() + "'");
  }

  /** What is left once all options were taken. */
  List<Path> files() throws UsageException {
    for (String word : words) {
      if (word.startsWith("--")) {
        throw new UsageException("log " + verb + " has no option " + word);
      }
    }
    return words.stream().map(Path::of).toList();
  }
}
