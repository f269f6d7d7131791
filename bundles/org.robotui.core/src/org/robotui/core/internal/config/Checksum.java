package org.robotui.core.internal.config;

import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;

/** Tells texts apart by a few characters: in names of files, and where it is kept what a text was. */
public final class Checksum {
  private Checksum() {}

  /** The CRC-32 of a text in UTF-8, as a hexadecimal number. */
  public static String of(String text) {
    CRC32 sum = new CRC32();
    sum.update(text.getBytes(StandardCharsets.UTF_8));
    return Long.toHexString(sum.getValue());
  }
}
