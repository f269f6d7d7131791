package org.robotui.core.internal.config;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.api.host.Problem;

/** The names for which a template is formed: {@code r1..r50}, {@code [r1, r2]}, or {@code r1..r5, leader}. */
final class ForNames {
  /** The word of a section that makes it a template. */
  static final String KEY = "for";
  /** What stands for the name. */
  static final String ROBOT = "${robot}";

  private static final int MOST = 1000;
  private static final Pattern RANGE = Pattern.compile("(.*?)(\\d{1,9})\\s*\\.\\.\\s*(.*?)(\\d{1,9})");
  private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9.]+(e[-+]?[0-9]+)?");
  private static final Pattern DIGITS = Pattern.compile("\\d{1,18}$");

  private final List<Problem> problems;
  private final Set<String> names = new LinkedHashSet<>();

  ForNames(List<Problem> problems) {
    this.problems = problems;
  }

  /** Whether a text names robots; a number is a setting that happens to have the same word. */
  static boolean isNames(String text) {
    return text.contains("..") || !NUMBER.matcher(text.strip()).matches();
  }

  /** Adds what one text names. */
  void add(String text, Place place) {
    for (String part : text.split(",", -1)) {
      Matcher range = RANGE.matcher(part.strip());
      if (range.matches()) {
        addRange(range, place);
      } else if (part.isBlank() || part.contains("..")) {
        problems.add(place.error("'" + part.strip() + "' names nobody; write names, or a range such as r1..r50"));
      } else {
        add(part.strip(), true, place);
      }
    }
  }

  private void addRange(Matcher range, Place place) {
    String prefix = range.group(1);
    int first = Integer.parseInt(range.group(2));
    int last = Integer.parseInt(range.group(4));
    boolean same = range.group(3).isEmpty() || range.group(3).equals(prefix);
    if (!same || last < first || last - first >= MOST) {
      problems.add(place.error("'" + range.group() + "' is no range: write the same name with a smaller and a larger number, at most "
          + MOST + " of them, such as " + prefix + "1.." + prefix + "50"));
      return;
    }
    int width = range.group(2).startsWith("0") ? range.group(2).length() : 1;
    for (int i = first; i <= last; i++) {
      add(prefix + ("%0" + width + "d").formatted(i), false, place);
    }
  }

  private void add(String name, boolean alone, Place place) {
    if (names.size() >= MOST) {
      if (alone) {
        problems.add(place.error("a template is formed for at most " + MOST + " names"));
      }
    } else if (!names.add(name)) {
      problems.add(place.error("'" + name + "' is named twice"));
    }
  }

  /** What is formed, in the order of the names. */
  List<Formed> formed() {
    List<String> all = List.copyOf(names);
    return all.stream().map(name -> new Formed(name, number(name, all.indexOf(name) + 1))).toList();
  }

  private static String number(String name, int place) {
    Matcher digits = DIGITS.matcher(name);
    return Long.toString(digits.find() ? Long.parseLong(digits.group()) : place);
  }

  /**
   * For whom a template is formed.
   *
   * @param robot the name, empty outside of templates
   * @param number the digits at the end of the name; where it has none, its place in the list, from 1
   */
  record Formed(String robot, String number) {
    /** Not within a template. */
    static final Formed NONE = new Formed("", "");

    /** What {@code ${robot}} and {@code ${number}} stand for. */
    Map<String, String> words() {
      return robot.isEmpty() ? Map.of() : Map.of("robot", robot, "number", number);
    }
  }
}
