package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.api.host.Problem;

/** The names for which a template is formed: {@code r1..r50}, {@code [r1, r2]}, or {@code r1..r5, leader}. */
public final class ForNames {
  /** The word of a section that makes it a template. */
  public static final String KEY = "for";
  /** What stands for the name. */
  static final String ROBOT = "${robot}";

  private static final int MOST = 1000;
  private static final Pattern RANGE = Pattern.compile("(.*?)(\\d{1,9})\\s*\\.\\.\\s*(.*?)(\\d{1,9})");
  private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9.]+(e[-+]?[0-9]+)?");
  private static final Pattern DIGITS = Pattern.compile("\\d{1,18}$");

  private final List<Problem> problems;
  private final Set<String> names = new LinkedHashSet<>();
  private boolean wrong;

  ForNames(List<Problem> problems) {
    this.problems = problems;
  }

  /** Whether a text names robots; a number is a setting that happens to have the same word. */
  public static boolean isNames(String text) {
    return text.contains("..") || !NUMBER.matcher(text.strip()).matches();
  }

  /** Adds what one text names. */
  void add(String text, Place place) {
    for (String part : text.split(",", -1)) {
      if (wrong) {
        return; // one mistake is enough, where names stand for so much
      }
      Matcher range = RANGE.matcher(part.strip());
      if (range.matches()) {
        addRange(range, place);
      } else if (part.isBlank() || part.contains("..")) {
        wrong(place, "'" + part.strip() + "' names nobody; write names, or a range such as r1..r50");
      } else {
        addName(part.strip(), place);
      }
    }
  }

  private void addRange(Matcher range, Place place) {
    String prefix = range.group(1);
    int first = Integer.parseInt(range.group(2));
    int last = Integer.parseInt(range.group(4));
    boolean same = range.group(3).isEmpty() || range.group(3).equals(prefix);
    if (!same || last < first || last - first >= MOST) {
      wrong(place,
          "'" + range.group() + "' is no range: write the same name with a smaller and a larger number, at most "
              + MOST + " of them, such as " + prefix + "1.." + prefix + "50");
      return;
    }
    int width = range.group(2).startsWith("0") ? range.group(2).length() : 1;
    for (int i = first; i <= last && !wrong; i++) {
      addName(prefix + ("%0" + width + "d").formatted(i), place);
    }
  }

  private void addName(String name, Place place) {
    if (names.size() >= MOST) {
      wrong(place, "a template is formed for at most " + MOST + " names");
    } else if (!names.add(name)) {
      wrong(place, "'" + name + "' is named twice");
    }
  }

  private void wrong(Place place, String message) {
    if (!wrong) {
      problems.add(place.error(message));
    }
    wrong = true;
  }

  /** What is formed, in the order of the names. */
  List<Formed> formed() {
    List<Formed> formed = new ArrayList<>();
    names.forEach(name -> formed.add(new Formed(name, number(name, formed.size() + 1))));
    return formed;
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
