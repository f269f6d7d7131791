package org.robotui.data;

/**
 * A value made of parts with keys, of which the newest per key counts.
 *
 * @param <T> the type itself
 */
public interface Keyed<T extends Keyed<T>> extends Data {
  /**
   * Merges: all parts of this value, and those of the older one whose keys this value lacks.
   *
   * @param older what came before
   * @return a value with the keys of both
   */
  T over(T older);
}
