package org.robotui.yarp.internal;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.robotui.yarp.bottle.YarpFormatException;

/** Lines of the text carrier and of name servers. */
public final class TextLines {
  public static final String END = "\r\n";
  private static final int LONGEST = 1 << 20;

  private TextLines() {}

  /** The next line without its end; blocks. */
  public static String read(InputStream in) throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    int next = in.read();
    if (next < 0) {
      throw new EOFException("the connection ended");
    }
    while (next >= 0 && next != '\n') {
      if (line.size() >= LONGEST) {
        throw new YarpFormatException("a line of more than " + LONGEST + " bytes");
      }
      line.write(next);
      next = in.read();
    }
    String text = line.toString(StandardCharsets.UTF_8);
    return text.endsWith("\r") ? text.substring(0, text.length() - 1) : text;
  }

  public static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
