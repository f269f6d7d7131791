package org.robotui.message.lcm;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * A message whose type nobody has told us.
 *
 * @param fingerprint of its type, as 16 hexadecimal digits; empty where the message is too short for one
 * @param bytes the whole message
 * @param remedy what to do to read it
 */
public record UnknownMessage(String fingerprint, Bytes bytes, String remedy) implements DynamicRecord {
  /**
   * A message of a type that is not known.
   *
   * @param message all of it
   * @param remedy what to do to read it
   * @return its bytes as a record
   */
  public static UnknownMessage of(ByteBuffer message, String remedy) {
    return new UnknownMessage(fingerprint(message), Bytes.wrap(message), remedy);
  }

  /**
   * The number that a message begins with, in words.
   *
   * @param message all of it
   * @return empty where it is too short for one
   */
  public static String fingerprint(ByteBuffer message) {
    return message.remaining() < Long.BYTES ? ""
        : "0x" + HexFormat.of().toHexDigits(message.slice().order(ByteOrder.BIG_ENDIAN).getLong(0));
  }

  @Override
  public String schema() {
    return fingerprint.isEmpty() ? "bytes" : "unknown " + fingerprint;
  }

  @Override
  public List<String> fields() {
    return List.of("size", "fingerprint", "remedy", "bytes");
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return switch (name) {
      case "size" -> Optional.of(new FieldValue.Num(bytes.size(), Integer.toString(bytes.size())));
      case "fingerprint" -> Optional.of(new FieldValue.Text(fingerprint));
      case "remedy" -> Optional.of(new FieldValue.Text(remedy));
      case "bytes" -> Optional.of(new FieldValue.Numbers(numbers()));
      default -> Optional.empty();
    };
  }

  private Doubles numbers() {
    double[] numbers = new double[bytes.size()];
    var from = bytes.buffer(ByteOrder.BIG_ENDIAN);
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = from.get(i) & 0xff;
    }
    return Doubles.wrap(numbers);
  }
}
