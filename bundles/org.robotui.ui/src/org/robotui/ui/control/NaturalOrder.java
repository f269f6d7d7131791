package org.robotui.ui.control;

import java.util.Comparator;

/** The order in which people put names with numbers: {@code arm_2} before {@code arm_10}. */
public final class NaturalOrder {
  /** By numbers where both have one, else by letters in either case; consistent with equality. */
  public static final Comparator<String> ORDER =
      ((Comparator<String>) NaturalOrder::compare).thenComparing(Comparator.naturalOrder());

  private NaturalOrder() {}

  private static int compare(String one, String other) {
    int i = 0;
    int j = 0;
    while (i < one.length() && j < other.length()) {
      int endI = run(one, i);
      int endJ = run(other, j);
      int order = part(one.substring(i, endI), other.substring(j, endJ));
      if (order != 0) {
        return order;
      }
      i = endI;
      j = endJ;
    }
    return Integer.compare(one.length() - i, other.length() - j);
  }

  /** Where the run of digits, or of anything else, ends that begins somewhere. */
  private static int run(String text, int from) {
    boolean digits = digit(text.charAt(from));
    int end = from + 1;
    while (end < text.length() && digit(text.charAt(end)) == digits) {
      end++;
    }
    return end;
  }

  private static int part(String one, String other) {
    if (!digit(one.charAt(0)) || !digit(other.charAt(0))) {
      return one.compareToIgnoreCase(other);
    }
    String first = one.replaceFirst("^0+(?=.)", "");
    String second = other.replaceFirst("^0+(?=.)", "");
    return first.length() != second.length() ? Integer.compare(first.length(), second.length())
        : first.compareTo(second);
  }

  private static boolean digit(char c) {
    return c >= '0' && c <= '9';
  }
}
