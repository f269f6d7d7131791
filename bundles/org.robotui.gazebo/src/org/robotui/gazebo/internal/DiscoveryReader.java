package org.robotui.gazebo.internal;

import com.google.protobuf.CodedInputStream;
import com.google.protobuf.WireFormat;
import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;
import org.robotui.gazebo.internal.DiscoveryMessage.Kind;
import org.robotui.gazebo.internal.DiscoveryMessage.Scope;

/** Reads messages of discovery: a length of two bytes, the lower first, and a message of Protocol Buffers. */
final class DiscoveryReader {
  private static final int LENGTH = 2;

  private final CodedInputStream in;

  private DiscoveryReader(CodedInputStream in) {
    this.in = in;
  }

  /**
   * Reads a datagram.
   *
   * @param bytes hold it at their begin
   * @param size of the datagram
   * @throws IOException where it is no message of discovery
   */
  static DiscoveryMessage read(byte[] bytes, int size) throws IOException {
    if (size < LENGTH) {
      throw new IOException("a datagram of " + size + " bytes has no length in it");
    }
    int said = Byte.toUnsignedInt(bytes[0]) | Byte.toUnsignedInt(bytes[1]) << Byte.SIZE;
    if (said != size - LENGTH) {
      throw new IOException("a datagram says that " + said + " bytes follow, but " + (size - LENGTH) + " do");
    }
    return new DiscoveryReader(CodedInputStream.newInstance(bytes, LENGTH, said)).message();
  }

  /** Takes one field. */
  private interface Field {
    void take(int number) throws IOException;
  }

  private void fields(Field field) throws IOException {
    for (int tag = in.readTag(); tag != 0; tag = in.readTag()) {
      boolean known = WireFormat.getTagWireType(tag) == WireFormat.WIRETYPE_LENGTH_DELIMITED
          || WireFormat.getTagWireType(tag) == WireFormat.WIRETYPE_VARINT;
      if (!known) {
        in.skipField(tag);
        continue;
      }
      int before = in.getTotalBytesRead();
      field.take(WireFormat.getTagWireType(tag) == WireFormat.WIRETYPE_VARINT ? -WireFormat.getTagFieldNumber(tag)
          : WireFormat.getTagFieldNumber(tag));
      if (in.getTotalBytesRead() == before) {
        in.skipField(tag);
      }
    }
  }

  private void inner(Field field) throws IOException {
    int limit = in.pushLimit(in.readRawVarint32());
    fields(field);
    in.popLimit(limit);
  }

  private DiscoveryMessage message() throws IOException {
    Message read = new Message();
    fields(number -> {
      switch (number) {
        case -2 -> read.version = in.readUInt32();
        case 3 -> read.process = in.readStringRequireUtf8();
        case -4 -> read.kind = one(Kind.values(), in.readEnum());
        case 5 -> inner(flag -> {
          if (flag == -1) {
            read.relayed = in.readBool();
          }
        });
        case 6 -> inner(part -> {
          if (part == 1) {
            read.topic = in.readStringRequireUtf8();
          }
        });
        case 7 -> read.subject = Optional.of(announcement());
        default -> {}
      }
    });
    return new DiscoveryMessage(read.version, read.process, read.kind, read.topic, read.subject, read.relayed);
  }

  private Announcement announcement() throws IOException {
    String[] texts = {"", "", "", "", ""};
    Scope[] scope = {Scope.PROCESS};
    Ends[] ends = {new Ends.Unsaid()};
    inner(number -> {
      switch (number) {
        case 1, 2, 3, 4 -> texts[number] = in.readStringRequireUtf8();
        case -5 -> scope[0] = one(Scope.values(), in.readEnum());
        case 6 -> {
          String[] said = texts(2);
          ends[0] = new Ends.Messages(said[0], said[1]);
        }
        case 7 -> {
          String[] said = texts(3);
          ends[0] = new Ends.Requests(said[0], said[1], said[2]);
        }
        default -> {}
      }
    });
    return new Announcement(texts[1], texts[2], texts[3], texts[4], scope[0], ends[0]);
  }

  /** The first fields of a message, which are texts. */
  private String[] texts(int count) throws IOException {
    String[] texts = new String[count];
    Arrays.fill(texts, "");
    inner(number -> {
      if (number > 0 && number <= count) {
        texts[number - 1] = in.readStringRequireUtf8();
      }
    });
    return texts;
  }

  /** A word by its number; the last one where there is none. */
  private static <E> E one(E[] words, int number) {
    return words[number >= 0 && number < words.length ? number : words.length - 1];
  }

  /** While it is read. */
  private static final class Message {
    private int version;
    private String process = "";
    private Kind kind = Kind.NOTHING;
    private String topic = "";
    private Optional<Announcement> subject = Optional.empty();
    private boolean relayed;
  }
}
