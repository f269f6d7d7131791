package org.robotui.ros.internal.tcpros;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;

/** The fields two TCPROS peers exchange before their first message. */
public record ConnectionHeader(Map<String, String> fields) {

  /** Starts a header that this node sends. */
  public static ConnectionHeader of(String callerId) {
    return new ConnectionHeader(Map.of()).with("callerid", callerId);
  }

  /** The header that tells a peer why it is refused. */
  public static ConnectionHeader error(String callerId, String reason) {
    return of(callerId).with("error", reason);
  }

  public ConnectionHeader with(String name, String value) {
    Map<String, String> more = new LinkedHashMap<>(fields);
    more.put(name, value);
    return new ConnectionHeader(more);
  }

  public ConnectionHeader with(MessageInfo info) {
    return with("type", info.type()).with("md5sum", info.md5()).with("message_definition", info.definition());
  }

  public Optional<String> field(String name) {
    return Optional.ofNullable(fields.get(name));
  }

  public String require(String name) throws ProtocolException {
    return field(name).orElseThrow(() -> new ProtocolException("connection header without field '" + name + "'"));
  }

  public boolean flag(String name) {
    return "1".equals(fields.get(name));
  }

  public MessageInfo messageInfo() throws ProtocolException {
    return new MessageInfo(require("type"), require("md5sum"), field("message_definition").orElse(""));
  }

  /** The header as it travels, with its length in front. */
  public byte[] encode() {
    MessageWriter out = new MessageWriter(1024);
    out.i32(0);
    fields.forEach((name, value) -> out.string(name + "=" + value));
    out.patchI32(0, out.size() - Integer.BYTES);
    return out.toByteArray();
  }

  /**
   * Parses a header without its length. Definitions of old packages are not always UTF-8; they are read as far as they
   * are.
   */
  public static ConnectionHeader decode(byte[] bytes) throws ProtocolException {
    ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    Map<String, String> fields = new LinkedHashMap<>();
    while (in.hasRemaining()) {
      decodeField(in, fields);
    }
    return new ConnectionHeader(fields);
  }

  private static void decodeField(ByteBuffer in, Map<String, String> fields) throws ProtocolException {
    int at = in.position();
    int length = in.remaining() < Integer.BYTES ? -1 : in.getInt();
    if (length < 0 || length > in.remaining()) {
      throw new ProtocolException("connection header: field at byte " + at + " is longer than the header");
    }
    String field = new String(in.array(), in.position(), length, StandardCharsets.UTF_8);
    in.position(in.position() + length);
    int equals = field.indexOf('=');
    if (equals < 1) {
      throw new ProtocolException("connection header: field at byte " + at + " is not name=value");
    }
    if (fields.put(field.substring(0, equals), field.substring(equals + 1)) != null) {
      throw new ProtocolException("connection header: field '" + field.substring(0, equals) + "' comes twice");
    }
  }
}
