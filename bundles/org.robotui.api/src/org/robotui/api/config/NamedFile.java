package org.robotui.api.config;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/**
 * Reads files that users name. Only regular files are read, and only as much as was agreed on, so that a wrong name
 * costs neither memory nor time; errors are sentences for users, behind the name of the file, and tell nothing of what
 * is in it.
 */
public final class NamedFile {
  private NamedFile() {}

  /**
   * Reads a file.
   *
   * @param file which
   * @param most the most bytes that it may have
   * @return its content
   * @throws IOException where it is not there, no regular file, too large or cannot be read; the message says which,
   * without its name
   */
  public static byte[] bytes(Path file, long most) throws IOException {
    try {
      if (Files.isDirectory(file)) {
        throw new IOException("is a folder; name a file");
      }
      if (Files.exists(file) && !Files.isRegularFile(file)) {
        throw new IOException("is a device or a pipe; name a file");
      }
      return read(file, most);
    } catch (NoSuchFileException e) {
      throw new IOException("is not there", e);
    } catch (AccessDeniedException e) {
      throw new IOException("may not be read: permission denied", e);
    }
  }

  private static byte[] read(Path file, long most) throws IOException {
    long size = Files.size(file);
    if (size > most) {
      throw new IOException("has " + size + " bytes; at most " + most + " are read");
    }
    try (InputStream in = Files.newInputStream(file)) {
      byte[] content = in.readNBytes((int) Math.min(most, Integer.MAX_VALUE - 8) + 1);
      if (content.length > most) { // it grew, or is one of those whose size nobody tells
        throw new IOException("has more than the " + most + " bytes that are read");
      }
      return content;
    }
  }

  /**
   * Reads a text.
   *
   * @param file which
   * @param most the most bytes that it may have
   * @return all of it
   * @throws IOException as {@link #bytes}, and where it is no text in UTF-8
   */
  public static String text(Path file, long most) throws IOException {
    byte[] content = bytes(file, most);
    for (byte each : content) {
      if (each == 0) {
        throw new IOException("is no text");
      }
    }
    try {
      return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(content)).toString();
    } catch (CharacterCodingException e) {
      throw new IOException("is no text in UTF-8", e);
    }
  }
}
