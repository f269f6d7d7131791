package org.robotui.testkit.values;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;

/**
 * Spoils values as broken and hostile programs do: numbers that are none, that are huge or negative, lists and arrays
 * of the wrong size, long and odd texts, frames that are not there. A record says by an
 * {@link IllegalArgumentException} that it cannot be so: then nobody ever gets it. The same seed spoils the same values
 * in the same way. For one thread.
 */
public final class Spoiler {
  private static final double[] NUMBERS =
      {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 0, -0.0, -1, 1e-320, 1e-9, 1e12, 1e300, -1e300,
          Double.MAX_VALUE};
  private static final int[] WHOLE = {-1, 0, 1, 3, 7, 255, 65_536, 1 << 28, Integer.MAX_VALUE, Integer.MIN_VALUE};
  private static final int LONG_TEXT = 1 << 20;
  private static final int MANY = 20_000;

  private final SplittableRandom random;

  /**
   * A spoiler that has done nothing yet.
   *
   * @param seed decides what it does
   */
  public Spoiler(long seed) {
    random = new SplittableRandom(seed);
  }

  /**
   * Spoils a value once.
   *
   * @param <T> its type
   * @param value a record, or what records consist of
   * @return the value with something in it that is wrong; the same one where it could not be so
   */
  public <T> T spoil(T value) {
    try {
      @SuppressWarnings("unchecked") // a value is spoiled into one of its class
      T spoiled = (T) other(value);
      return spoiled;
    } catch (IllegalArgumentException e) {
      return value;
    }
  }

  private Object other(Object value) {
    return switch (value) {
      case Double d -> NUMBERS[random.nextInt(NUMBERS.length)];
      case Float f -> (float) NUMBERS[random.nextInt(NUMBERS.length)];
      case Integer i -> WHOLE[random.nextInt(WHOLE.length)];
      case Long l -> random.nextBoolean() ? random.nextLong() : (long) WHOLE[random.nextInt(WHOLE.length)];
      case Boolean b -> !b;
      case String s -> text(s);
      case Enum<?> e -> e.getDeclaringClass().getEnumConstants()[random
          .nextInt(e.getDeclaringClass().getEnumConstants().length)];
      case Optional<?> o -> o.isPresent() && random.nextBoolean() ? Optional.of(other(o.get())) : Optional.empty();
      case List<?> l -> list(l);
      case Map<?, ?> m -> map(m);
      case Floats f -> floats(f);
      case Doubles d -> doubles(d);
      case Bytes b -> bytes(b);
      case ByteOrder o -> o.equals(ByteOrder.BIG_ENDIAN) ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
      case Record r -> record(r);
      default -> value;
    };
  }

  private Object record(Record record) {
    RecordComponent[] components = record.getClass().getRecordComponents();
    Object[] values = new Object[components.length];
    Class<?>[] types = new Class<?>[components.length];
    try {
      for (int i = 0; i < components.length; i++) {
        components[i].getAccessor().setAccessible(true);
        values[i] = components[i].getAccessor().invoke(record);
        types[i] = components[i].getType();
      }
      if (values.length > 0) {
        int chosen = random.nextInt(values.length);
        values[chosen] = other(values[chosen]);
      }
      Constructor<?> maker = record.getClass().getDeclaredConstructor(types);
      maker.setAccessible(true);
      return maker.newInstance(values);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof IllegalArgumentException refused) {
        throw refused;
      }
      throw new AssertionError(record.getClass() + " does not refuse as it should: " + Arrays.toString(values),
          e.getCause());
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(record.getClass().toString(), e);
    }
  }

  private String text(String text) {
    return switch (random.nextInt(6)) {
      case 0 -> "";
      case 1 -> "x".repeat(LONG_TEXT);
      case 2 -> "../../etc/passwd\u0000\n";
      case 3 -> "\ud800\ufffe\u202e\u0301";
      case 4 -> text + text;
      default -> "nowhere";
    };
  }

  private List<?> list(List<?> list) {
    List<Object> next = new ArrayList<>(list);
    if (next.isEmpty()) {
      return next;
    }
    int at = random.nextInt(next.size());
    switch (random.nextInt(6)) {
      case 0 -> next.remove(at);
      case 1 -> next.add(next.get(at));
      case 2 -> next.addAll(Collections.nCopies(MANY, next.get(at)));
      case 3 -> next.clear();
      default -> next.set(at, other(next.get(at)));
    }
    return next;
  }

  private Map<?, ?> map(Map<?, ?> map) {
    Map<Object, Object> next = new LinkedHashMap<>();
    int chosen = map.isEmpty() ? 0 : random.nextInt(map.size());
    for (Map.Entry<?, ?> entry : map.entrySet()) {
      boolean here = next.size() == chosen;
      next.put(here && random.nextBoolean() ? other(entry.getKey()) : entry.getKey(),
          here ? other(entry.getValue()) : entry.getValue());
    }
    return next;
  }

  private Floats floats(Floats floats) {
    float[] values = new float[size(floats.size())];
    for (int i = 0; i < Math.min(values.length, floats.size()); i++) {
      values[i] = floats.get(i);
    }
    if (values.length > 0) {
      values[random.nextInt(values.length)] = (float) NUMBERS[random.nextInt(NUMBERS.length)];
    }
    return Floats.wrap(values);
  }

  private Doubles doubles(Doubles doubles) {
    double[] values = new double[size(doubles.size())];
    for (int i = 0; i < Math.min(values.length, doubles.size()); i++) {
      values[i] = doubles.get(i);
    }
    if (values.length > 0) {
      values[random.nextInt(values.length)] = NUMBERS[random.nextInt(NUMBERS.length)];
    }
    return Doubles.wrap(values);
  }

  private Bytes bytes(Bytes bytes) {
    byte[] values = new byte[bytes.size()];
    bytes.buffer(ByteOrder.LITTLE_ENDIAN).get(values);
    byte[] next = Arrays.copyOf(values, size(values.length));
    if (next.length >= Double.BYTES) {
      ByteBuffer into =
          ByteBuffer.wrap(next).order(random.nextBoolean() ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
      int at = random.nextInt(next.length - Double.BYTES + 1);
      if (random.nextBoolean()) {
        into.putFloat(at / Float.BYTES * Float.BYTES, (float) NUMBERS[random.nextInt(NUMBERS.length)]);
      } else {
        into.putInt(at, WHOLE[random.nextInt(WHOLE.length)]);
      }
    }
    return Bytes.wrap(next, 0, next.length);
  }

  private int size(int before) {
    return switch (random.nextInt(5)) {
      case 0 -> random.nextInt(before + 1);
      case 1 -> before + 1 + random.nextInt(5);
      default -> before;
    };
  }
}
