package org.robotui.data;

/**
 * A value made of parts with keys, of which the newest per key counts. Merged values hold {@link #most()} keys at most:
 * where keys come without end, those that came first go, unless the newest value has them; they are back with their
 * next value.
 *
 * @param <T> the type itself
 */
public interface Keyed<T extends Keyed<T>> extends Data {
  /** How many keys a merged value holds, if no single value has more. */
  int MOST_KEYS = 4_096;

  /**
   * Merges: all parts of this value, and those of the older one whose keys this value lacks.
   *
   * @param older what came before
   * @return a value with the keys of both
   */
  T over(T older);

  /**
   * How many parts there are.
   *
   * @return the number of keys
   */
  int keys();

  /**
   * How many keys a merged value of this type may hold.
   *
   * @return the bound
   */
  default int most() {
    return MOST_KEYS;
  }

  /**
   * The value without the parts that came first.
   *
   * @param most how many parts are kept at most, not negative
   * @return a value with so many of the last parts
   */
  T last(int most);
}
