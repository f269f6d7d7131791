package org.robotui.architecture.tests;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * One simple name for one class, as far as it goes: libraries of several frameworks speak of the same things. What
 * stands today is the most that may stand; whoever takes a name away lowers the number.
 */
final class SharedNameRule implements Rule {

  /** As many names may stand for more than one class: ROS 1 and ROS 2 are two libraries with the words of one. */
  static final int MOST_NAMES = 225;

  /** As many classes may have the same name. */
  static final int MOST_CLASSES = 5;

  @Override
  public String statement() {
    return "a simple name stands for one class, but for " + MOST_NAMES + " names, and never for more than "
        + MOST_CLASSES;
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    Map<String, List<String>> shared = new TreeMap<>(repository.bundles().stream()
        .flatMap(bundle -> bundle.sources().stream())
        .map(SourceFile::where)
        .filter(where -> !where.endsWith("package-info.java"))
        .collect(Collectors.groupingBy(SharedNameRule::simpleName)));
    shared.values().removeIf(places -> places.size() < 2);
    Stream<Violation> crowded = shared.entrySet().stream().filter(name -> name.getValue().size() > MOST_CLASSES)
        .map(name -> new Violation(name.getKey(),
            "names " + name.getValue().size() + " classes: " + String.join(", ", name.getValue())));
    return shared.size() <= MOST_NAMES ? crowded
        : Stream.concat(crowded, Stream
            .of(new Violation("bundles", shared.size() + " names stand for more than one class: " + shared.keySet())));
  }

  private static String simpleName(String where) {
    return where.substring(where.lastIndexOf('/') + 1, where.length() - ".java".length());
  }
}
