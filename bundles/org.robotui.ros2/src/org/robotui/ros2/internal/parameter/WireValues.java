package org.robotui.ros2.internal.parameter;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import org.robotui.ros2.internal.msgs.WireDescriptor;
import org.robotui.ros2.internal.msgs.WireFloatRange;
import org.robotui.ros2.internal.msgs.WireIntRange;
import org.robotui.ros2.internal.msgs.WireValue;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterValue;

/** Values and descriptors of parameters as they are on the wire. */
final class WireValues {

  private static final ByteBuffer NO_BYTES = ByteBuffer.allocate(0).asReadOnlyBuffer();

  private WireValues() {}

  static Ros2ParameterValue read(WireValue wire) {
    return switch (wire.type()) {
      case 1 -> new Ros2ParameterValue.OfBool(wire.boolValue());
      case 2 -> new Ros2ParameterValue.OfInteger(wire.integerValue());
      case 3 -> new Ros2ParameterValue.OfDouble(wire.doubleValue());
      case 4 -> new Ros2ParameterValue.OfText(wire.stringValue());
      case 5 -> new Ros2ParameterValue.OfBytes(wire.byteArrayValue());
      case 6 -> new Ros2ParameterValue.OfBools(flags(wire.boolArrayValue()));
      case 7 -> new Ros2ParameterValue.OfIntegers(LongStream.of(wire.integerArrayValue()).boxed().toList());
      case 8 -> new Ros2ParameterValue.OfDoubles(DoubleStream.of(wire.doubleArrayValue()).boxed().toList());
      case 9 -> new Ros2ParameterValue.OfTexts(wire.stringArrayValue());
      default -> new Ros2ParameterValue.Unset();
    };
  }

  private static List<Boolean> flags(ByteBuffer bytes) {
    List<Boolean> flags = new ArrayList<>();
    for (int i = bytes.position(); i < bytes.limit(); i++) {
      flags.add(bytes.get(i) != 0);
    }
    return flags;
  }

  static WireValue write(Ros2ParameterValue value) {
    boolean flag = value instanceof Ros2ParameterValue.OfBool v && v.value();
    long whole = value instanceof Ros2ParameterValue.OfInteger v ? v.value() : 0;
    double real = value instanceof Ros2ParameterValue.OfDouble v ? v.value() : 0;
    String text = value instanceof Ros2ParameterValue.OfText v ? v.value() : "";
    ByteBuffer bytes = value instanceof Ros2ParameterValue.OfBytes v ? v.value().duplicate() : NO_BYTES;
    ByteBuffer flags = value instanceof Ros2ParameterValue.OfBools v ? bytes(v.values()) : NO_BYTES;
    List<Long> wholes = value instanceof Ros2ParameterValue.OfIntegers v ? v.values() : List.of();
    List<Double> reals = value instanceof Ros2ParameterValue.OfDoubles v ? v.values() : List.of();
    List<String> texts = value instanceof Ros2ParameterValue.OfTexts v ? v.values() : List.of();
    return new WireValue(value.type(), flag, whole, real, text, bytes, flags,
        wholes.stream().mapToLong(Long::longValue).toArray(), reals.stream().mapToDouble(Double::doubleValue).toArray(),
        texts);
  }

  private static ByteBuffer bytes(List<Boolean> flags) {
    ByteBuffer bytes = ByteBuffer.allocate(flags.size());
    flags.forEach(flag -> bytes.put((byte) (flag ? 1 : 0)));
    return bytes.flip();
  }

  static Ros2ParameterDescriptor read(WireDescriptor wire) {
    return new Ros2ParameterDescriptor(wire.name(), wire.type(), wire.description(), wire.additionalConstraints(),
        wire.readOnly(), wire.dynamicTyping(),
        wire.floatingPointRange().stream().findFirst()
            .map(r -> new Ros2ParameterDescriptor.DoubleRange(r.fromValue(), r.toValue(), r.step())),
        wire.integerRange().stream().findFirst()
            .map(r -> new Ros2ParameterDescriptor.IntegerRange(r.fromValue(), r.toValue(), r.step())));
  }

  static WireDescriptor write(Ros2ParameterDescriptor known) {
    return new WireDescriptor(known.name(), known.type(), known.description(), known.constraints(), known.readOnly(),
        known.dynamicTyping(),
        list(known.doubles().map(range -> new WireFloatRange(range.from(), range.to(), range.step()))),
        list(known.integers().map(range -> new WireIntRange(range.from(), range.to(), range.step()))));
  }

  private static <T> List<T> list(Optional<T> one) {
    return one.stream().toList();
  }
}
