package org.robotui.urdf.internal.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import org.robotui.urdf.internal.Refusal;

/** Reads STL, which is binary where its size says so, whatever its first word is. */
public final class StlReader {
  private static final int HEADER = 84;
  private static final int TRIANGLE = 50;

  private StlReader() {}

  /** Adds all triangles. */
  public static void read(byte[] bytes, MeshBuilder builder) throws Refusal {
    ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    long declared = bytes.length >= HEADER ? data.getInt(80) & 0xffff_ffffL : 0;
    long needed = HEADER + TRIANGLE * declared;
    boolean text = startsAsText(bytes);
    if (bytes.length >= HEADER && (needed == bytes.length || !text)) {
      if (needed > bytes.length) {
        throw new Refusal(0,
            "a binary STL that declares " + declared + " triangles takes " + needed + " bytes, but the file has "
                + bytes.length + "; it is cut off or broken");
      }
      binary(data, (int) declared, builder);
    } else if (text) {
      ascii(new WordReader(bytes), builder);
    } else {
      throw new Refusal(0, "the file is no STL: it has " + bytes.length + " bytes, and does not begin with 'solid'");
    }
    builder.part(Optional.empty(), Optional.empty());
  }

  private static boolean startsAsText(byte[] bytes) {
    String start = new String(bytes, 0, Math.min(bytes.length, HEADER + TRIANGLE), StandardCharsets.ISO_8859_1);
    return start.stripLeading().regionMatches(true, 0, "solid", 0, 5) && start.indexOf(0) < 0;
  }

  private static void binary(ByteBuffer data, int count, MeshBuilder builder) throws Refusal {
    for (int i = 0; i < count; i++) {
      data.position(HEADER + TRIANGLE * i);
      float[] numbers = new float[12];
      for (int n = 0; n < 12; n++) {
        numbers[n] = data.getFloat();
      }
      triangle(numbers, builder);
    }
  }

  private static void ascii(WordReader words, MeshBuilder builder) throws Refusal {
    words.skipLine();
    float[] numbers = new float[12];
    int filled = 3;
    for (Optional<String> word = words.next(); word.isPresent(); word = words.next()) {
      switch (word.get().toLowerCase(Locale.ROOT)) {
        case "normal" -> three(words, numbers, 0);
        case "vertex" -> {
          if (filled > 9) {
            throw new Refusal(words.line(), "a facet with more than three vertices, must have three");
          }
          three(words, numbers, filled);
          filled += 3;
        }
        case "endfacet" -> {
          if (filled != 12) {
            throw new Refusal(words.line(), "a facet with " + (filled / 3 - 1) + " vertices, must have three");
          }
          triangle(numbers, builder);
          filled = 3;
        }
        case "solid", "endsolid" -> words.skipLine();
        case "facet", "outer", "loop", "endloop" -> {}
        default -> throw new Refusal(words.line(), "'" + word.get() + "' is no word of an ASCII STL");
      }
    }
  }

  private static void three(WordReader words, float[] into, int from) throws Refusal {
    for (int i = 0; i < 3; i++) {
      into[from + i] = words.number();
    }
  }

  private static void triangle(float[] numbers, MeshBuilder builder) throws Refusal {
    int a = builder.corner(numbers[3], numbers[4], numbers[5]);
    int b = builder.corner(numbers[6], numbers[7], numbers[8]);
    int c = builder.corner(numbers[9], numbers[10], numbers[11]);
    for (int corner = a; corner <= c; corner++) {
      builder.normal(corner, numbers[0], numbers[1], numbers[2]);
    }
    builder.flat(a, b, c);
    builder.triangle(a, b, c);
  }
}
