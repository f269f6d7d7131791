package org.robotui.data;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Optional;

/**
 * How a data type is named and delivered.
 *
 * @param type the Java type
 * @param conflation what becomes of values not yet taken
 * @param late what late consumers get
 * @param expires whether an old value is stale
 */
public record DataType(Class<? extends Data> type, Conflation conflation, Late late, boolean expires) {
  /**
   * Reads the declaration of a type, or of the nearest type that it extends; without any: sample, last, expiring.
   *
   * @param type a data type
   * @return its description
   */
  public static DataType of(Class<? extends Data> type) {
    return declared(type)
        .map(d -> new DataType(type, d.conflation(), d.late(), d.expires()))
        .orElse(new DataType(type, Conflation.SAMPLE, Late.LAST, true));
  }

  /**
   * The name that users read and write, for example {@code LaserScan}.
   *
   * @return the simple name of the type
   */
  public String name() {
    return type.getSimpleName();
  }

  /**
   * Tells whether a consumer of this type can take values of another type.
   *
   * @param produced what a producer offers
   * @return true where it is this type or extends it
   */
  public boolean accepts(DataType produced) {
    return type.isAssignableFrom(produced.type);
  }

  private static Optional<Delivery> declared(Class<?> type) {
    Deque<Class<?>> open = new ArrayDeque<>();
    open.add(type);
    while (!open.isEmpty()) {
      Class<?> next = open.poll();
      Delivery found = next.getAnnotation(Delivery.class);
      if (found != null) {
        return Optional.of(found);
      }
      Optional.ofNullable(next.getSuperclass()).ifPresent(open::add);
      open.addAll(Arrays.asList(next.getInterfaces()));
    }
    return Optional.empty();
  }
}
