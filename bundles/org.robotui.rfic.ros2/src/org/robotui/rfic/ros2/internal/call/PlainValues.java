package org.robotui.rfic.ros2.internal.call;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.robotui.api.port.CallException;
import org.robotui.ros2.parameter.Ros2ParameterValue;

/** Values of parameters as plain Java values and back. */
final class PlainValues {
  private PlainValues() {}

  /** Boolean, Long, Double, String, or a List of these; bytes are whole numbers from 0 to 255. */
  static Object of(Ros2ParameterValue value) {
    return switch (value) {
      case Ros2ParameterValue.Unset unset -> "";
      case Ros2ParameterValue.OfBool flag -> flag.value();
      case Ros2ParameterValue.OfInteger whole -> whole.value();
      case Ros2ParameterValue.OfDouble real -> real.value();
      case Ros2ParameterValue.OfText text -> text.value();
      case Ros2ParameterValue.OfBytes bytes -> bytes(bytes.value().duplicate());
      case Ros2ParameterValue.OfBools flags -> flags.values();
      case Ros2ParameterValue.OfIntegers wholes -> wholes.values();
      case Ros2ParameterValue.OfDoubles reals -> reals.values();
      case Ros2ParameterValue.OfTexts texts -> texts.values();
    };
  }

  private static List<Long> bytes(ByteBuffer buffer) {
    List<Long> all = new ArrayList<>();
    while (buffer.hasRemaining()) {
      all.add((long) Byte.toUnsignedInt(buffer.get()));
    }
    return all;
  }

  /**
   * A new value for a parameter, of the kind that it has: ROS 2 refuses whole numbers for real ones.
   *
   * @throws CallException where it cannot be of that kind
   */
  static Ros2ParameterValue like(Ros2ParameterValue before, String name, Object value) throws CallException {
    return switch (before) {
      case Ros2ParameterValue.OfBool flag -> new Ros2ParameterValue.OfBool(one(name, value, Boolean.class));
      case Ros2ParameterValue.OfInteger whole -> new Ros2ParameterValue.OfInteger(whole(name, value));
      case Ros2ParameterValue.OfDouble real -> new Ros2ParameterValue.OfDouble(
          one(name, value, Number.class).doubleValue());
      case Ros2ParameterValue.OfText text -> new Ros2ParameterValue.OfText(one(name, value, String.class));
      case Ros2ParameterValue.OfBytes bytes -> new Ros2ParameterValue.OfBytes(bytes(name, value));
      case Ros2ParameterValue.OfBools flags -> new Ros2ParameterValue.OfBools(all(name, value, Boolean.class, b -> b));
      case Ros2ParameterValue.OfIntegers wholes -> new Ros2ParameterValue.OfIntegers(wholes(name, value));
      case Ros2ParameterValue.OfDoubles reals -> new Ros2ParameterValue.OfDoubles(
          all(name, value, Number.class, Number::doubleValue));
      case Ros2ParameterValue.OfTexts texts -> new Ros2ParameterValue.OfTexts(all(name, value, String.class, s -> s));
      case Ros2ParameterValue.Unset unset -> throw new CallException("there is no parameter " + name);
    };
  }

  private static <T> T one(String name, Object value, Class<T> kind) throws CallException {
    if (!kind.isInstance(value)) {
      throw new CallException(name + " holds " + (kind == Number.class ? "a number"
          : kind == Boolean.class ? "true or false" : "a text") + ", not " + value);
    }
    return kind.cast(value);
  }

  private static long whole(String name, Object value) throws CallException {
    Number number = one(name, value, Number.class);
    if (number.doubleValue() != Math.rint(number.doubleValue())) {
      throw new CallException(name + " holds a whole number, not " + value);
    }
    return number.longValue();
  }

  private static List<Long> wholes(String name, Object value) throws CallException {
    List<Long> all = new ArrayList<>();
    for (Object each : one(name, value, List.class)) {
      all.add(whole(name, each));
    }
    return all;
  }

  private static ByteBuffer bytes(String name, Object value) throws CallException {
    List<Long> numbers = wholes(name, value);
    ByteBuffer buffer = ByteBuffer.allocate(numbers.size());
    for (long number : numbers) {
      if (number < 0 || number > 255) {
        throw new CallException(name + " holds bytes from 0 to 255, not " + number);
      }
      buffer.put((byte) number);
    }
    return buffer.flip();
  }

  private static <T, U> List<U> all(String name, Object value, Class<T> kind, Function<T, U> function)
      throws CallException {
    List<U> all = new ArrayList<>();
    for (Object each : one(name, value, List.class)) {
      all.add(function.apply(one(name, each, kind)));
    }
    return all;
  }
}
