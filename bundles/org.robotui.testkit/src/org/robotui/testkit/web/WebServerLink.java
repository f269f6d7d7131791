package org.robotui.testkit.web;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** The server's end of a link (RFC 6455). Any thread may say something. */
public final class WebServerLink {
  private static final String GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
  private static final int LONGEST = 1 << 24;
  private static final int TEXT = 1;
  private static final int BINARY = 2;
  private static final int CLOSE = 8;
  private static final int PING = 9;
  private static final int PONG = 10;
  private static final int FINAL = 0x80;

  private final DataInputStream in;
  private final OutputStream out;

  private WebServerLink(DataInputStream in, OutputStream out) {
    this.in = in;
    this.out = out;
  }

  /** Takes the request of whoever called, and agrees to the first protocol that is offered. */
  static WebServerLink greeted(Socket socket) throws IOException {
    DataInputStream in = new DataInputStream(socket.getInputStream());
    Map<String, String> headers = headers(in);
    String protocols = headers.getOrDefault("sec-websocket-protocol", "");
    StringBuilder answer = new StringBuilder("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n")
        .append("Connection: Upgrade\r\nSec-WebSocket-Accept: ").append(accept(headers.get("sec-websocket-key")));
    if (!protocols.isEmpty()) {
      answer.append("\r\nSec-WebSocket-Protocol: ").append(protocols.split(",")[0].strip());
    }
    socket.getOutputStream().write(answer.append("\r\n\r\n").toString().getBytes(StandardCharsets.US_ASCII));
    return new WebServerLink(in, socket.getOutputStream());
  }

  private static Map<String, String> headers(DataInputStream in) throws IOException {
    Map<String, String> headers = new HashMap<>();
    for (String line = line(in); !line.isEmpty(); line = line(in)) {
      int colon = line.indexOf(':');
      if (colon > 0) {
        headers.merge(line.substring(0, colon).toLowerCase(Locale.ROOT), line.substring(colon + 1).strip(),
            (a, b) -> a + "," + b);
      }
    }
    return headers;
  }

  private static String line(DataInputStream in) throws IOException {
    StringBuilder line = new StringBuilder();
    for (int c = in.readUnsignedByte(); c != '\n'; c = in.readUnsignedByte()) {
      line.append((char) c);
    }
    return line.toString().strip();
  }

  private static String accept(String key) {
    try {
      byte[] sum = MessageDigest.getInstance("SHA-1").digest((key + GUID).getBytes(StandardCharsets.US_ASCII));
      return Base64.getEncoder().encodeToString(sum);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Hands over what comes until the link ends. */
  void follow(WebCaller caller) throws IOException {
    ByteArrayOutputStream message = new ByteArrayOutputStream();
    int kind = 0;
    while (true) {
      int first = in.readUnsignedByte();
      int opcode = first & 0xf;
      byte[] part = part();
      if (opcode == CLOSE) {
        say(CLOSE, part);
        return;
      } else if (opcode == PING) {
        say(PONG, part);
      } else if (opcode < CLOSE) {
        kind = opcode == 0 ? kind : opcode;
        message.write(part);
        if ((first & FINAL) != 0) {
          deliver(caller, kind, message.toByteArray());
          message.reset();
        }
      }
    }
  }

  private void deliver(WebCaller caller, int kind, byte[] message) {
    if (kind == TEXT) {
      caller.text(this, new String(message, StandardCharsets.UTF_8));
    } else {
      caller.binary(this, ByteBuffer.wrap(message));
    }
  }

  private byte[] part() throws IOException {
    int size = in.readUnsignedByte() & 0x7f;
    long length = size == 126 ? in.readUnsignedShort() : size == 127 ? in.readLong() : size;
    if (length < 0 || length > LONGEST) {
      throw new IOException("a part of " + length + " bytes");
    }
    byte[] mask = in.readNBytes(4);
    byte[] part = in.readNBytes((int) length);
    for (int i = 0; i < part.length; i++) {
      part[i] ^= mask[i % mask.length];
    }
    return part;
  }

  /**
   * Says a text. To one who has gone, nothing is said.
   *
   * @param text the message
   */
  public void say(String text) {
    sayQuietly(TEXT, text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Says bytes. To one who has gone, nothing is said.
   *
   * @param bytes the message
   */
  public void say(byte[] bytes) {
    sayQuietly(BINARY, bytes);
  }

  private void sayQuietly(int opcode, byte[] message) {
    try {
      say(opcode, message);
    } catch (IOException e) {
      // whoever called has gone
    }
  }

  private synchronized void say(int opcode, byte[] message) throws IOException {
    ByteBuffer head = ByteBuffer.allocate(10).put((byte) (FINAL | opcode));
    if (message.length < 126) {
      head.put((byte) message.length);
    } else if (message.length < 1 << 16) {
      head.put((byte) 126).putShort((short) message.length);
    } else {
      head.put((byte) 127).putLong(message.length);
    }
    out.write(head.array(), 0, head.position());
    out.write(message);
    out.flush();
  }
}
