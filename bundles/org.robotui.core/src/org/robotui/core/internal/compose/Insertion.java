package org.robotui.core.internal.compose;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Adds a RUIC to the text of a configuration and leaves every character of it as it is, but for empty braces in place
 * of the RUICs.
 *
 * @param whole the new text
 * @param added what is new in it, with whole lines
 * @param line where that begins, from 1
 */
record Insertion(String whole, String added, int line) {
  private static final String SECTION = "ruics:";
  private static final String HEAD =
      "# Written by New Robot UI from what the robot offered; docs/configuration.md explains every word.";
  private static final Pattern EMPTY = Pattern.compile("\\{\\s*}");
  private static final int USUAL_INDENT = 2;

  /** A text of its own. */
  static Insertion alone(List<String> ruic) {
    List<String> lines = new ArrayList<>(List.of(HEAD, SECTION));
    ruic.forEach(l -> lines.add(indented(l, USUAL_INDENT)));
    String text = String.join("\n", lines) + "\n";
    return new Insertion(text, text, 1);
  }

  /** At the end of the RUICs of a text, or in place of empty braces; nothing where they stand in braces. */
  static Optional<Insertion> into(String text, List<String> ruic) {
    String end = text.contains("\r\n") ? "\r\n" : "\n";
    List<String> lines = text.isEmpty() ? List.of() : List.of(text.split("\r?\n", -1));
    int section = section(lines);
    if (section < 0) {
      return Optional.of(insert(lines, contentEnd(lines, lines.size()), block(ruic, USUAL_INDENT, true), end));
    }
    if (EMPTY.matcher(rest(lines.get(section))).matches()) {
      return Optional.of(filled(lines, section, block(ruic, USUAL_INDENT, false), end));
    }
    if (!rest(lines.get(section)).isEmpty()) {
      return Optional.empty();
    }
    int after = next(lines, section + 1);
    List<String> body = lines.subList(section + 1, after);
    if (body.stream().filter(Insertion::isContent).findFirst().filter(l -> l.stripLeading().startsWith("{"))
        .isPresent()) {
      return Optional.empty();
    }
    int indent = body.stream().filter(Insertion::isContent).findFirst().map(Insertion::indent).orElse(USUAL_INDENT);
    return Optional.of(insert(lines, contentEnd(lines, after), block(ruic, indent, false), end));
  }

  /** Where the RUICs of a text begin, from 1. */
  static int sectionLine(String text) {
    return section(text.lines().toList()) + 1;
  }

  /** The braces go, and with them only the blanks before them: what stands behind them is a comment. */
  private static Insertion filled(List<String> lines, int section, List<String> block, String end) {
    List<String> opened = new ArrayList<>(lines);
    opened.set(section, lines.get(section).replaceFirst("\\s*\\{\\s*}", ""));
    return insert(opened, section + 1, block, end);
  }

  private static List<String> block(List<String> ruic, int indent, boolean withSection) {
    List<String> block = new ArrayList<>(withSection ? List.of(SECTION) : List.of());
    ruic.forEach(l -> block.add(indented(l, indent)));
    return block;
  }

  private static Insertion insert(List<String> lines, int at, List<String> block, String end) {
    List<String> all = new ArrayList<>(lines.subList(0, at));
    all.addAll(block);
    List<String> tail = lines.subList(at, lines.size());
    all.addAll(tail.isEmpty() ? List.of("") : tail);
    return new Insertion(String.join(end, all), block.stream().map(l -> l + end).collect(Collectors.joining()), at + 1);
  }

  private static int section(List<String> lines) {
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i).startsWith(SECTION)) {
        return i;
      }
    }
    return -1;
  }

  /** What stands behind the word in its line, but for a comment. */
  private static String rest(String line) {
    return line.substring(SECTION.length()).replaceFirst("(^|\\s)#.*", "").strip();
  }

  /** The first line that does not belong to the section: the next word at the left, or the end. */
  private static int next(List<String> lines, int from) {
    int at = from;
    while (at < lines.size() && (!isContent(lines.get(at)) || indent(lines.get(at)) > 0)) {
      at++;
    }
    return at;
  }

  /**
   * Behind the last line before another one that says something; comments at the left belong to what follows, indented
   * ones do not.
   */
  private static int contentEnd(List<String> lines, int before) {
    int at = before;
    while (at > 0 && !isContent(lines.get(at - 1)) && (indent(lines.get(at - 1)) == 0 || lines.get(at - 1).isBlank())) {
      at--;
    }
    boolean wholeText = before == lines.size();
    return wholeText ? Math.max(at, lastNonBlank(lines)) : at;
  }

  /** In a text without anything behind, also a comment at the left stays above. */
  private static int lastNonBlank(List<String> lines) {
    int at = lines.size();
    while (at > 0 && lines.get(at - 1).isBlank()) {
      at--;
    }
    return at;
  }

  private static boolean isContent(String line) {
    return !line.isBlank() && !line.stripLeading().startsWith("#");
  }

  private static int indent(String line) {
    return line.length() - line.stripLeading().length();
  }

  private static String indented(String line, int indent) {
    return " ".repeat(indent) + line;
  }
}
