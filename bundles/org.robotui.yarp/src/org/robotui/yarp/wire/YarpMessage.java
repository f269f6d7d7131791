package org.robotui.yarp.wire;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A message of the carriers tcp and fast_tcp.
 *
 * @param command {@code d} for data, {@code D} and an envelope for data with one, {@code q} for the end
 * @param data what is said, a bottle mostly; not to be changed
 * @param blocks how many bytes the pieces have in which it is written, command and data together
 * @param replyLength what its index says of a reply
 */
public record YarpMessage(String command, byte[] data, List<Integer> blocks, int replyLength) {
  /** Of a command, before its text. */
  static final int COMMAND = 8;
  static final String DATA = "d";
  private static final String ENVELOPE = "D ";

  /** With a list of its own. */
  public YarpMessage {
    blocks = List.copyOf(blocks);
  }

  /**
   * Data without an envelope: a command or a question.
   *
   * @param data its bytes
   * @return the message
   */
  public static YarpMessage of(byte[] data) {
    return new YarpMessage(DATA, data, List.of(COMMAND, data.length), 0);
  }

  /**
   * Data with an envelope.
   *
   * @param stamp the envelope
   * @param data its bytes
   * @return the message
   */
  public static YarpMessage of(YarpStamp stamp, byte[] data) {
    return with(ENVELOPE + stamp, data);
  }

  /**
   * The end of a connection.
   *
   * @return the message
   */
  public static YarpMessage quit() {
    return with("q", new byte[0]);
  }

  private static YarpMessage with(String command, byte[] data) {
    int first = COMMAND + command.getBytes(StandardCharsets.UTF_8).length + 1;
    return new YarpMessage(command, data, data.length == 0 ? List.of(first) : List.of(first, data.length), 0);
  }

  /**
   * Whether it holds data.
   *
   * @return false for commands to the port itself
   */
  public boolean isData() {
    return command.equals(DATA) || command.startsWith("D");
  }

  /**
   * Its envelope.
   *
   * @return empty where it has none
   */
  public Optional<YarpStamp> stamp() {
    return command.startsWith(ENVELOPE) ? YarpStamp.parse(command.substring(ENVELOPE.length())) : Optional.empty();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof YarpMessage m && command.equals(m.command) && Arrays.equals(data, m.data)
        && blocks.equals(m.blocks) && replyLength == m.replyLength;
  }

  @Override
  public int hashCode() {
    return 31 * command.hashCode() + Arrays.hashCode(data);
  }
}
