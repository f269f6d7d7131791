package org.robotui.core.internal.life;

import java.util.function.Predicate;
import java.util.stream.IntStream;

/** Names that nothing has yet. */
final class FreshName {
  private FreshName() {}

  /**
   * The first that is free of a name and of others that are counted from 2.
   *
   * @param first as it would be best
   * @param stem what stands before the number of the others
   * @param isFree whether nothing has a name
   */
  static String of(String first, String stem, Predicate<String> isFree) {
    return IntStream.iterate(1, n -> n + 1).mapToObj(n -> n == 1 ? first : stem + n).filter(isFree).findFirst()
        .orElseThrow();
  }
}
