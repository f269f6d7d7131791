package org.robotui.yarp.wire;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import org.robotui.yarp.bottle.YarpFormatException;

/**
 * The carrier mjpeg: who wants pictures asks for them as a browser does, and gets parts that are JPEG files, one after
 * another. Envelopes are comments in the files.
 */
public final class MjpegFraming {
  /** The longest picture that is taken, in bytes. */
  public static final int LONGEST = 1 << 25;

  private static final String BOUNDARY = "--boundarydonotcross";
  private static final String LENGTH = "content-length:";
  private static final String TYPE = "content-type:";
  private static final int LONGEST_LINE = 1 << 12;
  private static final int MOST_LINES = 64;
  private static final int MARKER = 0xff;
  private static final int START = 0xd8;
  private static final int SCAN = 0xda;
  private static final int COMMENT = 0xfe;
  private static final int SEGMENT = 4;
  private static final int BYTE = 0xff;

  private MjpegFraming() {}

  /**
   * How pictures are asked for.
   *
   * @param host name or address of the port that has them
   * @return the bytes
   */
  public static byte[] request(String host) {
    return ("GET /?action=stream\n\n HTTP/1.1\nHost: " + host + "\r\n\n").getBytes(StandardCharsets.US_ASCII);
  }

  /**
   * What a port answers that has pictures, before the first one.
   *
   * @return the bytes
   */
  public static byte[] answer() {
    return ("HTTP/1.0 200 OK\r\nConnection: close\r\nContent-Type: multipart/x-mixed-replace;boundary="
        + BOUNDARY.substring(2) + "\r\n\r\n" + BOUNDARY + "\r\n").getBytes(StandardCharsets.US_ASCII);
  }

  /**
   * A picture as a part.
   *
   * @param jpeg the file
   * @return the bytes
   */
  public static byte[] part(byte[] jpeg) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(("Content-Type: image/jpeg\r\nContent-Length: " + jpeg.length + "\r\n\r\n")
        .getBytes(StandardCharsets.US_ASCII));
    out.writeBytes(jpeg);
    out.writeBytes(("\r\n" + BOUNDARY + "\r\n").getBytes(StandardCharsets.US_ASCII));
    return out.toByteArray();
  }

  /**
   * Reads what is answered before the first picture; blocks.
   *
   * @param in of a connection, after the request
   * @throws YarpFormatException where no pictures are promised
   * @throws IOException where the connection ends
   */
  public static void readAnswer(InputStream in) throws IOException {
    String status = line(in);
    if (!status.startsWith("HTTP/") || !status.contains(" 200")) {
      throw new YarpFormatException("no pictures are said by mjpeg there; what came begins with '"
          + status.substring(0, Math.min(status.length(), MOST_LINES)) + "'");
    }
    rest(in, "");
  }

  /**
   * Waits for the next part; blocks.
   *
   * @param in of a connection, after the answer
   * @return its first line
   * @throws YarpFormatException where something else comes
   * @throws IOException where the connection ends
   */
  public static String awaitPart(InputStream in) throws IOException {
    String first = line(in);
    for (int i = 0; first.isEmpty() || first.startsWith("-"); i++) {
      if (i >= MOST_LINES) {
        throw new YarpFormatException("more than " + MOST_LINES + " lines without a picture");
      }
      first = line(in);
    }
    return first;
  }

  /**
   * Reads a part; blocks.
   *
   * @param first line of it
   * @param in of a connection, after that line
   * @return a JPEG file, as it came
   * @throws YarpFormatException where the part is none
   * @throws IOException where the connection ends
   */
  public static byte[] readPart(String first, InputStream in) throws IOException {
    String head = rest(in, first.toLowerCase(Locale.ROOT) + "\n");
    if (!value(head, TYPE).startsWith("image/jpeg")) {
      throw new YarpFormatException("a part that is no JPEG file, but '" + value(head, TYPE) + "'");
    }
    String length = value(head, LENGTH);
    if (!length.matches("\\d{1,9}") || Integer.parseInt(length) < SEGMENT || Integer.parseInt(length) > LONGEST) {
      throw new YarpFormatException("a picture of '" + length + "' bytes; " + SEGMENT + " to " + LONGEST
          + " are taken");
    }
    byte[] jpeg = in.readNBytes(Integer.parseInt(length));
    if (jpeg.length < Integer.parseInt(length)) {
      throw new EOFException("the connection ended within a picture");
    }
    if ((jpeg[0] & BYTE) != MARKER || (jpeg[1] & BYTE) != START) {
      throw new YarpFormatException("a picture that does not begin as JPEG files do");
    }
    return jpeg;
  }

  private static String rest(InputStream in, String first) throws IOException {
    StringBuilder head = new StringBuilder(first);
    String line = line(in);
    for (int i = 0; !line.isEmpty(); i++) {
      if (i >= MOST_LINES) {
        throw new YarpFormatException("a head of more than " + MOST_LINES + " lines");
      }
      head.append(line.toLowerCase(Locale.ROOT)).append('\n');
      line = line(in);
    }
    return head.toString();
  }

  private static String value(String head, String name) {
    return head.lines().filter(line -> line.startsWith(name)).findFirst()
        .map(line -> line.substring(name.length()).strip()).orElse("");
  }

  private static String line(InputStream in) throws IOException {
    StringBuilder line = new StringBuilder();
    for (int next = in.read(); next != '\n'; next = in.read()) {
      if (next < 0) {
        throw new EOFException("the connection ended");
      }
      if (line.length() >= LONGEST_LINE) {
        throw new YarpFormatException("a line of more than " + LONGEST_LINE + " bytes");
      }
      line.append((char) next);
    }
    return line.toString().strip();
  }

  /**
   * The envelope of a picture.
   *
   * @param jpeg a JPEG file, which may be damaged
   * @return empty where none of its comments is one
   */
  public static Optional<YarpStamp> stamp(byte[] jpeg) {
    int at = 2;
    while (at + SEGMENT <= jpeg.length && (jpeg[at] & BYTE) == MARKER && (jpeg[at + 1] & BYTE) != SCAN) {
      int length = (jpeg[at + 2] & BYTE) << Byte.SIZE | jpeg[at + 3] & BYTE;
      int end = at + 2 + length;
      if (length < 2 || end > jpeg.length) {
        return Optional.empty();
      }
      if ((jpeg[at + 1] & BYTE) == COMMENT) {
        String text = new String(jpeg, at + SEGMENT, length - 2, StandardCharsets.US_ASCII).replace('\0', ' ');
        Optional<YarpStamp> stamp = YarpStamp.parse(text);
        if (stamp.isPresent()) {
          return stamp;
        }
      }
      at = end;
    }
    return Optional.empty();
  }
}
