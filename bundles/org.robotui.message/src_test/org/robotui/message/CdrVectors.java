package org.robotui.message;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;

/** The same messages in ROS 1 and in CDR of both byte orders, as an independent implementation writes them. */
final class CdrVectors {

  /** One message. */
  record Vector(String type, Optional<byte[]> ros1, byte[] little, byte[] big) {

    @Override
    public String toString() {
      return type;
    }
  }

  private CdrVectors() {}

  static List<Vector> all() {
    try (InputStream in = CdrVectors.class.getResourceAsStream("cdr_vectors.txt")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().filter(line -> !line.startsWith("#"))
          .map(line -> vector(line.split(" "))).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Vector vector(String[] parts) {
    HexFormat hex = HexFormat.of();
    Optional<byte[]> ros1 =
        parts[1].equals("-") ? Optional.empty() : Optional.of(hex.parseHex(parts[1].equals(".") ? "" : parts[1]));
    return new Vector(parts[0], ros1, hex.parseHex(parts[2]), hex.parseHex(parts[3]));
  }

  static byte[] array(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.remaining()];
    buffer.duplicate().get(bytes);
    return bytes;
  }
}
