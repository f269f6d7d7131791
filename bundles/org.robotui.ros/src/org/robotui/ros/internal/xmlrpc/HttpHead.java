package org.robotui.ros.internal.xmlrpc;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** The first line and the header fields of an HTTP message. */
record HttpHead(String firstLine, Map<String, String> fields) {

  private static final int MAX_HEAD = 16 * 1024;

  /** Reads up to the empty line; throws an {@link EOFException} if the peer closed before the first byte. */
  static HttpHead read(InputStream in) throws IOException {
    StringBuilder head = new StringBuilder();
    while (!endsWithEmptyLine(head)) {
      int next = in.read();
      if (next < 0) {
        throw head.isEmpty() ? new EOFException("closed by the peer") : new XmlRpcException("HTTP header cut off");
      }
      if (head.length() >= MAX_HEAD) {
        throw new XmlRpcException("HTTP header longer than " + MAX_HEAD + " bytes");
      }
      head.append((char) next);
    }
    return parse(head.toString().split("\r?\n"));
  }

  private static boolean endsWithEmptyLine(StringBuilder head) {
    int n = head.length();
    return n >= 2 && head.charAt(n - 1) == '\n'
        && (head.charAt(n - 2) == '\n' || n >= 3 && head.charAt(n - 2) == '\r' && head.charAt(n - 3) == '\n');
  }

  private static HttpHead parse(String[] lines) throws XmlRpcException {
    Map<String, String> fields = new HashMap<>();
    for (int i = 1; i < lines.length; i++) {
      int colon = lines[i].indexOf(':');
      if (colon < 1) {
        throw new XmlRpcException("malformed HTTP header line");
      }
      fields.put(lines[i].substring(0, colon).toLowerCase(Locale.ROOT), lines[i].substring(colon + 1).strip());
    }
    return new HttpHead(lines.length == 0 ? "" : lines[0], fields);
  }

  Optional<String> field(String lowerCaseName) {
    return Optional.ofNullable(fields.get(lowerCaseName));
  }

  /** The length of the body; an error if it is missing, no number, or above the limit. */
  int contentLength(int max) throws XmlRpcException {
    String text = field("content-length").orElseThrow(() -> new XmlRpcException("HTTP without Content-Length"));
    if (!text.matches("\\d{1,10}") || Long.parseLong(text) > max) {
      throw new XmlRpcException("HTTP body of '" + text.substring(0, Math.min(20, text.length()))
          + "' bytes, at most " + max + " are accepted");
    }
    return Integer.parseInt(text);
  }

  /** Whether the peer lets the connection stay open after this message. */
  boolean keepsAlive() {
    String connection = field("connection").orElse("").toLowerCase(Locale.ROOT);
    return firstLine.contains("HTTP/1.1") ? !connection.contains("close") : connection.contains("keep-alive");
  }

  static byte[] bytes(String... lines) {
    return (String.join("\r\n", lines) + "\r\n\r\n").getBytes(StandardCharsets.ISO_8859_1);
  }
}
