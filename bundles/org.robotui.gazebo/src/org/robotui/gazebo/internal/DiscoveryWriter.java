package org.robotui.gazebo.internal;

import com.google.protobuf.CodedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;

/** Writes messages of discovery as {@link DiscoveryReader} reads them. */
final class DiscoveryWriter {
  private static final int MOST = 65_535;

  private DiscoveryWriter() {}

  /** Writes the fields of a message. */
  private interface Fields {
    void write(CodedOutputStream out) throws IOException;
  }

  /**
   * Writes a datagram.
   *
   * @throws IllegalArgumentException where it would be too long
   */
  static byte[] write(DiscoveryMessage message) {
    byte[] body = bytes(out -> {
      out.writeUInt32(2, message.version());
      out.writeString(3, message.process());
      out.writeEnum(4, message.kind().ordinal());
      if (message.relayed()) {
        out.writeByteArray(5, bytes(flags -> flags.writeBool(1, true)));
      }
      if (!message.topic().isEmpty()) {
        out.writeByteArray(6, bytes(sub -> sub.writeString(1, message.topic())));
      }
      if (message.subject().isPresent()) {
        out.writeByteArray(7, announcement(message.subject().get()));
      }
    });
    if (body.length + 2 > MOST) {
      throw new IllegalArgumentException("a message of discovery of " + body.length + " bytes fits in no datagram");
    }
    byte[] all = new byte[body.length + 2];
    all[0] = (byte) body.length;
    all[1] = (byte) (body.length >> Byte.SIZE);
    System.arraycopy(body, 0, all, 2, body.length);
    return all;
  }

  private static byte[] announcement(Announcement said) {
    return bytes(out -> {
      out.writeString(1, said.topic());
      out.writeString(2, said.address());
      out.writeString(3, said.process());
      out.writeString(4, said.node());
      out.writeEnum(5, said.scope().ordinal());
      switch (said.ends()) {
        case Ends.Messages(String control, String type) -> out.writeByteArray(6, bytes(ends -> {
          ends.writeString(1, control);
          ends.writeString(2, type);
        }));
        case Ends.Requests(String socket, String request, String response) -> out.writeByteArray(7, bytes(ends -> {
          ends.writeString(1, socket);
          ends.writeString(2, request);
          ends.writeString(3, response);
        }));
        case Ends.Unsaid unsaid -> {}
      }
    });
  }

  private static byte[] bytes(Fields fields) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    CodedOutputStream out = CodedOutputStream.newInstance(all);
    try {
      fields.write(out);
      out.flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e); // bytes in memory are always taken
    }
    return all.toByteArray();
  }
}
