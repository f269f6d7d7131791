package org.robotui.rtps;

import java.util.List;

/** Whether two ends are in a common partition. Having none is being in the one without a name. */
final class Partitions {

  private Partitions() {}

  static boolean meet(List<String> first, List<String> second) {
    List<String> ours = first.isEmpty() ? List.of("") : first;
    List<String> theirs = second.isEmpty() ? List.of("") : second;
    return ours.stream().anyMatch(one -> theirs.stream().anyMatch(other -> same(one, other)));
  }

  /** Two patterns never meet, by the specification. */
  private static boolean same(String one, String other) {
    if (pattern(one)) {
      return !pattern(other) && glob(one, other);
    }
    return pattern(other) ? glob(other, one) : one.equals(other);
  }

  private static boolean pattern(String name) {
    return name.indexOf('*') >= 0 || name.indexOf('?') >= 0;
  }

  /** Stars are tried by going back to the last one only: a hostile pattern costs no more than its length times ours. */
  private static boolean glob(String pattern, String name) {
    int p = 0;
    int n = 0;
    int star = -1;
    int resume = 0;
    while (n < name.length()) {
      if (p < pattern.length() && pattern.charAt(p) == '*') {
        star = p++;
        resume = n;
      } else if (p < pattern.length() && (pattern.charAt(p) == '?' || pattern.charAt(p) == name.charAt(n))) {
        p++;
        n++;
      } else if (star >= 0) {
        p = star + 1;
        n = ++resume;
      } else {
        return false;
      }
    }
    return pattern.substring(p).chars().allMatch(c -> c == '*');
  }
}
