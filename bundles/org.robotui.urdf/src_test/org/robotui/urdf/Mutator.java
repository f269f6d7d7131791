package org.robotui.urdf;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Breaks texts and bytes as files break, and as people who mean harm break them. */
public final class Mutator {
  private static final List<String> NASTY =
      List.of("-1", "4294967295", "1e999", "NaN", "", "<", ">", "\"", "]]>", "&x;", "\u0000", "../../",
          "99999999999999999999", "<link name=\"base\"/>", "#v", "0 0 0", "<!DOCTYPE a>");

  private Mutator() {}

  /** Some changes of bytes. */
  public static byte[] bytes(byte[] sample, Random random) {
    byte[] broken = sample.clone();
    for (int changes = 1 + random.nextInt(4); changes > 0; changes--) {
      broken = once(broken, random);
    }
    return broken;
  }

  /** Some changes of a text. */
  public static String text(String sample, Random random) {
    return new String(bytes(sample.getBytes(StandardCharsets.UTF_8), random), StandardCharsets.UTF_8);
  }

  private static byte[] once(byte[] sample, Random random) {
    int at = random.nextInt(sample.length + 1);
    int length = random.nextInt(Math.min(40, sample.length - at + 1));
    return switch (random.nextInt(6)) {
      case 0 -> joined(sample, 0, at, new byte[0], sample.length);
      case 1 -> joined(sample, 0, at, new byte[]{(byte) random.nextInt(256)}, Math.min(sample.length, at + 1));
      case 2 -> joined(sample, 0, at, NASTY.get(random.nextInt(NASTY.size())).getBytes(StandardCharsets.UTF_8),
          at + length);
      case 3 -> joined(sample, 0, at, new byte[0], at + length);
      case 4 -> joined(sample, 0, at, Arrays.copyOfRange(sample, at, at + length), at);
      default -> joined(sample, 0, at, Arrays.copyOfRange(sample, Math.max(0, at - 100), at), at);
    };
  }

  private static byte[] joined(byte[] sample, int from, int to, byte[] between, int rest) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(sample, from, to - from);
    out.writeBytes(between);
    out.write(sample, rest, sample.length - rest);
    return out.toByteArray();
  }
}
