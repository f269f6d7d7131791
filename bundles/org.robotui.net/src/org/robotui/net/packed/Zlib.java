package org.robotui.net.packed;

import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** What zlib has packed. */
public final class Zlib {
  private Zlib() {}

  /**
   * Unpacks as many bytes as there shall be; what follows them is left out.
   *
   * @param packed with the header of zlib
   * @param expected how many bytes there shall be; whoever calls has bounded it
   * @return so many bytes
   * @throws IllegalArgumentException where they are not packed by zlib, or are fewer; says so
   */
  public static byte[] inflate(byte[] packed, int expected) {
    byte[] plain = new byte[expected];
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(packed);
      int size = 0;
      int got = 1;
      while (size < expected && got > 0) {
        got = inflater.inflate(plain, size, expected - size);
        size += got;
      }
      if (size < expected) {
        throw new IllegalArgumentException("the packed bytes are " + size + " of " + expected);
      }
      return plain;
    } catch (DataFormatException e) {
      throw new IllegalArgumentException("the bytes are not packed by zlib: " + e.getMessage(), e);
    } finally {
      inflater.end();
    }
  }
}
