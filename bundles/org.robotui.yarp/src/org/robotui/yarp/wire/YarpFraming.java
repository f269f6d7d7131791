package org.robotui.yarp.wire;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import org.robotui.yarp.bottle.YarpFormatException;

/** Headers, messages and acknowledgements as bytes. */
public final class YarpFraming {

  /** Bytes of an acknowledgement, and of the answer to a header. */
  public static final int MARK = 8;
  /** Bytes that follow a header by mcast: four of the group's address, two of its port. */
  public static final int GROUP = 6;
  /** The longest message that is taken. */
  public static final int LONGEST = 1 << 26;
  /** Where a name server listens unless it is told otherwise. */
  public static final int NAME_SERVER_PORT = 10_000;

  private static final int MAGIC_BEGIN = 0x4159;
  private static final int MAGIC_END = 0x5052;
  private static final int INDEX = 10;
  private static final int LONGEST_NAME = 1 << 12;
  private static final int LONGEST_COMMAND = 1 << 16;
  private static final int FILL = 8;
  private static final int BYTE = 0xff;
  private static final int SHORT = 0xffff;
  private static final int COMMAND_MARK = '~';
  private static final int COMMAND_END = 1;

  private YarpFraming() {}

  /**
   * Who connects.
   *
   * @param carrier by which
   * @param name of its port, or any word
   */
  public record Header(YarpCarrier carrier, String name) {}

  /**
   * Reads what a port says first that connects; blocks.
   *
   * @param in of the connection, from its first byte
   * @return who it is
   * @throws YarpFormatException where it is no header, or one of another carrier
   * @throws IOException where the connection ends
   */
  public static Header readHeader(InputStream in) throws IOException {
    int specifier = readMark(in);
    YarpCarrier carrier = YarpCarrier.of(specifier).orElseThrow(() -> new YarpFormatException(
        "the carrier with the number 0x" + Integer.toHexString(specifier)
            + " is not spoken; tcp, fast_tcp, udp and mcast are"));
    int length = int32(in);
    if (length < 1 || length > LONGEST_NAME) {
      throw new YarpFormatException("a name of " + length + " bytes; at most " + LONGEST_NAME + " are taken");
    }
    byte[] name = exactly(in, length);
    return new Header(carrier, new String(name, 0, length - 1, StandardCharsets.UTF_8));
  }

  /**
   * What a port says first that connects.
   *
   * @param header who it is
   * @return the bytes
   */
  public static byte[] bytes(Header header) {
    byte[] name = header.name().getBytes(StandardCharsets.UTF_8);
    return little(MARK + Integer.BYTES + name.length + 1).put(mark(header.carrier().specifier()))
        .putInt(name.length + 1).put(name).put((byte) 0).array();
  }

  /**
   * Eight bytes around a number: an acknowledgement (0), or the answer to a header (any port).
   *
   * @param number between the marks
   * @return the bytes
   */
  public static byte[] mark(int number) {
    return little(MARK).putShort((short) MAGIC_BEGIN).putInt(number).putShort((short) MAGIC_END).array();
  }

  /**
   * Reads such eight bytes; blocks.
   *
   * @param in of a connection
   * @return the number between the marks
   * @throws YarpFormatException where they are something else
   * @throws IOException where the connection ends
   */
  public static int readMark(InputStream in) throws IOException {
    return readMark(int32(in), in);
  }

  /**
   * Reads the rest of such eight bytes; blocks.
   *
   * @param first the first four, as a number
   * @param in of a connection
   * @return the number between the marks
   * @throws IOException as {@link #readMark(InputStream)}
   */
  public static int readMark(int first, InputStream in) throws IOException {
    ByteBuffer rest = ByteBuffer.wrap(exactly(in, MARK - Integer.BYTES)).order(ByteOrder.LITTLE_ENDIAN);
    int high = rest.getShort() & SHORT;
    if (!isMark(first) || (rest.getShort() & SHORT) != MAGIC_END) {
      throw new YarpFormatException("what came is none of YARP's headers, which begin with YA and end with RP");
    }
    return first >>> Short.SIZE | high << Short.SIZE;
  }

  /**
   * Whether four bytes begin a mark. A bottle never begins so.
   *
   * @param first as a number
   * @return else a bottle follows
   */
  public static boolean isMark(int first) {
    return (first & SHORT) == MAGIC_BEGIN;
  }

  /**
   * Reads four bytes as a number; blocks.
   *
   * @param in of a connection
   * @return little endian
   * @throws IOException where the connection ends
   */
  public static int int32(InputStream in) throws IOException {
    return ByteBuffer.wrap(exactly(in, Integer.BYTES)).order(ByteOrder.LITTLE_ENDIAN).getInt();
  }

