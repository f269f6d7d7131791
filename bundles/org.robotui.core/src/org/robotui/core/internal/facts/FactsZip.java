package org.robotui.core.internal.facts;

import java.io.IOException;
import java.io.OutputStream;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.robotui.api.config.WriteFailure;

/** A zip of texts without secrets, each bounded and all together, and a page that says what is in it. */
final class FactsZip {
  /** Of a longer file the end is taken. */
  static final int MOST_OF_ONE = 2 << 20;

  /** Before it is packed. */
  static final int MOST_OF_ALL = 40 << 20;

  private static final String CONTENTS = "CONTENTS.txt";

  private final ZipOutputStream zip;
  private final List<String> contents = new ArrayList<>();
  private long size;

  FactsZip(OutputStream out) {
    this.zip = new ZipOutputStream(out, StandardCharsets.UTF_8);
  }

  /** Adds a text. What is too much is cut at its end, and that is said. */
  void text(String name, String what, String text) throws IOException {
    String masked = SecretMask.masked(text);
    boolean cut = masked.length() > MOST_OF_ONE;
    entry(name, what + (cut ? ", the first " + (MOST_OF_ONE >> 20) + " MB" : ""),
        cut ? masked.substring(0, MOST_OF_ONE) : masked);
  }

  /** Adds a file, or why it cannot be read. */
  void file(String name, String what, Path file) throws IOException {
    try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
      long length = in.length();
      boolean cut = length > MOST_OF_ONE;
      in.seek(cut ? length - MOST_OF_ONE : 0);
      byte[] bytes = new byte[(int) Math.min(length, MOST_OF_ONE)];
      in.readFully(bytes);
      String text = new String(bytes, StandardCharsets.UTF_8);
      // A secret that the cut goes through could not be told: the first line goes with what is before it.
      entry(name, what + (cut ? ", the last " + (MOST_OF_ONE >> 20) + " MB" : ""),
          SecretMask.masked(cut ? text.substring(text.indexOf('\n') + 1) : text));
    } catch (IOException e) {
      contents.add(name + ": not included, as " + file + " cannot be read: " + WriteFailure.reason(e));
    }
  }

  private void entry(String name, String what, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    if (size + bytes.length > MOST_OF_ALL) {
      contents.add(name + ": not included, as all together would be more than " + (MOST_OF_ALL >> 20) + " MB");
      return;
    }
    size += bytes.length;
    contents.add(name + ": " + what);
    put(name, bytes);
  }

  private void put(String name, byte[] bytes) throws IOException {
    zip.putNextEntry(new ZipEntry(name));
    zip.write(bytes);
    zip.closeEntry();
  }

  /**
   * Writes the page, and ends the zip.
   *
   * @param head what the page says before
   * @return what is in the zip, a line each
   */
  List<String> finish(String head) throws IOException {
    put(CONTENTS, (head + "\n" + String.join("\n", contents) + "\n").getBytes(StandardCharsets.UTF_8));
    zip.finish();
    return List.copyOf(contents);
  }
}
