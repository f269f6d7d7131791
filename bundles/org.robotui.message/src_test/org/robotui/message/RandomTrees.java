package org.robotui.message;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.random.RandomGenerator;

/** Makes Java values for any message type. */
final class RandomTrees {

  private static final String LETTERS = "abc/ _0äß€𝄞";

  private final RandomGenerator random;

  RandomTrees(RandomGenerator random) {
    this.random = random;
  }

  Map<String, Object> tree(Layout layout) {
    Map<String, Object> tree = new LinkedHashMap<>();
    layout.fields().forEach(f -> tree.put(f.name(), f.type().isArray() ? list(f) : value(f)));
    return tree;
  }

  private List<Object> list(Layout.Field field) {
    int length = field.type().arity() == FieldType.Arity.FIXED ? field.type().length() : random.nextInt(4);
    List<Object> values = new ArrayList<>();
    for (int i = 0; i < length; i++) {
      values.add(value(field));
    }
    return values;
  }

  private Object value(Layout.Field field) {
    return field.nested() != null ? tree(field.nested()) : scalar(field.primitive());
  }

  private Object scalar(Primitive type) {
    return switch (type) {
      case BOOL -> random.nextBoolean();
      case FLOAT32 -> (float) number();
      case FLOAT64 -> number();
      case STRING, WSTRING -> text();
      case INT64 -> random.nextLong();
      case UINT64 -> new BigInteger(64, new Random(random.nextLong()));
      case TIME -> Stamps.time(random.nextInt(), random.nextInt(1_000_000_000));
      case DURATION -> Stamps.duration(random.nextInt(), random.nextInt(1_000_000_000));
      case INT8, BYTE, INT16, INT32 -> signed(type);
      case UINT8, CHAR, UINT16, UINT32 -> random.nextLong() & ((1L << 8 * type.size()) - 1);
    };
  }

  private double number() {
    return switch (random.nextInt(10)) {
      case 0 -> Double.NaN;
      case 1 -> Double.NEGATIVE_INFINITY;
      default -> random.nextGaussian();
    };
  }

  private long signed(Primitive type) {
    return random.nextLong() >> (64 - 8 * type.size());
  }

  private String text() {
    StringBuilder text = new StringBuilder();
    random.ints(random.nextInt(6), 0, LETTERS.codePointCount(0, LETTERS.length()))
        .map(i -> LETTERS.codePointAt(LETTERS.offsetByCodePoints(0, i)))
        .forEach(text::appendCodePoint);
    return text.toString();
  }
}