  /**
   * Reads the next message; blocks until all of it is there.
   *
   * @param in of a connection, after its header
   * @return the message
   * @throws EOFException where the connection ends, also within a message
   * @throws YarpFormatException where the bytes are no message
   * @throws IOException where the connection breaks
   */
  public static YarpMessage read(InputStream in) throws IOException {
    Index index = index(in);
    List<Integer> blocks = index.blocks();
    int reply = index.replies() == 0 ? 0 : int32(in);
    int whole = blocks.stream().mapToInt(Integer::intValue).sum();
    return split(exactly(in, whole), blocks, reply);
  }

  /**
   * How many bytes a message has.
   *
   * @param begun its first bytes
   * @return empty while they are too few to tell
   * @throws YarpFormatException where they begin no message, or one that is too long
   */
  public static OptionalInt length(byte[] begun) throws YarpFormatException {
    int lengths = MARK + INDEX;
    if (begun.length < lengths) {
      return OptionalInt.empty();
    }
    int head = lengths + ((begun[MARK] & BYTE) + (begun[MARK + 1] & BYTE)) * Integer.BYTES;
    if (begun.length < head) {
      return OptionalInt.empty();
    }
    try {
      ByteArrayInputStream in = new ByteArrayInputStream(begun);
      return OptionalInt.of(head + index(in).blocks().stream().mapToInt(Integer::intValue).sum());
    } catch (YarpFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new YarpFormatException("an index that ends early");
    }
  }

  private record Index(List<Integer> blocks, int replies) {}

  private static Index index(InputStream in) throws IOException {
    int number = readMark(in);
    if (number != INDEX) {
      throw new YarpFormatException("an index of " + number + " bytes; those of YARP have " + INDEX);
    }
    byte[] index = exactly(in, INDEX);
    int replies = index[1] & BYTE;
    if (replies > 1) {
      throw new YarpFormatException("an index announces " + replies + " replies; there is one at most");
    }
    return new Index(lengths(in, index[0] & BYTE), replies);
  }

  private static List<Integer> lengths(InputStream in, int count) throws IOException {
    List<Integer> blocks = new ArrayList<>();
    long whole = 0;
    for (int i = 0; i < count; i++) {
      int length = int32(in);
      whole += length;
      if (length < 0 || whole > LONGEST) {
        throw new YarpFormatException("a message of more than " + LONGEST + " bytes, or a block of " + length);
      }
      blocks.add(length);
    }
    return blocks;
  }

  private static YarpMessage split(byte[] whole, List<Integer> blocks, int reply) throws YarpFormatException {
    if (whole.length < YarpMessage.COMMAND) {
      throw new YarpFormatException("a message of " + whole.length + " bytes; its command alone has eight");
    }
    ByteBuffer in = ByteBuffer.wrap(whole).order(ByteOrder.LITTLE_ENDIAN);
    int length = in.getInt();
    int mark = in.get();
    int key = in.get() & BYTE;
    boolean ends = in.get() == 0 && in.get() == COMMAND_END;
    boolean plain = key != 0;
    if (mark != COMMAND_MARK || !ends || length < 0 || length > Math.min(in.remaining(), LONGEST_COMMAND)
        || plain == length > 0) {
      throw new YarpFormatException("a message does not begin with a command to a port");
    }
    String command =
        plain ? String.valueOf((char) key) : new String(whole, YarpMessage.COMMAND, length - 1, StandardCharsets.UTF_8);
    return new YarpMessage(command, Arrays.copyOfRange(whole, YarpMessage.COMMAND + length, whole.length), blocks,
        reply);
  }

  /**
   * Writes a message.
   *
   * @param message to be sent
   * @return all of its bytes
   */
  public static byte[] bytes(YarpMessage message) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(mark(INDEX));
    out.write(message.blocks().size());
    out.write(1);
    for (int i = 0; i < FILL; i++) {
      out.write(BYTE);
    }
    ByteBuffer lengths = little((message.blocks().size() + 1) * Integer.BYTES);
    message.blocks().forEach(lengths::putInt);
    out.writeBytes(lengths.putInt(message.replyLength()).array());
    boolean plain = message.command().length() == 1 && !message.command().equals("q");
    byte[] text = plain ? new byte[0] : (message.command() + "\0").getBytes(StandardCharsets.UTF_8);
    out.writeBytes(little(YarpMessage.COMMAND).putInt(text.length).put((byte) COMMAND_MARK)
        .put((byte) (plain ? message.command().charAt(0) : 0)).put((byte) 0).put((byte) COMMAND_END).array());
    out.writeBytes(text);
    out.writeBytes(message.data());
    return out.toByteArray();
  }

  private static ByteBuffer little(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** What is not there yet is not allocated: a stream gives its bytes in pieces. */
  private static byte[] exactly(InputStream in, int length) throws IOException {
    byte[] bytes = in.readNBytes(length);
    if (bytes.length < length) {
      throw new EOFException("the connection ended");
    }
    return bytes;
  }
}
