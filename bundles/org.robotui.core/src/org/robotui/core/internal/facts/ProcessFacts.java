package org.robotui.core.internal.facts;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * What there is to know of this process, as it is now. Needs no thread but that which asks. Safe for all threads.
 *
 * @param configurations the files that it has loaded
 * @param robots how its robots are doing, a line each
 * @param bundles the bundles and their states, a line each
 */
public record ProcessFacts(Supplier<List<Path>> configurations, Supplier<List<String>> robots,
    Supplier<List<String>> bundles) {
  private static final String CONFIGURATION = "configuration ";

  /** All of it, section by section. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add("process " + ProcessHandle.current().pid());
    configurations.get().forEach(file -> lines.add(CONFIGURATION + file.toAbsolutePath()));
    section("Java", JavaFacts.lines(), lines);
    section("Memory", JavaFacts.memory(), lines);
    section("Robots", robots.get(), lines);
    section("Bundles", bundles.get(), lines);
    section("Threads", ThreadFacts.lines(), lines);
    return lines;
  }

  /** Which configurations a process has said to have loaded. */
  static List<Path> configurationsOf(String text) {
    return text.lines().takeWhile(line -> !line.isEmpty()).filter(line -> line.startsWith(CONFIGURATION))
        .map(line -> Path.of(line.substring(CONFIGURATION.length()))).toList();
  }

  private static void section(String title, List<String> section, List<String> lines) {
    lines.add("");
    lines.add("== " + title + " ==");
    lines.addAll(section);
  }
}
