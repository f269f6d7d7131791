package org.robotui.api.script;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/**
 * A script.
 *
 * @param name what errors call it, for example the name of its file
 * @param text what it says
 */
public record ScriptSource(String name, String text) {
  private static final int MOST_BYTES = 1 << 20;

  /**
   * Reads a script from a file, in UTF-8.
   *
   * @param file of at most 1 MiB
   * @return the script, named as the file
   * @throws IOException where that cannot be done, with a sentence for users
   */
  public static ScriptSource read(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(MOST_BYTES + 1);
      if (bytes.length > MOST_BYTES) {
        throw new IOException(file + " is no script: it has more than " + MOST_BYTES + " bytes");
      }
      return new ScriptSource(String.valueOf(file.getFileName()),
          StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString());
    } catch (CharacterCodingException e) {
      throw new IOException(file + " is no script: it is not written in UTF-8");
    } catch (NoSuchFileException e) {
      throw new IOException("the script " + file + " is not there", e);
    } catch (AccessDeniedException e) {
      throw new IOException("the script " + file + " may not be read: permission denied", e);
    } catch (FileSystemException e) {
      throw new IOException("the script " + file + " cannot be read: " + e);
    }
  }
}
