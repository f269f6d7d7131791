package org.robotui.architecture.tests;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The walks in ARCHITECTURE.md (blocks marked as such) lead through methods that exist, each named by the one that
 * calls it: the nearest above it that stands further to the left. A line that begins with a word is another thread.
 */
final class WalkRule implements Rule {

  private static final String FILE = "ARCHITECTURE.md";
  private static final Pattern WALK = Pattern.compile("^```walk\\n(.*?)^```$", Pattern.DOTALL | Pattern.MULTILINE);
  private static final Pattern STATION = Pattern.compile("^ +(org\\.robotui[.a-z0-9]*) +([A-Z]\\w*)\\.(\\w+)\\b.*$");

  /** A line of a walk: how far to the right it stands, which method it names, and its source where there is one. */
  private record Station(int column, String bundle, String type, String method, Optional<String> source) {
    @Override
    public String toString() {
      return bundle + " " + type + "." + method;
    }

    boolean names(String word) {
      return source.filter(text -> Pattern.compile("\\b" + word + "\\b").matcher(text).find()).isPresent();
    }
  }

  @Override
  public String statement() {
    return "the walks in ARCHITECTURE.md lead through methods that call each other";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return WALK.matcher(repository.read(FILE)).results()
        .flatMap(walk -> violations(repository, walk.group(1).lines().toList()).stream());
  }

  private static List<Violation> violations(Repository repository, List<String> lines) {
    List<Violation> found = new ArrayList<>();
    Deque<Station> callers = new ArrayDeque<>();
    for (String line : lines) {
      Matcher station = STATION.matcher(line);
      if (station.matches()) {
        Station called = station(repository, station);
        while (!callers.isEmpty() && callers.peek().column() >= called.column()) {
          callers.pop();
        }
        problem(Optional.ofNullable(callers.peek()), called).ifPresent(text -> found.add(new Violation(FILE, text)));
        callers.push(called);
      } else if (line.isBlank() || Character.isWhitespace(line.charAt(0))) {
        found.add(new Violation(FILE, "a walk has a line that names no method: '" + line.strip() + "'"));
      } else {
        callers.clear();
      }
    }
    return found;
  }

  private static Station station(Repository repository, Matcher line) {
    Optional<String> source = repository.bundles().stream().filter(bundle -> bundle.name().equals(line.group(1)))
        .flatMap(bundle -> bundle.sources().stream())
        .filter(file -> file.fileName().equals(line.group(2) + ".java")).map(SourceFile::text).findFirst();
    return new Station(line.start(2), line.group(1), line.group(2), line.group(3), source);
  }

  private static Optional<String> problem(Optional<Station> caller, Station called) {
    if (!called.names(called.method())) {
      return Optional.of("a walk leads through " + called + ", which does not exist");
    }
    return caller.filter(above -> !above.names(called.method()))
        .map(above -> "a walk has " + above + " call " + called + ", which it does not");
  }
}
